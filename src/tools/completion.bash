# Completes programs, scenes, keys and options of lattice_impact after `rosrun lattice_impact` and
# after a program's own name. The setup.bash of the devel space sources it.
[[ $- == *i* ]] || return 0

# The first of these folders on the workspaces' path.
_lattice_impact_folder() {
  local prefix
  local IFS=:
  for prefix in $CMAKE_PREFIX_PATH /usr; do
    [ -d "$prefix/$1" ] && echo "$prefix/$1" && return
  done
}

# _lattice_impact_complete PROGRAM WORD… — the last word is the one to complete.
_lattice_impact_complete() {
  if [[ ${1##*/} == submit ]]; then
    local number
    for ((number = 2; number < $#; ++number)); do
      # What is submitted has words of its own.
      [[ ${!number} == sweep || ${!number} == reproduce ]] || continue
      _lattice_impact_complete "${@:number}"
      return
    done
  fi
  local program=$1 scene=$2 word=${*: -1} folder words
  program=$(_lattice_impact_folder lib/lattice_impact)/${program##*/}
  COMPREPLY=()
  [ -x "$program" ] || return
  if [[ $word == -* ]]; then
    words=$("$program" --help 2> /dev/null | grep -oE -- '--[a-z][a-z_-]*' | sort -u)
  elif [[ $program == */submit ]]; then
    words="sweep reproduce"
  elif [[ $program == */units ]]; then
    words=$("$program" --help | sed -n 's/^  \([a-z_]*\).*  (.*/\1=/p')
  elif [[ $program == */impact || $program == */sweep || $program == */to_lammps ]] && [ $# = 2 ]; then
    folder=$(_lattice_impact_folder share/lattice_impact/launch/scenes)
    words=$(basename -a -s .yaml "$folder"/*.yaml)
    compopt -o default
  elif [[ $program == */impact || $program == */sweep || $program == */to_lammps ]]; then
    words=$("${program%/*}/impact" "$scene" --keys 2> /dev/null |
            sed -n 's/^  \([a-zA-Z_.0-9]*\) = .*/\1=/p')
  fi
  COMPREPLY=($(compgen -W "$words" -- "$word"))
  [[ ${COMPREPLY[0]} == *= ]] && compopt -o nospace
  [ ${#COMPREPLY[@]} -gt 0 ] || compopt -o default
} 2> /dev/null

_lattice_impact() { _lattice_impact_complete "${COMP_WORDS[@]:0:COMP_CWORD+1}"; }

_lattice_impact_rosrun() {
  if [ "${COMP_WORDS[1]}" = lattice_impact ] && [ "$COMP_CWORD" -gt 2 ]; then
    _lattice_impact_complete "${COMP_WORDS[@]:2:COMP_CWORD-1}"
  elif declare -F _roscomplete_exe > /dev/null; then
    _roscomplete_exe
  fi
}

# rosbash completes package and program.
[ ! -r /usr/share/bash-completion/completions/rosrun ] || . /usr/share/bash-completion/completions/rosrun
complete -F _lattice_impact_rosrun rosrun
# Other packages have a convert and units too.
complete -F _lattice_impact impact sweep reproduce work_precision stability accuracy_check \
  analyse_bag plot_figures plot_impact plot_sweep submit to_lammps from_lammps

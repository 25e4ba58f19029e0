"""Writes a recorded run for other programs: lammps (OVITO, LAMMPS), xyz (OVITO, ASE), vtk
(ParaView), npz (NumPy)."""

from pathlib import Path

from .program import InputError, Parser, beside, check_folder_of, run

SUFFIXES = {"lammps": ".lammpstrj", "xyz": ".xyz", "vtk": ".pvd", "npz": ".npz"}


def main():
    """The program convert."""
    parser = Parser("convert", description=__doc__)
    parser.add_argument("recording", type=Path, metavar="DIR|BAG",
                        help="folder of impact --output --states, or bag")
    parser.add_argument("format", choices=SUFFIXES)
    parser.add_argument("--output", type=Path, metavar="FILE",
                        help="without it: beside the input, with the ending of the format")
    parser.add_argument("--run", type=int, metavar="K",
                        help="of the series in a bag, from 0; without it the last one")
    run(parser, perform)


def perform(arguments):
    """Writes what the command line asks for."""
    suffix = SUFFIXES[arguments.format]
    path = arguments.output or beside(arguments.recording, suffix)
    if path.suffix != suffix:
        raise InputError(f"--output {path}: a file of this format ends in {suffix}")
    check_folder_of(path)
    # pylint: disable=import-outside-toplevel
    from .formats import WRITERS
    from .recording import open_recording

    recording = open_recording(arguments.recording, arguments.run)
    recording.check_states()
    WRITERS[arguments.format](recording, path)
    print(path)

"""Draws one run: compression, wall force, velocity of the centre of mass and energies over time;
and films it."""

import shutil
from pathlib import Path

from .program import InputError, PICTURES, Parser, beside, check_folder_of, check_picture, run


def main():
    """The program plot_impact."""
    parser = Parser("plot_impact", description=__doc__)
    parser.add_argument("recording", type=Path, metavar="DIR|BAG",
                        help="folder of impact --output, or bag")
    parser.add_argument("--output", type=Path, metavar="FILE",
                        help=f"picture, {', '.join(PICTURES)}; without it and without a display: "
                        "a .png beside the input")
    parser.add_argument("--animate", type=Path, metavar="FILE",
                        help="film, .mp4 (needs ffmpeg) or .gif; of a folder: of impact --states")
    parser.add_argument("--run", type=int, metavar="K",
                        help="of the series in a bag, from 0; without it the last one")
    run(parser, perform)


def perform(arguments):
    """Draws what the command line asks for."""
    check_picture(arguments.output)
    if arguments.animate is not None:
        check_film(arguments.animate)
    # matplotlib, which takes its time, comes when all has been checked.
    # pylint: disable=import-outside-toplevel
    from .recording import open_recording

    recording = open_recording(arguments.recording, arguments.run)
    if arguments.animate is not None:
        recording.check_states()
    from . import course, film, style

    shown = style.choose_window(arguments.output is None and arguments.animate is None)
    if arguments.animate is not None:
        film.write_film(recording, arguments.animate)
        print(arguments.animate)
        if arguments.output is None:
            return
    figure = course.draw_course(recording.history(), course.title_of(recording))
    if shown:
        style.plt.show()
        return
    path = arguments.output or beside(arguments.recording, ".png")
    style.save(figure, path)
    print(path)


def check_film(path):
    """@throw InputError when there is no way to write such a film here."""
    if path.suffix not in (".mp4", ".gif"):
        raise InputError(f"--animate {path}: a film ends in .mp4 or .gif")
    if path.suffix == ".mp4" and shutil.which("ffmpeg") is None:
        raise InputError(f"--animate {path}: ffmpeg is missing; install the package ffmpeg, or ask "
                         "for a .gif")
    check_folder_of(path)

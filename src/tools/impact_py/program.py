"""How every program here ends: 0 done, 2 bad input, 1 failed; an error is one line."""

import argparse
import contextlib
import difflib
import os
import sys
from pathlib import Path
from xml.etree import ElementTree


class InputError(Exception):
    """What was given cannot be used; the text is one line with the cause."""


class Parser(argparse.ArgumentParser):
    """Refuses a command line in one line, as the other programs do."""

    def __init__(self, *arguments, **options):
        super().__init__(*arguments, **options)
        self.add_argument("--version", action="version", version=f"%(prog)s {version()}")

    def error(self, message):
        self.exit(2, f"{self.prog}: {message}{self._suggestion(message)} (--help tells more)\n")

    def _suggestion(self, message):
        words = message.partition("unrecognized arguments: ")[2].split()
        options = [name for action in self._actions for name in action.option_strings]
        near = [name for word in words if word.startswith("--")
                for name in difflib.get_close_matches(word.partition("=")[0], options, 1)]
        return f" (did you mean {near[0]}?)" if near else ""


def version():
    """That of package.xml, which lies in the source or in the share of an installed tree."""
    root = Path(__file__).resolve().parents[3]
    manifests = [root / "package.xml", root / "share" / "lattice_impact" / "package.xml"]
    manifest = next(path for path in manifests if path.exists())
    return ElementTree.parse(manifest).findtext("version")


def run(parser, body):
    """Parses the command line, calls body(arguments) and leaves the program."""
    arguments = parser.parse_args()
    try:
        body(arguments)
        sys.stdout.flush()
    except InputError as error:
        parser.exit(2, f"{parser.prog}: {error}\n")
    except ImportError as error:
        parser.exit(1, f"{parser.prog}: {missing_package(error)}\n")
    except BrokenPipeError:
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        parser.exit(1)
    except OSError as error:
        name = f"{error.filename}: " if error.filename else ""
        parser.exit(1, f"{parser.prog}: {name}{error.strerror or error}\n")
    except KeyboardInterrupt:
        parser.exit(1, f"{parser.prog}: interrupted\n")


PACKAGES = {"PIL": "python3-pil", "matplotlib": "python3-matplotlib", "meshio": "python3-meshio",
            "numpy": "python3-numpy", "rosbag": "python3-rosbag", "yaml": "python3-yaml"}


def missing_package(error):
    """Which Debian package brings the module that was not found."""
    package = PACKAGES.get((error.name or "").partition(".")[0])
    return f"{error}; install {package}" if package else str(error)


@contextlib.contextmanager
def unfinished(path):
    """Gives a name beside `path`, with the same ending; what is written there becomes `path` at the
    end, or nothing stays behind."""
    path = Path(path)
    beside = path.with_name(f".{os.getpid()}.{path.name}")
    try:
        yield beside
        beside.replace(path)
    finally:
        beside.unlink(missing_ok=True)


def check_folder_of(path):
    """@throw InputError when the folder of an output file is not there."""
    if not Path(path).parent.is_dir():
        raise InputError(f"{path}: there is no folder {Path(path).parent}")


PICTURES = (".svg", ".png", ".pdf")


def check_picture(path):
    """@throw InputError when there is no way to write this picture; None is no picture."""
    if path is None:
        return
    if path.suffix not in PICTURES:
        raise InputError(f"--output {path}: a picture ends in {', '.join(PICTURES)}")
    check_folder_of(path)


def beside(recording, suffix):
    """A file of the recording with another ending: in its folder, or beside its bag."""
    return recording / f"impact{suffix}" if recording.is_dir() else recording.with_suffix(suffix)

"""Files for other programs. A writer takes a recording and the path of its main file."""

import contextlib
import shutil
from xml.etree import ElementTree

import numpy as np
import yaml

from .folder import COLUMNS
from .program import InputError, unfinished


def numbers(rows):
    """One text a row; all digits, so that the same numbers are read back."""
    return [" ".join(map(repr, row)) for row in rows.tolist()]


def body_numbers(recording):
    """Of all points: 1 for the disk, 2 … for what it meets."""
    sizes = [len(body.points) for body in recording.bodies]
    return np.repeat(np.arange(1, len(sizes) + 1), sizes)


def in_space(rows):
    """The same vectors with z = 0."""
    return np.column_stack((rows, np.zeros(len(rows))))


def vectors_of(state):
    """Position, velocity and force, one row a point."""
    return np.column_stack([in_space(rows) for rows in (state.position, state.velocity,
                                                        state.force)])


def write_lammps(recording, path):
    """A dump of the states, and beside it, as .data, the reference lattice with its bonds."""
    bodies = body_numbers(recording)
    with unfinished(path) as beside, open(beside, "w", encoding="utf-8") as file:
        for state in recording.states():
            low, high = state.position.min(axis=0), state.position.max(axis=0)
            file.write(f"ITEM: TIME\n{state.time!r}\nITEM: TIMESTEP\n{state.step}\n"
                       f"ITEM: NUMBER OF ATOMS\n{len(bodies)}\nITEM: BOX BOUNDS ss ss pp\n"
                       f"{low[0]!r} {high[0]!r}\n{low[1]!r} {high[1]!r}\n-0.5 0.5\n"
                       f"ITEM: ATOMS {' '.join(COLUMNS)}\n")
            file.writelines(f"{number} {body} {row}\n" for number, (body, row)
                            in enumerate(zip(bodies, numbers(vectors_of(state))), 1))
    with unfinished(path.with_suffix(".data")) as beside:
        beside.write_text(lammps_data(recording), encoding="utf-8")


def lammps_data(recording):
    """The reference lattices of all bodies as a LAMMPS data file."""
    points = np.concatenate([body.points for body in recording.bodies])
    bonds = recording.bonds() + 1
    low, high = points.min(axis=0) - 1, points.max(axis=0) + 1
    bodies = body_numbers(recording)
    lines = ["lattices, lengths in R, masses in M", "", f"{len(points)} atoms",
             f"{len(bonds)} bonds", f"{bodies[-1]} atom types", "1 bond types", "",
             f"{low[0]!r} {high[0]!r} xlo xhi", f"{low[1]!r} {high[1]!r} ylo yhi",
             "-0.5 0.5 zlo zhi", "", "Masses", ""]
    lines += [f"{number} {body.point_mass!r}" for number, body in enumerate(recording.bodies, 1)]
    lines += ["", "Atoms # molecular", ""]
    lines += [f"{number} {body} {body} {row} 0"
              for number, (body, row) in enumerate(zip(bodies, numbers(points)), 1)]
    lines += ["", "Bonds", ""]
    lines += [f"{number} 1 {first} {second}" for number, (first, second) in enumerate(bonds, 1)]
    return "\n".join(lines) + "\n"


def write_xyz(recording, path):
    """Extended XYZ: one frame a state."""
    bodies = body_numbers(recording)
    properties = "id:I:1:body:I:1:species:S:1:pos:R:3:velo:R:3:forces:R:3"
    with unfinished(path) as beside, open(beside, "w", encoding="utf-8") as file:
        for state in recording.states():
            file.write(f'{len(bodies)}\nProperties={properties} Time={state.time!r} '
                       f'Step={state.step} pbc="F F F"\n')
            file.writelines(f"{number} {body} X {row}\n" for number, (body, row)
                            in enumerate(zip(bodies, numbers(vectors_of(state))), 1))


def write_npz(recording, path):
    """Arrays by name, over time first."""
    states = list(recording.states())
    bodies = recording.bodies
    arrays = {name: np.array([getattr(state, name) for state in states])
              for name in ("step", "time", "position", "velocity", "force")}
    arrays.update(
        body=body_numbers(recording),
        reference=np.concatenate([body.points for body in bodies]),
        bonds=recording.bonds(),
        natural_length=np.concatenate([body.natural_lengths for body in bodies]),
        point_mass=recording.disk.point_mass,
        scene=yaml.safe_dump(recording.scene, sort_keys=False),
    )
    with unfinished(path) as beside, open(beside, "wb") as file:
        np.savez_compressed(file, **arrays)


def write_vtk(recording, path):
    """A .pvd that names a .vtu for each state, in a folder beside it: bonds as lines with strain
    and natural length, points with velocity and force."""
    folder = path.with_name(path.stem + "_vtu")
    if folder.exists():
        raise InputError(f"{folder}: is there already")
    with unfinished_folder(folder) as beside, unfinished(path) as index:
        root = ElementTree.Element("VTKFile", type="Collection", version="0.1")
        collection = ElementTree.SubElement(root, "Collection")
        for number, state in enumerate(recording.states()):
            name = f"{number:06d}.vtu"
            write_vtu(recording, state, beside / name)
            ElementTree.SubElement(collection, "DataSet", timestep=repr(state.time),
                                   file=f"{folder.name}/{name}")
        ElementTree.ElementTree(root).write(index, encoding="utf-8", xml_declaration=True)


def write_vtu(recording, state, path):
    """One state."""
    import meshio  # pylint: disable=import-outside-toplevel

    lengths = np.concatenate([body.natural_lengths for body in recording.bodies])
    mesh = meshio.Mesh(
        in_space(state.position),
        [("line", recording.bonds())],
        point_data={"velocity": in_space(state.velocity), "force": in_space(state.force),
                    "body": body_numbers(recording)},
        cell_data={"strain": [recording.strains(state)], "natural length": [lengths]},
    )
    mesh.write(path, file_format="vtu")


@contextlib.contextmanager
def unfinished_folder(path):
    """As program.unfinished(), of a folder."""
    beside = path.with_name(f".{path.name}.part")
    shutil.rmtree(beside, ignore_errors=True)
    beside.mkdir()
    try:
        yield beside
        beside.replace(path)
    finally:
        shutil.rmtree(beside, ignore_errors=True)


WRITERS = {"lammps": write_lammps, "xyz": write_xyz, "vtk": write_vtk, "npz": write_npz}

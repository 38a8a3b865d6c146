"""The picture of the atoms of a fluid in their box, coloured by speed."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Optional

import numpy as np
import spheres
import style
from ljmd.reading import records, trajectories
from ljmd.reading.files import damaged, field, is_there
from ljmd.reading.records import Record
from ljmd.reading.trajectories import Trajectory
from matplotlib.collections import LineCollection
from style import plt

MOST_ATOMS = 200_000
INCHES = 6.0
PIXELS = 900  # across the picture
SPEEDS = plt.get_cmap("plasma")
ANGSTROM = 10.0  # in a nanometre
LENGTHS = {"": "", "sigma": r"$\sigma$", "nm": "nm", "angstrom": r"$\mathrm{\AA}$"}
SPEED_UNITS = {"": "", "sigma": r" / ($\sigma/\tau$)", "nm": " / (nm/ps)", "angstrom": r" / ($\mathrm{\AA}$/ps)"}


def atom_diameter(record: Record, unit: str) -> float:
    """One sigma in the unit of length of the trajectory."""
    if unit not in ("nm", "angstrom"):
        return 1.0
    sigma = field(record.file, field(record.file, record.data, "argon", dict), "sigma_nm", float)
    return sigma * (ANGSTROM if unit == "angstrom" else 1.0)


def wrapped(frames: Trajectory) -> np.ndarray:
    """Positions brought back into the box, where there is one."""
    if frames.edges is None:
        return frames.positions
    return np.mod(frames.positions, frames.edges[:, np.newaxis, :])


@dataclass
class Atoms:
    """Frames of a fluid as they are seen: centres (F, N, 3), speeds (F, N) where they are known."""

    frames: Trajectory
    seen: np.ndarray
    speeds: Optional[np.ndarray]
    fastest: float  # the end of the scale of colours
    diameter: float

    @classmethod
    def of(cls, frames: Trajectory, diameter: float) -> "Atoms":
        speeds = None if frames.velocities is None else np.linalg.norm(frames.velocities, axis=2)
        fastest = 1.0 if speeds is None else float(np.nanpercentile(speeds, 99.0)) or 1.0
        return cls(frames, wrapped(frames) @ spheres.view().T, speeds, fastest, diameter)

    def colours(self, frame: int) -> np.ndarray:
        if self.speeds is None:
            return np.tile(plt.matplotlib.colors.to_rgb(style.BLUE), (self.seen.shape[1], 1))
        return SPEEDS(np.clip(self.speeds[frame] / self.fastest, 0.0, 1.0))[:, :3]


class AtomsView:
    """A figure of the atoms, in which any of the frames can be shown."""

    def __init__(self, atoms: Atoms, pixels: int = PIXELS):
        self.atoms, self.pixels = atoms, pixels
        self.figure, self.axes = plt.subplots(figsize=(INCHES, INCHES), constrained_layout=True)
        points = atoms.seen.reshape(-1, 3)
        edges = atoms.frames.edges
        if edges is not None:  # that of the largest box
            behind, before = spheres.edges_of_box(edges.max(axis=0))
            points = np.concatenate([points, behind.reshape(-1, 3), before.reshape(-1, 3)])
        self.window = spheres.Window.around(points, 0.6 * atoms.diameter)
        self.axes.set(xlim=(self.window.left, self.window.right), ylim=(self.window.bottom, self.window.top),
                      aspect="equal")
        self.axes.set_axis_off()
        self.image = self.axes.imshow(np.zeros((1, 1, 4)), extent=self.window.extent, interpolation="bilinear", zorder=2)
        self.box = [self.axes.add_collection(LineCollection([], colors="#777777", linewidths=0.9, zorder=order))
                    for order in (1, 3)]
        if atoms.speeds is not None:
            scale = plt.cm.ScalarMappable(plt.Normalize(0.0, atoms.fastest), SPEEDS)
            self.figure.colorbar(scale, ax=self.axes, shrink=0.55, aspect=26, extend="max",
                                 label="speed" + SPEED_UNITS[atoms.frames.length_unit])

    def show(self, frame: int) -> None:
        atoms = self.atoms
        if atoms.frames.edges is not None:
            for lines, edges in zip(self.box, spheres.edges_of_box(atoms.frames.edges[frame])):
                lines.set_segments(edges[:, :, :2])
        self.image.set_data(spheres.render(atoms.seen[frame], atoms.colours(frame), 0.5 * atoms.diameter, self.window, self.pixels))


def last_configuration(directory: Path) -> Optional[Path]:
    """The file with the last configuration of a run, or the one at which it failed; None without one."""
    return next((path for path in (directory / "failed.xyz", directory / "final.xyz") if is_there(path)), None)


def plot_atoms(directory: Path, path: Path) -> plt.Figure:
    """The atoms of a configuration that a run has left."""
    frames = trajectories.read_xyz(path)
    if frames.positions.shape[1] > MOST_ATOMS:
        raise damaged(path, f"has {frames.positions.shape[1]} atoms, more than {MOST_ATOMS} are not drawn")
    if not np.all(np.isfinite(frames.positions)):
        raise damaged(path, "has positions that are no numbers: there is nothing to draw")
    record = records.read(directory)
    diameter = atom_diameter(record, frames.length_unit)
    view = AtomsView(Atoms.of(frames, diameter))
    view.show(0)
    what = "where the run failed" if path.name == "failed.xyz" else "last configuration"
    edges = "" if frames.edges is None else "; box " + r" $\times$ ".join(f"{edge:.4g}" for edge in frames.edges[0]) + f" {LENGTHS[frames.length_unit]}$^3$"
    style.head(view.figure, record.title, f"{what}: {frames.positions.shape[1]} atoms{edges}")
    return view.figure

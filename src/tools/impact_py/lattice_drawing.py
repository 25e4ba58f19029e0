"""A lattice whose bonds are coloured by their strain, with the forces on its points."""

import numpy as np
from matplotlib.collections import LineCollection

from .style import BLACK, STRAIN_COLOURS

SHORTEST_ARROW = 0.01  # R; shorter ones are not drawn


def strain_limit(strains):
    """A strain that few bonds exceed; colours reach from minus this to this."""
    sizes = np.abs(strains)
    return max(float(np.percentile(sizes, 99.5)) if sizes.size else 0.0, 1e-12)


class LatticeDrawing:
    """Bonds and forces in a panel, which can be moved to another state."""

    def __init__(self, ax, bonds, limit, peak_force, linewidth=0.6, longest_arrow=0.3):
        """`bonds`: two indices each; `limit`: strain at the ends of the colours; `peak_force`: that
        of the longest arrow, in R."""
        self.bonds = bonds
        self.scale = longest_arrow / peak_force if peak_force > 0 else 0.0
        self.lines = LineCollection([], cmap=STRAIN_COLOURS, linewidths=linewidth, rasterized=True)
        self.lines.set_clim(-100 * limit, 100 * limit)
        ax.add_collection(self.lines)
        self.ax = ax
        self.arrows = None
        ax.set_aspect("equal")

    def show(self, position, strain, force):
        """One row a point, one strain a bond."""
        ends = position[self.bonds]
        paths = self.lines.get_paths()
        if not paths:
            self.lines.set_segments(ends)
        for path, vertices in zip(paths, ends):  # many times faster than new segments
            path.vertices = vertices
        self.lines.stale = True
        self.lines.set_array(100 * strain)
        if self.arrows is not None:
            self.arrows.remove()
        arrows = self.scale * force
        seen = np.hypot(*arrows.T) > SHORTEST_ARROW
        x, y = position[seen].T
        u, v = arrows[seen].T
        self.arrows = self.ax.quiver(x, y, u, v, color=BLACK, angles="xy", scale_units="xy",
                                     scale=1.0, width=0.0045, zorder=4)


def strain_bar(figure, drawing, axes):
    """The scale of the colours."""
    bar = figure.colorbar(drawing.lines, ax=axes, shrink=0.75, aspect=28, pad=0.02, extend="both")
    bar.set_label("bond strain (%)")
    return bar

"""Slices across the axes of what fills an upright box, through its middle."""

import dataclasses

import numpy as np

from .style import bare, length_bar, scaled

# By the axis that is upright: normal of each slice, the axes to the right and upwards.
planes = {
    "z": [("z", "x", "y"), ("y", "x", "z"), ("x", "y", "z")],
    "y": [("z", "x", "y"), ("x", "z", "y"), ("y", "x", "z")],
}
# Where axes are in arrays (depth, height, width).
place_in_array = {"z": 0, "y": 1, "x": 2}
room = 0.11  # below a slice for its scale, over its height


@dataclasses.dataclass
class Box:
    """Lengths of the sides, cells along them and the lowest corner, {"x", "y", "z"} each; m, or voxels without a
    length."""

    sides: dict
    cells: dict = None
    low: dict = None
    has_length: bool = True
    upright: str = "z"

    @property
    def planes(self):
        return planes[self.upright]

    def middle(self, axis):
        """The cell in the middle, and where it is in words."""
        cell = self.cells[axis] // 2
        place = self.low[axis] + (cell + 0.5) * self.sides[axis] / self.cells[axis]
        if not self.has_length:
            return cell, f"{place:g}"
        factor, unit = scaled(max(self.sides.values()), "m")
        return cell, f"{place / factor:.3g} {unit}"


def height_of(box, rows, more=0.0):
    """Height over width of rows of slices through a box."""
    tallest = max(box.sides[up] for _, _, up in box.planes) / sum(box.sides[right] for _, right, _ in box.planes)
    return min(1.4, rows * (0.82 * (1 + room) * tallest + 0.05) + more)


def rows_of(figure, box, count):
    """[[place of a slice] of a row]."""
    widths = [box.sides[right] for _, right, _ in box.planes]
    grid = figure.add_gridspec(count, len(box.planes), width_ratios=widths)
    return [[grid[row, column] for column in range(len(box.planes))] for row in range(count)]


def draw_slices(figure, box, values, row, interpolation="nearest", **colours):
    """A slice across each axis through the middle, in a row of a grid; the last picture, and all axes."""
    all_axes = []
    for place, (normal, right, up) in zip(row, box.planes):
        axes = figure.add_subplot(place)
        middle, words = box.middle(normal)
        cut = np.take(values, middle, axis=place_in_array[normal])
        shown = axes.imshow(
            cut if place_in_array[up] < place_in_array[right] else cut.T,
            origin="lower",
            extent=(0, box.sides[right], 0, box.sides[up]),
            interpolation=interpolation,
            rasterized=True,
            **colours,
        )
        axes.set_ylim(-room * box.sides[up], box.sides[up])
        bare(axes)
        axes.set_title(f"{normal} = {words}: {right} \u2192, {up} \u2191", fontsize="small")
        all_axes.append(axes)
    unit = None if box.has_length else "voxels"
    length_bar(all_axes[0], box.sides["x"], 0, -0.55 * room * box.sides["y"], unit)
    return shown, all_axes

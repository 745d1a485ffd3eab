"""Slices of samples in space through their middle, of phases and of stresses."""

import numpy as np

from .. import _core
from .fields import colours_of, kind_key, palette_of, scale_in, unit_in
from .style import bare, key_below, kinds, length_bar, scaled

# Normal of each slice, the axes to the right and upwards; and where they are in arrays (depth, height, width).
planes = [("z", "x", "y"), ("y", "x", "z"), ("x", "y", "z")]
place_in_array = {"z": 0, "y": 1, "x": 2}
room = 0.11  # below a slice for its scale, over its height


def sizes_of(map):
    return {"x": map.width, "y": map.height, "z": map.depth}


def stresses(sample):
    return len(_core._quantities_drawn(sample))


def is_loaded(sample):
    return sample.sigma_zz.size > 0


def height_of(rows, more=0.0):
    """Height over width of rows of slices."""

    def height(sample):
        size = sizes_of(sample.map)
        tallest = max(size[up] for _, _, up in planes) / sum(size[right] for _, right, _ in planes)
        count = rows(sample) if callable(rows) else rows
        return min(1.4, count * (0.82 * (1 + room) * tallest + 0.05) + more)

    return height


def draw_slices(figure, map, values, row, **colours):
    """A slice across each axis through the middle, in a row of a grid; the last picture, and all axes."""
    size, all_axes = {axis: count * map.dx for axis, count in sizes_of(map).items()}, []
    for k, (normal, right, up) in enumerate(planes):
        axes, middle = figure.add_subplot(row[k]), sizes_of(map)[normal] // 2
        shown = axes.imshow(
            np.take(values, middle, axis=place_in_array[normal]),
            origin="lower",
            extent=(0, size[right], 0, size[up]),
            interpolation="nearest",
            rasterized=True,
            **colours,
        )
        axes.set_ylim(-room * size[up], size[up])
        bare(axes)
        axes.set_title(f"{normal} = {written(map, middle + 0.5)}: {right} \u2192, {up} \u2191", fontsize="small")
        all_axes.append(axes)
    length_bar(all_axes[0], size["x"], 0, -0.55 * room * size["y"], None if map.has_length else "voxels")
    return shown, all_axes


def written(map, voxels):
    """A length with its unit."""
    if not map.has_length:
        return f"{voxels:g}"
    factor, unit = scaled(max(sizes_of(map).values()) * map.dx, "m")
    return f"{voxels * map.dx / factor:.3g} {unit}"


def _rows(figure, map, count):
    """[[place of a slice] of a row]."""
    widths = [sizes_of(map)[right] for _, right, _ in planes]
    grid = figure.add_gridspec(count, len(planes), width_ratios=widths)
    return [[grid[row, column] for column in range(len(planes))] for row in range(count)]


def draw_phases(figure, sample):
    """Void, matrix and grains, with their fractions of the volume."""
    map = sample.map
    row = _rows(figure, map, 1)[0]
    _, axes = draw_slices(figure, map, map.phase, row, **palette_of(3))
    key_below(axes[1], kind_key([sample.numbers["map"]["phases"][kind["id"]] for kind in kinds[:3]]), 3)


def draw_component(figure, sample, name, row):
    """One quantity of the voxels, a stress over its mean; voids are white. One colour range for all slices."""
    quantities = _core._voxel_quantities()
    values = np.where(sample.map.phase > 0, _core._voxel_values(sample, name), np.nan)
    values, centre, words = scale_in(
        values,
        name,
        quantities,
        lambda: unit_in(sample.numbers.get("stress", {}), quantities),
        lambda: _core._voxel_mean(sample, name),
    )
    shown, axes = draw_slices(figure, sample.map, values, row, **colours_of(values, centre))
    figure.colorbar(shown, ax=axes, label=words, shrink=0.8, extend="both", pad=0.01)


def of_stress(figure, sample):
    names = _core._quantities_drawn(sample)
    for name, row in zip(names, _rows(figure, sample.map, len(names))):
        draw_component(figure, sample, name, row)


def of_displacement(figure, sample):
    draw_component(figure, sample, "u_z", _rows(figure, sample.map, 1)[0])

"""Slices of samples in space through their middle, of phases and of stresses."""

import numpy as np

from .. import _core
from .fields import colours_of, kind_key, palette_of, scale_in, unit_in
from .slices import Box, draw_slices, height_of, rows_of
from .style import key_below, kinds


def box_of(map):
    cells = {"x": map.width, "y": map.height, "z": map.depth}
    sides = {axis: count * map.dx for axis, count in cells.items()}
    return Box(sides, cells, dict.fromkeys(cells, 0.0), map.has_length)


def stresses(sample):
    return len(_core._quantities_drawn(sample))


def is_loaded(sample):
    return sample.sigma_zz.size > 0


def height_of_rows(rows, more=0.0):
    """Height over width of rows of slices."""
    return lambda sample: height_of(box_of(sample.map), rows(sample) if callable(rows) else rows, more)


def draw_phases(figure, sample):
    """Void, matrix and grains, with their fractions of the volume."""
    map = sample.map
    row = rows_of(figure, box_of(map), 1)[0]
    _, axes = draw_slices(figure, box_of(map), map.phase, row, **palette_of(3))
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
    shown, axes = draw_slices(figure, box_of(sample.map), values, row, **colours_of(values, centre))
    figure.colorbar(shown, ax=axes, label=words, shrink=0.8, extend="both", pad=0.01)


def of_stress(figure, sample):
    names = _core._quantities_drawn(sample)
    for name, row in zip(names, rows_of(figure, box_of(sample.map), len(names))):
        draw_component(figure, sample, name, row)


def of_displacement(figure, sample):
    draw_component(figure, sample, "u_z", rows_of(figure, box_of(sample.map), 1)[0])

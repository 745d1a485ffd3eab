"""A sample as a whole: one quantity of its grains against another, coarse-grained fields."""

import numpy as np

from .. import _core
from .shots import Shot
from .slices import Box, draw_slices, height_of, rows_of
from .style import bare, colours, label, plain, scale_maps, scaled, soft, strong


def worded(symbol, unit):
    return label(f"{symbol}, {unit}" if unit else symbol)


def draw_grains_against(axes, shot, x="size", y="pressure"):
    """One quantity of the grains against another, one point per grain in the colour of its material; by their names in
    `arenite.grain_values`."""
    packing, drawn = shot.packing, []
    for name in (x, y):
        _, symbol, unit, *_ = _core._grain_quantities()[name]
        values = _core.grain_values(packing, name)
        factor, prefixed = scaled(np.max(np.abs(values), initial=0), unit)
        drawn.append((values / factor, worded(symbol, prefixed)))
    for m, material in enumerate(packing.materials):
        of = packing.material == m
        if np.any(of):
            axes.plot(
                drawn[0][0][of],
                drawn[1][0][of],
                ".",
                color=colours[m % len(colours)],
                markersize=2.5,
                alpha=0.7,
                label=plain(material.name),
            )
    axes.set(xlabel=drawn[0][1], ylabel=drawn[1][1])
    if len(packing.materials) > 1:
        axes.legend(markerscale=2)


def grain_scatter(figure, state):
    draw_grains_against(figure.add_subplot(), Shot(state.stage, state.snapshot))


def has_touching_spheres(stage):
    return len(stage.snapshots) > 0 and len(stage.snapshots[-1].packing.contact_i) > 0


def sphere_scatter(figure, stage):
    draw_grains_against(figure.add_subplot(), Shot(stage, stage.snapshots[-1]))


def _look_of(values, layer):
    """The unit that values are drawn in, their colours, which all but a hundredth lie within, and the label of a
    bar."""
    words, symbol, unit, _, scale = layer
    known = np.abs(values[np.isfinite(values)])
    factor, prefixed = scaled(np.max(known, initial=0), unit) if unit in ("Pa", "m/s") else (1, unit)
    low, high = np.nanquantile(values, [0.01, 0.99]) if len(known) else (0, 1)
    ends = (-max(abs(low), abs(high)), max(abs(low), abs(high))) if scale == "diverging" else (low, high)
    look = {"cmap": scale_maps[scale], "vmin": ends[0] / factor, "vmax": ends[1] / factor}
    return factor, look, worded(f"{words} {symbol}", prefixed)


def draw_coarse_field(axes, fields, name):
    """One of the fields of a state (`fields_of`), with the velocity as arrows over its magnitude; returns what a colour
    bar needs, and its label."""
    values, x, y = fields[name], fields["x"], fields["y"]
    factor, colours_of_it, words = _look_of(values, _core._coarse_layers()[name])
    half = [0.5 * (axis[1] - axis[0]) if len(axis) > 1 else 0.5 for axis in (x, y)]
    picture = axes.imshow(
        values / factor,
        origin="lower",
        interpolation="bilinear",
        **colours_of_it,
        extent=(x[0] - half[0], x[-1] + half[0], y[0] - half[1], y[-1] + half[1]),
    )
    if name == "speed" and np.any(values > 0):
        step = max(1, max(len(x), len(y)) // 14)
        axes.quiver(
            x[::step],
            y[::step],
            *(fields[component][::step, ::step] for component in ("vx", "vy")),
            color=strong,
            width=0.004,
            scale=18 * np.nanquantile(values, 0.98),
        )
    bare(axes)
    for side in axes.spines.values():
        side.set(visible=True, color=soft)
    return picture, words


def fields_of(state):
    """Coarse-grained fields of a State by their names, {"x", "y", "solid_fraction", ...}, as the page shows them."""
    return _core._layers_of_state(state.stage, state.snapshot)


def _shown_of(fields):
    return ["solid_fraction", "speed", "pressure", "shear"] if "speed" in fields else ["solid_fraction", "pressure"]


def coarse_fields(figure, state):
    """Solid fraction, pressure and, if grains move, velocity and shear stress."""
    fields = fields_of(state)
    names = _shown_of(fields)
    for axes, name in zip(np.ravel(figure.subplots(len(names) // 2, 2)), names):
        picture, words = draw_coarse_field(axes, fields, name)
        figure.colorbar(picture, ax=axes, label=words, shrink=0.8)


def has_box(state):
    return (
        state.packing.domain["width"] > 0
        and state.packing.domain["height"] > 0
        and state.packing.domain["thickness"] > 0
    )


def fields_height(state):
    return (
        0.44 * state.packing.domain["height"] / state.packing.domain["width"] * (2 if np.any(state.packing.vx) else 1)
        + 0.06
    )


def coarse_slices(figure, stage):
    """The same of spheres, in slices through the middle of the container of the last state."""
    fields, layers = _core._layers_of_state(stage, stage.snapshots[-1]), _core._coarse_layers_in_space()
    sides, names = _sides_of(stage), _shown_of(fields)
    cells = {axis: len(fields[axis]) for axis in sides}
    low = {axis: fields[axis][0] - 0.5 * sides[axis] / cells[axis] for axis in sides}
    box = Box(sides, cells, low, upright="y")
    for name, row in zip(names, rows_of(figure, box, len(names))):
        factor, look, words = _look_of(fields[name], layers[name])
        shown, axes = draw_slices(figure, box, fields[name] / factor, row, "bilinear", **look)
        figure.colorbar(shown, ax=axes, label=words, shrink=0.8, extend="both", pad=0.01)


def _sides_of(stage):
    """Of the container of the last state."""
    return dict(zip("xyz", stage.snapshots[-1].packing.domain["size"]))


def are_in_a_box(stage):
    return len(stage.snapshots) > 0 and all(side > 0 for side in _sides_of(stage).values())


def slices_height(stage):
    moves = np.any(stage.snapshots[-1].packing.velocity)
    return height_of(Box(_sides_of(stage), upright="y"), 4 if moves else 2)

"""A sample as a whole: one quantity of its grains against another, coarse-grained fields."""

import numpy as np

from .. import _core
from .drawing import describe
from .parts import State
from .shots import Shot
from .slices import Box, draw_slices, height_of, rows_of
from .style import bare, colours, label, plain, scale_maps, scaled, soft, strong


def worded(symbol, unit):
    return label(f"{symbol}, {unit}" if unit else symbol)


def scatter_of(part):
    """What the library describes of the grains of a state, or of a stage of spheres: the numbers that may stand along
    the axes, and which do; None where there is nothing to draw."""
    drawings = describe(part).get("grain-scatter")
    return drawings[0]["scatter"] if drawings else None


def draw_grains_against(axes, shot, x=None, y=None):
    """One quantity of the grains against another, one point per grain in the colour of its material; by their names in
    `arenite.grain_values`, or those that the page shows first."""
    stage = shot.stage
    part = stage if shot.in_space else State(stage.name, stage, shot.snapshot, [stage])
    _draw_scatter(axes, shot, scatter_of(part), x, y)


def _draw_scatter(axes, shot, scatter, x=None, y=None):
    packing = shot.packing
    known = {axis["quantity"]: axis for axis in scatter["axes"]}
    names = {"x": x or scatter["across"], "y": y or scatter["up"]}
    for along, name in names.items():
        if name not in known:
            raise ValueError(f"these grains have no {name}; there are {', '.join(known)}")
        axes.set(**{f"{along}label": worded(known[name]["label"], known[name].get("unit"))})
    values = [
        _core._grain_values_of_state(shot.stage, shot.snapshot, name) / known[name]["factor"] for name in names.values()
    ]
    drawn = np.arange(len(packing)) % scatter["every"] == 0
    for m, material in enumerate(packing.materials):
        of = drawn & (packing.material == m)
        if np.any(of):
            axes.plot(
                values[0][of],
                values[1][of],
                ".",
                color=colours[m % len(colours)],
                markersize=2.5,
                alpha=0.7,
                label=plain(material.name),
            )
    if len(packing.materials) > 1:
        axes.legend(markerscale=2)


def grain_scatter(figure, part):
    """Of a state, or of the last one of a stage of spheres."""
    of_state = isinstance(part, State)
    shot = Shot(part.stage, part.snapshot) if of_state else Shot(part, part.snapshots[-1])
    _draw_scatter(figure.add_subplot(), shot, scatter_of(part))


def _look_of(ends, layer):
    """The unit that values are drawn in, their colours between these ends, and the label of a bar."""
    words, symbol, unit, _, scale = layer
    factor, prefixed = scaled(max(map(abs, ends)), unit)
    look = {"cmap": scale_maps[scale], "vmin": ends[0] / factor, "vmax": ends[1] / factor}
    return factor, look, worded(f"{words} {symbol}", prefixed)


def draw_coarse_field(axes, fields, name):
    """One of the fields of a state (`fields_of`), with the velocity as arrows over its magnitude; returns what a colour
    bar needs, and its label."""
    values, x, y = fields[name], fields["x"], fields["y"]
    factor, colours_of_it, words = _look_of(fields["ends"][name], _core._coarse_layers()[name])
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
        factor, look, words = _look_of(fields["ends"][name], layers[name])
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

"""A sample as a whole: one quantity of its grains against another, coarse-grained fields."""

import numpy as np

from .. import _core
from .shots import Shot
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


def draw_coarse_field(axes, fields, name):
    """One of the fields of a state (`fields_of`), with the velocity as arrows over its magnitude; returns what a colour
    bar needs, and its label."""
    words, symbol, unit, _, scale = _core._coarse_layers()[name]
    values, x, y = fields[name], fields["x"], fields["y"]
    known = np.abs(values[np.isfinite(values)])
    factor, prefixed = scaled(np.max(known, initial=0), unit) if unit in ("Pa", "m/s") else (1, unit)
    low, high = np.nanquantile(values, [0.01, 0.99]) if len(known) else (0, 1)
    ends = (-max(abs(low), abs(high)), max(abs(low), abs(high))) if scale == "diverging" else (low, high)
    half = [0.5 * (axis[1] - axis[0]) if len(axis) > 1 else 0.5 for axis in (x, y)]
    picture = axes.imshow(
        values / factor,
        origin="lower",
        cmap=scale_maps[scale],
        vmin=ends[0] / factor,
        vmax=ends[1] / factor,
        interpolation="bilinear",
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
    return picture, worded(f"{words} {symbol}", prefixed)


def fields_of(state):
    """Coarse-grained fields of a State by their names, {"x", "y", "solid_fraction", ...}, as the page shows them."""
    return _core._layers_of_state(state.stage, state.snapshot)


def coarse_fields(figure, state):
    """Solid fraction, pressure and, if grains move, velocity and shear stress."""
    fields = fields_of(state)
    names = ["solid_fraction", "speed", "pressure", "shear"] if "speed" in fields else ["solid_fraction", "pressure"]
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

"""A sample as a whole: one quantity of its grains against another, coarse-grained fields."""

import numpy as np

from .._core import coarse_grained
from .motion import Shot, deviator, pressure
from .style import bare, colours, diverging_map, even_map, plain, scaled, soft, stress_map, strong

# What the grains of a state may be drawn by: label, unit, and the values of a Shot.
quantities = {
    "diameter": ("$d$", "m", lambda shot: 2 * shot.packing.radius),
    "pressure": ("$p$", "Pa", pressure),
    "deviator": ("$q$", "Pa", deviator),
    "speed": (r"$|\mathbf{v}|$", "m/s", lambda shot: np.hypot(shot.packing.vx, shot.packing.vy)),
    "spin": (r"$\omega$", "rad/s", lambda shot: shot.packing.omega),
}


def draw_grains_against(axes, shot, x="diameter", y="pressure"):
    """One quantity of the grains against another, one point per grain in the colour of its material; names as in `quantities`."""
    packing, drawn = shot.packing, []
    for name in (x, y):
        symbol, unit, find = quantities[name]
        values = np.asarray(find(shot), float)
        factor, prefixed = scaled(np.max(np.abs(values), initial=0), unit)
        drawn.append((values / factor, f"{symbol}, {prefixed}"))
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


def stress_of(fields):
    """Contact stress and its kinetic part, Pa, tension positive."""
    return fields["contact_stress"] + fields["kinetic_stress"]


# Coarse-grained fields: label, unit, colours, and values of the fields' dict.
layers = {
    "solid_fraction": (r"solid fraction $\phi$", "", even_map, lambda f: f["solid_fraction"]),
    "speed": (
        r"velocity $|\mathbf{v}|$",
        "m/s",
        even_map,
        lambda f: np.hypot(f["velocity"][..., 0], f["velocity"][..., 1]),
    ),
    "pressure": ("pressure $p$", "Pa", stress_map, lambda f: -0.5 * np.trace(stress_of(f), axis1=-2, axis2=-1)),
    "shear": (
        r"shear stress $\sigma_{xy}$",
        "Pa",
        diverging_map,
        lambda f: 0.5 * (stress_of(f)[..., 0, 1] + stress_of(f)[..., 1, 0]),
    ),
}


def draw_coarse_field(axes, fields, name):
    """One of `layers` of the result of `arenite.coarse_grained`, with the velocity as arrows over its magnitude; returns what a colour bar needs, and its label."""
    label, unit, colour_map, find = layers[name]
    values, x, y = find(fields), fields["x"], fields["y"]
    known = np.abs(values[np.isfinite(values)])
    factor, prefixed = scaled(np.max(known, initial=0), unit) if unit else (1, "")
    low, high = np.nanquantile(values, [0.01, 0.99]) if len(known) else (0, 1)
    ends = (-max(abs(low), abs(high)), max(abs(low), abs(high))) if colour_map == diverging_map else (low, high)
    half = [0.5 * (axis[1] - axis[0]) if len(axis) > 1 else 0.5 for axis in (x, y)]
    picture = axes.imshow(
        values / factor,
        origin="lower",
        cmap=colour_map,
        vmin=ends[0] / factor,
        vmax=ends[1] / factor,
        interpolation="bilinear",
        extent=(x[0] - half[0], x[-1] + half[0], y[0] - half[1], y[-1] + half[1]),
    )
    if name == "speed" and np.any(values > 0):
        step = max(1, max(len(x), len(y)) // 14)
        v = fields["velocity"][::step, ::step]
        axes.quiver(
            x[::step],
            y[::step],
            v[..., 0],
            v[..., 1],
            color=strong,
            width=0.004,
            scale=18 * np.nanquantile(values, 0.98),
        )
    bare(axes)
    for side in axes.spines.values():
        side.set(visible=True, color=soft)
    return picture, f"{label}, {prefixed}" if prefixed else label


def fields_of(state):
    """With a kernel as wide as the mean grain, or wider for more than 2500 grains."""
    packing, history = state.packing, state.history
    area = packing.domain["width"] * packing.domain["height"]
    width = max(2 * np.mean(packing.radius), np.sqrt(area / 2500))
    rate = (
        np.interp(state.snapshot.time, history["time"], np.gradient(history["shear_strain"], history["time"]))
        if "shear_strain" in history
        else None
    )
    return coarse_grained(packing, width, tilt_rate=None if rate is None else float(rate * packing.domain["height"]))


def coarse_fields(figure, state):
    """Solid fraction, pressure and, if grains move, velocity and shear stress."""
    fields = fields_of(state)
    names = list(layers) if np.any(state.packing.vx) or np.any(state.packing.vy) else ["solid_fraction", "pressure"]
    for axes, name in zip(np.ravel(figure.subplots(len(names) // 2, 2)), names):
        picture, label = draw_coarse_field(axes, fields, name)
        figure.colorbar(picture, ax=axes, label=label, shrink=0.8)


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

"""Pictures of cemented samples and their stresses (P figures 1 to 15)."""

import numpy as np
from matplotlib.colors import ListedColormap
from matplotlib.lines import Line2D

from .. import _core
from .style import (
    bare,
    centred_map,
    crack_colours,
    key_below,
    label,
    length_bar,
    patch,
    phase_colours,
    drawn,
    kinds,
    one_sided_map,
    scaled,
)

beyond_nodes = drawn["beyond"]["nodes"]  # share of them beyond either end of a scale of colours, as on the page


def _picture(axes, map, values, **options):
    width, height = map.width * map.dx, map.height * map.dx
    shown = axes.imshow(
        values, origin="lower", extent=(0, width, 0, height), interpolation="nearest", rasterized=True, **options
    )
    axes.set_ylim(-0.08 * height, height)
    length_bar(axes, width, 0, -0.05 * height)
    bare(axes)
    return shown


def height_of(field, room=0.2):
    """Height over width of a picture with its key."""
    return min(1.6, field.map.height / field.map.width + room)


def palette_of(count):
    """The colours of so many kinds, with the ends of their numbers."""
    colours = [phase_colours[kind["id"]] for kind in kinds[:count]]
    return {"cmap": ListedColormap(colours), "vmin": -0.5, "vmax": count - 0.5}


def draw_phases(axes, field, key=True):
    """Void, matrix, small and large grains; `field` is a Field or a PhaseMap."""
    map = getattr(field, "map", field)
    shown = _picture(axes, map, _core._kinds_of_nodes(map), **palette_of(len(kinds)))
    if key:
        key_below(axes, phase_key(map), 3)
    return shown


def phase_key(map):
    """Legend entries of the kinds present, with their area fractions."""
    return kind_key(_core._fractions_by_kind(map))


def kind_key(shares):
    """The same of the shares of the first kinds."""
    return [
        patch(phase_colours[kind["id"]], f"{kind['many']} {100 * share:.3g} %")
        for kind, share in reversed([*zip(kinds, shares)])
        if share > 0
    ]


def values_of(field, component):
    """A component on all nodes, Pa or m: sigma_yy, sigma_xx, sigma_xy, sigma_hyd, sigma_1 and sigma_2 (the principal
    stresses, the larger first), ux, uy, u (magnitude)."""
    return _core._field_values(field, component)


def statistics_of(field, **options):
    """Its stresses by phase; empty without stresses."""
    try:
        return field.statistics(**options)
    except ValueError:
        return {}


def unit_of(field):
    """(Pa, name of the component, "mean" or "root mean square") by which the stored statistics normalise stresses; None
    without statistics."""
    return unit_in(field.numbers.get("stress") or statistics_of(field, curves=False), _core._field_quantities())


def unit_in(stored, quantities):
    """The same of stored statistics."""
    for component in [name for name in quantities if name in stored]:
        by = stored[component]["normalised_by"]
        value = stored[component].get("sample_mean_Pa" if by == "mean" else "root_mean_square_Pa", {}).get("value")
        if value:
            return value, component, by
    return None


def scale_of(field, component):
    """(values, centre, label) of a picture. The component of the statistics is shown over its mean about 1 or over its
    r.m.s. about 0, the other stresses over the same number (without its sign) about their means; displacements in
    metres, the magnitude from its smallest value.
    """
    values = np.where(field.map.phase > 0, values_of(field, component), np.nan)
    return scale_in(
        values,
        component,
        _core._field_quantities(),
        lambda: unit_of(field),
        lambda: _core._field_mean(field, component),
    )


def scale_in(values, component, quantities, unit_of_stress, mean_of_sample):
    """The same of values that are NaN in voids: `quantities` as the library gives them, what normalises stresses as
    `unit_in` says it, and the sample's mean of this component."""
    symbol, in_unit, is_magnitude = quantities[component]
    symbol, unit = label(symbol), unit_of_stress() if in_unit == "Pa" else None
    if unit is None:
        factor, name = scaled(np.nanmax(np.abs(values)), in_unit)
        return (
            values / factor,
            None if is_magnitude else mean_of_sample() / factor,
            f"{symbol}, {name}" if name else symbol,
        )
    value, of, by = unit
    if of == component:
        return values / value, float(by == "mean"), f"{symbol} over its {'mean' if by == 'mean' else 'r.m.s.'}"
    values = values / abs(value)
    over = f"|\u27e8{label(quantities[of][0])}\u27e9|" if by == "mean" else f"rms({label(quantities[of][0])})"
    return values, None if is_magnitude else mean_of_sample() / abs(value), f"{symbol}/{over}"


def draw_field(axes, field, component="sigma_yy", share=beyond_nodes, colour_map=centred_map):
    """A component as `scale_of` gives it; the colour range excludes `share` of the nodes at each end, voids are
    white."""
    values, centre, label = scale_of(field, component)
    shown = _picture(axes, field.map, values, **colours_of(values, centre, share, colour_map))
    shown.set_label(label)
    return shown


def colours_of(values, centre, share=beyond_nodes, colour_map=centred_map):
    """A colour map and its ends for values about a centre, or from their least where that is None."""
    low, high = _core._ends_of(np.ravel(values), share)
    if centre is None:
        return {"cmap": one_sided_map, "vmin": low, "vmax": high}
    reach = max(high - centre, centre - low) or 1.0
    return {"cmap": colour_map, "vmin": centre - reach, "vmax": centre + reach}


def draw_cracks(axes, field):
    """Broken bonds on the sample, by type."""
    draw_phases(axes, field, key=False)
    crack_dots(axes, field.cracks["x"], field.cracks["y"], field.cracks["type"], phase_key(field.map))


def crack_dots(axes, x, y, types, others=()):
    """A dot at every broken bond, by type; the legend states their numbers, after the entries `others`."""
    handles, suffix = [], " bonds" if others else ""
    for kind, (name, colour) in enumerate(zip(drawn["cracks"], crack_colours)):
        of = types == kind
        if of.any():
            axes.plot(x[of], y[of], ".", color=colour, markersize=0.8, rasterized=True)
            handles.append(
                Line2D([], [], linestyle="", marker=".", color=colour, markersize=5, label=f"{name}{suffix} {of.sum()}")
            )
    key_below(axes, [*others, *handles], 3)

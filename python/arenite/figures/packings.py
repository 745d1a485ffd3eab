"""Pictures of packings."""

import numpy as np
from matplotlib.collections import LineCollection, PatchCollection, PolyCollection
from matplotlib.patches import Circle, Rectangle

from .. import _core
from .style import (
    bare,
    colours,
    force_symbols,
    key_below,
    length_bar,
    most_stress,
    pale,
    patch,
    plain,
    scaled,
    stress_map,
    strong,
    tension,
    weak,
    widths_of_forces,
)


def sides_of(packing):
    """Ends of the lines that walls or the edges of the cell are, by side."""
    at = {side: packing.domain[side]["position"] for side in ("left", "right", "bottom", "top")}
    left, right, bottom, top = extent_of(packing)
    upright = {side: ((at[side], bottom), (at[side], top)) for side in ("left", "right")}
    return upright | {side: ((left, at[side]), (right, at[side])) for side in ("bottom", "top")}


def boundaries_of(packing):
    """Boundaries and membranes that are there, each by its points; of a closed one the first again at the end."""
    there = [b for b in packing.domain["boundaries"] if b["present"]]
    return [np.vstack([b["points"], b["points"][:1]]) if b["closed"] else b["points"] for b in there]


def extent_of(packing):
    """(left, right, bottom, top) of a picture: the container, or how far membranes bulge out of it."""
    d = packing.domain
    names = [f"{side}_membrane" for side in ("left", "right", "bottom", "top")]
    bulged = [b["points"] for b in d["boundaries"] if b["name"] in names]
    corners = [(d["left"]["position"], d["bottom"]["position"]), (d["right"]["position"], d["top"]["position"])]
    points = np.vstack([corners, *bulged])
    return points[:, 0].min(), points[:, 0].max(), points[:, 1].min(), points[:, 1].max()


def container(axes, packing):
    """The walls or the edges of the cell, boundaries, and space around them; returns the position for a line of text
    below, (x, y)."""
    lines = sides_of(packing)
    styles = ["-" if packing.domain[side]["present"] else "--" for side in lines]
    axes.add_collection(
        LineCollection(list(lines.values()), colors=strong, linewidths=0.6, linestyles=styles, capstyle="projecting")
    )
    axes.add_collection(LineCollection(boundaries_of(packing), colors=strong, linewidths=0.9, zorder=3))
    left, right, bottom, top = extent_of(packing)
    margin = 0.02 * max(right - left, top - bottom)
    axes.set_xlim(left - margin, right + margin)
    axes.set_ylim(bottom - 4 * margin, top + margin)
    length_bar(axes, right - left, left, bottom - 3 * margin)
    bare(axes)
    return left + 0.3 * (right - left), bottom - 3 * margin


def height_of(packing, room=0.12):
    """Height over width of a picture with its key."""
    left, right, bottom, top = extent_of(packing)
    return min(1.6, (top - bottom) / (right - left) + room)


def circles(x, y, radius, **options):
    return PatchCollection([Circle((a, b), r) for a, b, r in zip(x, y, radius)], **options)


def material_key(axes, packing):
    names = [(m, material.name) for m, material in enumerate(packing.materials) if np.any(packing.material == m)]
    key_below(
        axes,
        [
            patch(colours[m % len(colours)] + "bf", f"{plain(name)} ({np.sum(packing.material == m)})")
            for m, name in names
        ],
    )


def draw_packing(axes, packing, by="material", colour_map=stress_map, most=most_stress):
    """Grains coloured `by` "material" or "sigma_norm" (pressure over its mean, up to `most`); returns what a colour bar
    needs."""
    disks = circles(packing.x, packing.y, packing.radius, linewidth=0.25, edgecolor=strong)
    axes.add_collection(disks)
    container(axes, packing)
    if by == "sigma_norm" and len(packing.contacts) > 0:
        disks.set(array=_core.measure_grains(packing)["sigma_norm"], clim=(0, most), cmap=colour_map)
    else:
        disks.set_facecolor([colours[m % len(colours)] for m in packing.material])
        disks.set_alpha(0.75)
        material_key(axes, packing)
    return disks


def draw_forces(axes, packing, mean=None, uncertain=None):
    """Normal forces as bars between centres: width in proportion to force, strong ones (above `mean`, by default that
    of the compressive ones) dark, tensile ones red; those of `uncertain` (one flag per contact) are pale."""
    axes.add_collection(circles(packing.x, packing.y, packing.radius, linewidth=0.2, edgecolor=pale, facecolor="none"))
    at = container(axes, packing)
    c = packing.contacts
    if len(c) == 0:
        return
    uncertain = np.zeros(len(c), bool) if uncertain is None else np.asarray(uncertain, bool)
    scale = _core._force_scale(packing, np.nan if mean is None else mean, uncertain.astype(np.uint8))
    mean = scale[0] or 1.0
    kinds = kinds_of(c.fn, scale, uncertain)
    width = widths_of_forces(c.fn, mean, _core._mean_radius(packing))
    for kind, colour in kind_colours.items():
        drawn = [
            bars(start[kinds == kind], end[kinds == kind], width[kinds == kind]) for start, end in segments(packing)
        ]
        axes.add_collection(PolyCollection(np.concatenate(drawn), facecolor=colour, linewidth=0))
    force_scale(axes, at, widths_of_forces(mean, mean, _core._mean_radius(packing)), mean)
    key_below(axes, [patch(colour, kind) for kind, colour in kind_colours.items() if np.any(kinds == kind)])


kind_colours = {"may be absent": pale, "weak": weak, "strong": strong, "tension": tension}  # in the order of drawing


def kinds_of(fn, scale, uncertain):
    """The kind of every force by (mean, tension), N."""
    mean, tension = scale
    return np.select([uncertain, fn < tension, fn > mean], ["may be absent", "tension", "strong"], "weak")


def segments(packing):
    """(starts, ends) of the contacts, centre to centre or wall; also from the other grain if it crosses a periodic
    side."""
    c = packing.contacts
    way = np.column_stack([c.nx, c.ny]) * (c.arm_i + c.arm_j)[:, None]
    from_i = np.column_stack([packing.x[c.i], packing.y[c.i]])
    j = np.maximum(c.j, 0)
    from_j = np.column_stack([packing.x[j], packing.y[j]])
    across = (c.j >= 0) & (np.linalg.norm(from_j - (from_i - way), axis=1) > packing.radius[j])
    # A segment of no length keeps the order of contacts where there is nothing to see.
    return [(from_i, from_i - way), (np.where(across[:, None], from_j, 0), np.where(across[:, None], from_j + way, 0))]


def bars(start, end, width):
    way = end - start
    length = np.maximum(np.linalg.norm(way, axis=1), 1e-300)[:, None]
    half = 0.5 * width[:, None] * np.column_stack([-way[:, 1], way[:, 0]]) / length
    return np.stack([start + half, end + half, end - half, start - half], axis=1)


def force_scale(axes, at, width, mean):
    """A bar with the width of the mean force, and its value."""
    x, y = at
    length = 0.06 * packing_width(axes)
    axes.add_patch(Rectangle((x, y - width / 2), length, width, facecolor=strong, linewidth=0))
    factor, unit = scaled(mean, "N")
    axes.text(
        x + 1.25 * length,
        y,
        rf"$\langle {force_symbols['fn']}\rangle$ = {mean / factor:.3g} {unit}",
        va="center",
        fontsize="small",
    )


def packing_width(axes):
    low, high = axes.get_xlim()
    return high - low

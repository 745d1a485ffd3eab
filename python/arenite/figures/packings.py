"""Pictures of packings."""

import numpy as np
from matplotlib.collections import PatchCollection, PolyCollection
from matplotlib.patches import Circle, Rectangle

from .._core import measure_grains
from .style import bare, colours, length_bar, strong


def frame(axes, packing):
    """The walls or the edges of the cell, and room around them."""
    d = packing.domain
    x, y = d["left"]["position"], d["bottom"]["position"]
    axes.add_patch(Rectangle((x, y), d["width"], d["height"], fill=False, linewidth=0.6, edgecolor=strong, linestyle="-" if d["left"]["present"] else "--"))
    margin = 0.02 * max(d["width"], d["height"])
    axes.set_xlim(x - margin, x + d["width"] + margin)
    axes.set_ylim(y - 4 * margin, y + d["height"] + margin)
    length_bar(axes, d["width"], x, y - 3 * margin)
    bare(axes)


def draw_packing(axes, packing, by="material", colour_map="viridis", most=2.5):
    """Grains coloured `by` "material" or "sigma_norm" (pressure over its mean, up to `most`); gives what a colour bar needs."""
    disks = PatchCollection([Circle((x, y), r) for x, y, r in zip(packing.x, packing.y, packing.radius)], linewidth=0.25, edgecolor=strong)
    if by == "sigma_norm" and len(packing.contacts) > 0:
        disks.set_array(measure_grains(packing)["sigma_norm"])
        disks.set_clim(0, most)
        disks.set_cmap(colour_map)
    else:
        disks.set_facecolor([colours[m % len(colours)] for m in packing.material])
        disks.set_alpha(0.75)
    axes.add_collection(disks)
    frame(axes, packing)
    return disks


def draw_forces(axes, packing, widest=0.6):
    """Normal forces as bars between centres: width by force, `widest` of the mean radius for four times the mean force; tension is red."""
    axes.add_collection(PatchCollection([Circle((x, y), r) for x, y, r in zip(packing.x, packing.y, packing.radius)], linewidth=0.2, edgecolor="#c8c8c8", facecolor="none"))
    c = packing.contacts
    if len(c) > 0:
        push = c.fn[c.fn > 0]
        unit = widest * np.mean(packing.radius) / (4 * (push.mean() if len(push) else 1.0))
        inner = c.j >= 0
        a = np.column_stack([packing.x[c.i], packing.y[c.i]])
        b = a - np.column_stack([c.nx, c.ny]) * (c.arm_i + c.arm_j)[:, None]
        half = 0.5 * unit * np.minimum(np.abs(c.fn), 4 * push.mean() if len(push) else 1.0)[:, None] * np.column_stack([-c.ny, c.nx])
        bars = np.stack([a + half, b + half, b - half, a - half], axis=1)
        axes.add_collection(PolyCollection(bars, facecolor=np.where(c.fn < 0, "#d62728", np.where(inner, strong, "#707070")), linewidth=0))
    frame(axes, packing)



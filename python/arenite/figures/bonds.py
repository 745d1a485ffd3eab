"""Bonds between grains that break while a stage runs (`Packing.bonds`, `Stage.history`)."""

import numpy as np
from matplotlib.collections import LineCollection
from matplotlib.lines import Line2D

from .packings import circles, container
from .style import breaks, broken_colours, crack_half, farthest_crack, key_below, pale, weak

kinds = {k + 1: kind for k, kind in enumerate(zip(breaks, broken_colours))}  # as `broken` counts them


def has_broken(history):
    return any(np.max(history.get(f"broken_in_{name}", [0])) > 0 for name, _ in kinds.values())


def segments(packing, chosen, across):
    """Lines from centre to centre of these bonds, or across them with their width, while the grains are near each
    other; none through a periodic side."""
    i, j = packing.bonds["i"][chosen], packing.bonds["j"][chosen]
    a, b = (np.column_stack([packing.x[k], packing.y[k]]) for k in (i, j))
    near = np.all(np.abs(b - a) < 0.5 * np.array([packing.domain["width"], packing.domain["height"]]), axis=1)
    a, b, ri, rj = a[near], b[near], packing.radius[i][near, None], packing.radius[j][near, None]
    if not across:
        return np.stack([a, b], axis=1)
    way, middle = b - a, a + ri / (ri + rj) * (b - a)
    length = np.linalg.norm(way, axis=1)[:, None]
    half = crack_half * np.minimum(ri, rj) / length * np.column_stack([-way[:, 1], way[:, 0]])
    return np.stack([middle - half, middle + half], axis=1)[(length <= farthest_crack * (ri + rj))[:, 0]]


def draw_cracks(axes, packing):
    """Grains with intact bonds, and a crack for each broken bond, by kind."""
    broken = packing.bonds["broken"]
    axes.add_collection(
        circles(packing.x, packing.y, packing.radius, linewidth=0.2, edgecolor=pale, facecolor="#f4f4f4")
    )
    container(axes, packing)
    axes.add_collection(LineCollection(segments(packing, broken == 0, False), colors=weak, linewidths=0.35))
    handles = [Line2D([], [], color=weak, linewidth=0.6, label=f"holds {np.sum(broken == 0)}")]
    for kind, (name, colour) in kinds.items():
        if np.any(broken == kind):
            axes.add_collection(LineCollection(segments(packing, broken == kind, True), colors=colour, linewidths=1.1))
            handles.append(Line2D([], [], color=colour, label=f"{name} {np.sum(broken == kind)}"))
    key_below(axes, handles)

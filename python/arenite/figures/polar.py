"""Drawings by direction: roses and hemispheres of contact orientations, and outlines of numbers by direction with
their errors."""

import matplotlib
import numpy as np

from .style import colour_of_role, colours, even_map, label, line_styles, numbers, soft, strong, weak

grey, thin = "#e0e0e0", 0.4


def draw_rose(axes, rose):
    """A polar histogram over the isotropic fraction (T Fig. 3.8) with its line; `axes` are polar."""
    sectors, colour = numbers(rose["sectors"]), colour_of_role(rose["colour"])
    step = 180 / len(sectors)
    angle = np.radians(np.arange(0.5 * step, 360, step))
    for name, alpha in (("sectors", 0.35 if "inner" in rose else 0.5), ("inner", 0.75)):
        if name in rose:
            axes.bar(
                angle,
                np.tile(numbers(rose[name]), 2),
                width=np.radians(0.9 * step),
                color=colour,
                alpha=alpha,
                linewidth=0,
            )
    turn = np.linspace(0, 2 * np.pi, 361)
    axes.plot(turn, np.ones_like(turn), linestyle=":", color=weak, linewidth=0.8)
    if "line" in rose:
        radii = np.append(np.tile(numbers(rose["line"]), 2), rose["line"][0])
        axes.plot(np.linspace(0, 2 * np.pi, len(radii)), radii, color=strong, linewidth=0.9)
    reach = rose["reach"]
    for turn in (0, 180) if "axis" in rose else ():
        at = np.radians(rose["axis"] + turn)
        axes.annotate(
            "",
            (at, reach),
            (at, 1.12 * reach),
            arrowprops={
                "arrowstyle": "-|>",
                "color": colours[1],
                "linewidth": 0.6,
                "mutation_scale": 5,
                "shrinkA": 0,
                "shrinkB": 0,
            },
            annotation_clip=False,
        )
    axes.set(xticks=np.radians(np.arange(0, 360, 45)), yticks=[], ylim=(0, reach))
    axes.set_xticklabels([])
    axes.grid(color=grey, linewidth=thin)
    axes.spines["polar"].set(color=grey, linewidth=thin)
    axes.set_title(label(f"{rose['name']} ({rose['count']:.0f})"), pad=12)
    axes.set_xlabel(label("\n".join(rose["words"])), labelpad=3)


def draw_roses(figure, roses):
    columns = min(3, len(roses))
    rows = -(-len(roses) // columns)
    width = figure.get_figwidth()
    figure.set_size_inches(width, rows * (width / columns + 0.35) * (1 if columns > 1 else 1.05))
    if figure.get_layout_engine():  # room for the words above and below, which are wider than the circles are apart
        figure.get_layout_engine().set(w_pad=0.035 * width)
    for k, rose in enumerate(roses):
        draw_rose(figure.add_subplot(rows, columns, k + 1, projection="polar"), rose)


def draw_hemisphere(axes, one, sectors, scale):
    """Sectors of equal area over half of the sphere, coloured by a scale; `axes` are polar."""
    inner, outer, first, last = sectors
    bars = axes.bar(
        np.radians(first), outer - inner, width=np.radians(last - first), bottom=inner, align="edge", linewidth=0
    )
    for bar, value in zip(bars, numbers(one["values"])):
        bar.set_color(scale.to_rgba(value))
    if "mark" in one:
        x, y = one["mark"]
        axes.plot(np.arctan2(y, x), np.hypot(x, y), "+", color=colours[1], markersize=6)
    axes.set(ylim=(0, 1), yticks=[], xticks=[0, 1.5 * np.pi])
    axes.set_xticklabels(["$x$", "$z$"])
    axes.tick_params(pad=-2)
    axes.grid(False)
    axes.spines["polar"].set(color=grey, linewidth=thin)
    axes.set_title(label(f"{one['name']} ({one['count']:.0f})"), pad=8)
    axes.set_xlabel(label("\n".join(one["words"])), labelpad=3)


def draw_hemispheres(figure, hemispheres):
    sets, columns = hemispheres["sets"], len(hemispheres["sets"])
    width = figure.get_figwidth()
    figure.set_size_inches(width, width / columns + 1.2)
    axes = [figure.add_subplot(1, columns, k + 1, projection="polar") for k in range(columns)]
    sectors = [numbers(hemispheres[name]) for name in ("inner", "outer", "from", "to")]
    scale = matplotlib.cm.ScalarMappable(matplotlib.colors.Normalize(0, hemispheres["reach"]), even_map)
    for place, one in zip(axes, sets):
        draw_hemisphere(place, one, sectors, scale)
    figure.colorbar(scale, ax=axes, orientation="horizontal", shrink=0.4, aspect=30, label=hemispheres["measure"])


def draw_outlines(axes, outlines):
    """Outlines of numbers by direction, or of their fractions over the isotropic one, which is dotted; `axes` are
    polar."""
    for place, series in enumerate(outlines["series"]):
        middle, radius = numbers(series["x"]), numbers(series["y"])
        half, colour = 180 / (2 * len(middle)), colour_of_role(series["colour"])
        angle = np.concatenate([turn + np.column_stack([middle - half, middle + half]).ravel() for turn in (0, 180)])
        corners = np.tile(np.repeat(radius, 2), 2)
        axes.plot(
            np.radians(np.append(angle, angle[0])),
            np.append(corners, corners[0]),
            line_styles[series["line"]],
            color=colour,
            linewidth=0.9,
        )
        if "error" not in series:
            continue
        error = numbers(series["error"])
        aside = 0.4 * half * (place % 4 - 1.5)  # ticks of several outlines stand beside each other
        for turn in (0, 180):
            at = np.radians(turn + middle + aside)
            axes.vlines(at, np.maximum(0, radius - error), radius + error, color=colour, linewidth=0.6)
    if outlines.get("isotropic"):
        axes.plot(np.linspace(0, 2 * np.pi, 181), np.ones(181), ":", color=soft, linewidth=0.8)
    if "corner" in outlines:
        axes.annotate(label(outlines["corner"]), (0, 0), xycoords="axes fraction", fontsize="small")
    axes.set(ylim=(0, outlines["reach"]), xticks=np.radians(np.arange(0, 360, 45)), yticks=outlines["rings"])
    axes.set_yticklabels([f"{ring:g}" for ring in outlines["rings"]])
    axes.set_rlabel_position(22.5)
    axes.grid(color=grey, linewidth=thin)
    axes.spines["polar"].set_visible(False)

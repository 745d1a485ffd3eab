"""Draws what the library describes of a figure (`describe`): panels of series, bars and bands with their errors, and roses.

A description says what is shown, as the page has it: axes with labels, units and scales, series with their values and errors, lines of
reference, and a key with numbers. This file chooses sizes, marks and colours, and nothing else.
"""

import functools
import math

import numpy as np
from matplotlib.lines import Line2D
from matplotlib.patches import Patch

from .. import _core
from .parts import State
from .style import colours, crack_colours, label, set_colours, soft, strong, tension, weak

plain_roles = {
    "strong": strong,
    "weak": weak,
    "soft": soft,
    "wall": soft,
    "fit": weak,
    "accent": colours[1],
    "tension": tension,
}
styles = {"solid": "-", "dashed": "--", "dotted": ":"}
key_line, letter = 0.155, 0.062  # inches: a line of the key, a letter of it


@functools.lru_cache(maxsize=1)
def heads():
    """What is said of every figure: {"stage" | "field" | "film": [{"id", "name", "title", "caption", "choices"}]}."""
    return _core._figure_heads()


_known = {}  # of the last part alone


def describe(part):
    """What every figure of a State, a Stage (its last state), a Field or a FilmResult shows, by the figures' ids: [{"panels" | "roses", "key", "for"}]."""
    if id(part) not in _known:
        _known.clear()
        _known[id(part)] = (part, _describe(part))
    return _known[id(part)][1]


def _describe(part):
    if isinstance(part, _core.Stage):
        part = State(part.name, part, part.snapshots[-1], list(part.snapshots))
    if isinstance(part, State):
        return _core._figures_of_state(part.stage, part.snapshot, part.snapshots, part.stages)
    return (_core._figures_of_field if isinstance(part, _core.Field) else _core._figures_of_film)(part)


def colour_of_role(role):
    """The colour of a role, "strong", "material 0", "set matrix"."""
    name, _, which = role.partition(" ")
    if name == "set":
        return set_colours[which]
    if name == "crack":
        return crack_colours[int(which)][1]
    if name in ("material", "mixed", "line"):
        return colours[(int(which) + 2 * (name == "mixed")) % len(colours)]
    return plain_roles[name]


def _numbers(values):
    return np.array([np.nan if v is None else v for v in values], float)


def draw_series(axes, series, is_log=False):
    """One series of a panel."""
    x, y = _numbers(series["x"]), _numbers(series["y"])
    colour, weight, alpha = colour_of_role(series["colour"]), series.get("weight", 1), series.get("opacity", 1)
    low, high = (_numbers(series[name]) if name in series else None for name in ("low", "high"))
    if "bars" in series:
        base = 0 if low is None else low
        axes.bar(
            x, (y if high is None else high) - base, series["bars"], bottom=base, color=colour, alpha=alpha, linewidth=0
        )
        return
    if low is not None:
        axes.fill_between(x, low, high, color=colour, alpha=alpha, linewidth=0)
        return
    if "error" in series:
        error = np.nan_to_num(_numbers(series["error"]))
        least = np.minimum(error, 0.95 * np.abs(y)) if is_log else error
        axes.errorbar(x, y, yerr=[least, error], fmt="none", ecolor=colour, elinewidth=0.6, alpha=0.6 * alpha)
    if "line" in series:
        steps = {"drawstyle": "steps-post"} if series.get("steps") else {}
        axes.plot(x, y, styles[series["line"]], color=colour, linewidth=1.1 * weight, alpha=alpha, **steps)
    if series.get("points"):
        axes.plot(x, y, "o", color=colour, markersize=2.9 * weight, alpha=alpha, markeredgewidth=0)


def _draw_bars_that_lie(axes, panel):
    for series in panel["series"]:
        axes.barh(
            _numbers(series["x"]),
            _numbers(series["y"]),
            series["bars"],
            xerr=np.nan_to_num(_numbers(series.get("error", [0]))),
            color=colour_of_role(series["colour"]),
            alpha=series.get("opacity", 1),
            error_kw={"elinewidth": 0.8},
        )
    names = panel["y"]["names"]
    axes.set(yticks=range(len(names)), yticklabels=[label(name) for name in names], xlabel=worded(panel["x"]))
    axes.set_ylim(len(names) - 0.4, -0.6)
    axes.tick_params(axis="y", length=0)


def worded(axis):
    """The label of an axis with its unit."""
    return label(", ".join(filter(None, [axis.get("label", ""), axis.get("unit")])))


def draw_panel(axes, panel):
    """One panel of a description on these axes."""
    if panel.get("lying"):
        _draw_bars_that_lie(axes, panel)
        return
    for reference in panel.get("references", []):
        style = {
            "color": colour_of_role(reference["colour"]),
            "linestyle": styles[reference["line"]],
            "linewidth": 0.7,
            "zorder": 0,
        }
        axes.axvline(reference["x"], **style) if "x" in reference else axes.axhline(reference["y"], **style)
    for series in panel["series"]:
        draw_series(axes, series, panel["y"].get("log", False))
    for name in "xy":
        axis = panel[name]
        axes.set(**{f"{name}label": worded(axis), f"{name}scale": "log" if axis.get("log") else "linear"})
        axes.set(**{f"{name}lim": (axis.get("low"), axis.get("high"))})
    if _is_whole(panel):
        axes.xaxis.get_major_locator().set_params(integer=True)
    for row, line in enumerate(panel.get("corner", [])):
        axes.annotate(
            label(line),
            (0, 1),
            xycoords="axes fraction",
            xytext=(5, -5 - 9 * row),
            textcoords="offset points",
            va="top",
            fontsize="small",
        )


def _is_whole(panel):
    return (
        "unit" not in panel["x"]
        and not panel["x"].get("log")
        and all(float(x).is_integer() for series in panel["series"] for x in series["x"] if x is not None)
    )


def draw_rose(axes, rose):
    """A polar histogram over the isotropic fraction (T Fig. 3.8) with its line 1 + a cos 2(angle - direction); `axes` are polar."""
    sectors, colour = _numbers(rose["sectors"]), colour_of_role(rose["colour"])
    step = 180 / len(sectors)
    isotropic, angle = rose["count"] / len(sectors), np.radians(np.arange(0.5 * step, 360, step))
    for name, alpha in (("sectors", 0.35 if "inner" in rose else 0.5), ("inner", 0.75)):
        if name in rose:
            axes.bar(
                angle,
                np.tile(_numbers(rose[name]), 2) / isotropic,
                width=np.radians(0.9 * step),
                color=colour,
                alpha=alpha,
                linewidth=0,
            )
    line = np.linspace(0, 2 * np.pi, 361)
    axes.plot(line, np.ones_like(line), linestyle=":", color=weak, linewidth=0.8)
    if "amplitude" in rose:
        turned = np.cos(2 * (line - np.radians(rose["direction"])))
        axes.plot(line, 1 + rose["amplitude"] * turned, color=strong, linewidth=0.9)
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
    axes.grid(color="#e0e0e0", linewidth=0.4)
    axes.spines["polar"].set(color="#e0e0e0", linewidth=0.4)
    axes.set_title(label(f"{rose['name']} ({rose['count']:.0f})"), pad=12)
    axes.set_xlabel(label("\n".join(rose["words"])), labelpad=3)


def key_entries(drawing):
    """[(handle, text)] of the key, with its numbers."""
    return [(_handle(entry, drawing.get("panels", [])), _words(entry, drawing)) for entry in drawing.get("key", [])]


def _words(entry, drawing):
    name = entry["name"]
    if "counts" in entry:
        name += f" {drawing['panels'][0]['series'][entry['counts']]['y'][-1]:.0f}"
    numbers = [f"{of} = {value}" + (f" ± {error}" if error else "") for of, value, error in entry.get("numbers", [])]
    return label(", ".join([name, *numbers]))


def _handle(entry, panels):
    """As the series of this colour are drawn."""
    colour = colour_of_role(entry["colour"])
    if entry.get("line"):
        return Line2D([], [], color=colour, linestyle=styles[entry["line"]])
    drawn = [one for panel in panels for one in panel["series"] if one["colour"] == entry["colour"]]
    alike = [one for one in drawn if "silent" not in one] or drawn
    if alike and ("bars" in alike[0] or ("low" in alike[0] and "line" not in alike[0])):
        return Patch(facecolor=colour, alpha=alike[0].get("opacity", 1))
    has_line = any("line" in one for one in alike) or not alike
    has_points = any(one.get("points") for one in alike)
    return Line2D(
        [], [], color=colour, linestyle="-" if has_line else "", marker="o" if has_points else "", markersize=3
    )


def _length(words):
    """Of a label in letters, without its marks."""
    return len("".join(c for c in words.replace("\\mathrm", "") if c not in "${}_\\^"))


def _columns(entries, width):
    longest = max(_length(words) for _, words in entries)
    return max(1, min(len(entries), int(width / (letter * longest + 0.45))))


def _draw_key(axes, entries, columns):
    axes.axis("off")
    shown = axes.legend(
        [handle for handle, _ in entries],
        [words for _, words in entries],
        loc="center",
        ncols=columns,
        columnspacing=1,
        handlelength=1.5,
        handletextpad=0.4,
        borderpad=0,
        labelspacing=0.25,
    )
    shown.set_in_layout(False)


def draw_described(figure, drawings):
    """One figure of a description: a row for each of its drawings with several panels, drawings of one panel beside each other. Sets the
    figure's height."""
    if "roses" in drawings[0]:
        draw_roses(figure, drawings[0]["roses"])
        return
    single = all(len(drawing["panels"]) == 1 for drawing in drawings)
    rows = [drawings] if single else [[drawing] for drawing in drawings]
    columns = len(drawings) if single else len(drawings[0]["panels"])
    width = figure.get_figwidth()
    key_width = width / len(rows[0])
    keys = [[key_entries(drawing) for drawing in row] for row in rows]
    counts = [[_columns(key, key_width) if key else 1 for key in row] for row in keys]
    lines = [max(math.ceil(len(key) / n) for key, n in zip(row, ns)) for row, ns in zip(keys, counts)]
    panel_height = _height(drawings[0]["panels"][0], width / columns)
    heights = [h for n in lines for h in (key_line * n + 0.04 * (n > 0) + 1e-3, panel_height)]
    figure.set_size_inches(width, sum(heights) + 0.05)
    grid = figure.add_gridspec(2 * len(rows), columns, height_ratios=heights)
    for r, row in enumerate(rows):
        span = columns // len(row)
        panels = [panel for drawing in row for panel in drawing["panels"]]
        for c, panel in enumerate(panels):
            draw_panel(figure.add_subplot(grid[2 * r + 1, c]), panel)
        for c, (key, n) in enumerate(zip(keys[r], counts[r])):
            if key:
                _draw_key(figure.add_subplot(grid[2 * r, c * span : (c + 1) * span]), key, n)


def _height(panel, width):
    if panel.get("lying"):
        return 0.2 * len(panel["y"]["names"]) + 0.55
    return width * (0.92 if panel.get("square") else 0.78)


def draw_roses(figure, roses):
    columns = min(3, len(roses))
    rows = -(-len(roses) // columns)
    width = figure.get_figwidth()
    figure.set_size_inches(width, rows * (width / columns + 0.35) * (1 if columns > 1 else 1.05))
    if figure.get_layout_engine():  # room for the words above and below, which are wider than the circles are apart
        figure.get_layout_engine().set(w_pad=0.035 * width)
    for k, rose in enumerate(roses):
        draw_rose(figure.add_subplot(rows, columns, k + 1, projection="polar"), rose)

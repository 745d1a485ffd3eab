"""Draws what the library describes of a figure (`describe`): panels of series, bars and bands with their errors, and
roses.

A description says what is shown, as the page has it: axes with labels, units and scales, series with their values and
errors, lines of reference, and a key with numbers. This file chooses sizes, marks and colours, and nothing else.
"""

import functools
import math
import textwrap

import numpy as np
from matplotlib.lines import Line2D
from matplotlib.patches import Patch

from .. import _core
from .parts import State
from .polar import draw_hemispheres, draw_outlines, draw_roses
from .style import colour_of_role, even_map, label, line_styles, note, numbers

markers = {"diamond": "D", "times": "x", "plus": "+"}
band_opacity = 0.25
many = 200  # points, of which each is small
key_line, letter = 0.155, 0.062  # inches: a line of the key, a letter of it
note_line, small_letter = 0.13, 0.055  # of a note


@functools.lru_cache(maxsize=1)
def heads():
    """What is said of every figure, by kind: [{"id", "name", "title", "caption", "choices"}]."""
    return _core._figure_heads()


_known = {}  # of the last part alone


def describe(part):
    """What every figure of a part of a result shows, of a Stage its last state: {id: [{"panels" | "roses", "key"}]}."""
    if id(part) not in _known:
        _known.clear()
        _known[id(part)] = (part, _describe(part))
    return _known[id(part)][1]


def _describe(part):
    if isinstance(part, _core.Stage):
        part = State(part.name, part, part.snapshots[-1], [part])
    if isinstance(part, State):
        return _core._figures_of_state(part.stage, part.snapshot, part.stages, part.stages)
    return _core._figures_of_part(part)


def draw_series(axes, series, is_log=False):
    """One series of a panel."""
    x, y = numbers(series["x"]), numbers(series["y"])
    colour, weight, alpha = colour_of_role(series["colour"]), series.get("weight", 1), series.get("opacity", 1)
    low, high = (numbers(series[name]) if name in series else None for name in ("low", "high"))
    if "bars" in series:
        base = 0 if low is None else low
        axes.bar(
            x, (y if high is None else high) - base, series["bars"], bottom=base, color=colour, alpha=alpha, linewidth=0
        )
        return
    if low is not None:
        axes.fill_between(x, low, high, color=colour, alpha=band_opacity if "line" in series else alpha, linewidth=0)
        if "line" not in series:
            return
    elif "error" in series:
        error = np.nan_to_num(numbers(series["error"]))
        least = np.minimum(error, 0.95 * np.abs(y)) if is_log else error
        axes.errorbar(x, y, yerr=[least, error], fmt="none", ecolor=colour, elinewidth=0.6, alpha=0.6 * alpha)
    if "line" in series:
        steps = {"drawstyle": "steps-post"} if series.get("steps") else {}
        axes.plot(x, y, line_styles[series["line"]], color=colour, linewidth=1.1 * weight, alpha=alpha, **steps)
    if series.get("points"):
        mark = _mark(series.get("mark"), weight if len(x) < many else 0.5 * weight)
        axes.plot(x, y, color=colour, alpha=alpha, **mark)


def _mark(mark, weight=1):
    """Of points: a dot, or another mark."""
    style = {"linestyle": "", "marker": markers.get(mark, "o"), "markersize": 2.9 * weight, "markeredgewidth": 0}
    if mark in ("times", "plus"):
        return {**style, "markersize": 4 * weight, "markeredgewidth": 0.8}
    return {**style, "markerfacecolor": "white", "markeredgewidth": 0.6} if mark == "hollow" else style


def _draw_bars_that_lie(axes, panel):
    for series in panel["series"]:
        axes.barh(
            numbers(series["x"]),
            numbers(series["y"]),
            series["bars"],
            xerr=np.nan_to_num(numbers(series.get("error", [0]))),
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
        _draw_reference(axes, reference)
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
            bbox={"facecolor": "white", "edgecolor": "none", "alpha": 0.85, "pad": 0.5},
        )


def _draw_reference(axes, reference):
    """A line across, an upright one, one through the origin, or a cross, with what is said there."""
    x, y, words = reference.get("x"), reference.get("y"), label(reference.get("label", ""))
    style = {"color": colour_of_role(reference["colour"]), "linewidth": 0.7, "zorder": 0}
    style["linestyle"] = line_styles[reference["line"]]
    if "slope" in reference:
        axes.axline((0, 0), slope=reference["slope"], **style)
    elif x is not None and y is not None:
        axes.plot([x], [y], "x", color=style["color"], markersize=4)
        note(axes, words, (x, y), "data", (0, 4), ha="center")
    elif y is not None:
        axes.axhline(y, **style)
        note(axes, words, (1, y), ("axes fraction", "data"), (-2, 1.5), ha="right", va="bottom")
    else:
        axes.axvline(x, **style)
        note(axes, words, (x, 1), ("data", "axes fraction"), (-1.5, -3), rotation=90, ha="right", va="top")


def draw_cells(axes, cells):
    """A number over two others as colour, and written."""
    columns, rows = cells["x"]["names"], cells["y"]["names"]
    values = numbers(cells["values"]).reshape(len(rows), len(columns))
    shown = axes.imshow(values, origin="lower", aspect="auto", cmap=even_map)
    for row, column in np.argwhere(np.isfinite(values)):
        ink = "white" if shown.norm(values[row, column]) < 0.55 else "black"
        words = f"{values[row, column]:.3g}".replace("-", "\u2212")
        axes.text(column, row, words, ha="center", va="center", fontsize="x-small", color=ink)
    axes.set_xticks(range(len(columns)), columns)
    axes.set_yticks(range(len(rows)), [label(name) for name in rows])
    axes.set_xlabel(worded(cells["x"]))
    axes.tick_params(top=False, right=False, length=0)


def _is_whole(panel):
    return (
        "unit" not in panel["x"]
        and not panel["x"].get("log")
        and all(float(x).is_integer() for series in panel["series"] for x in series["x"] if x is not None)
    )


def key_entries(drawing):
    """[(handle, text)] of the key, with its numbers."""
    return [(_handle(entry, drawing.get("panels", [])), _words(entry, drawing)) for entry in drawing.get("key", [])]


def _words(entry, drawing):
    name = entry.get("name", "")
    if "counts" in entry:
        name += f" {drawing['panels'][0]['series'][entry['counts']]['y'][-1]:.0f}"
    numbers = [f"{of} = {value}" + (f" ± {error}" if error else "") for of, value, error in entry.get("numbers", [])]
    return label(", ".join([name, *numbers]))


def _handle(entry, panels):
    """As the series of this colour are drawn."""
    colour = colour_of_role(entry["colour"])
    if "mark" in entry:
        return Line2D([], [], color=colour, **_mark(entry["mark"]))
    if entry.get("line"):
        return Line2D([], [], color=colour, linestyle=line_styles[entry["line"]])
    drawn = [one for panel in panels for one in panel["series"] if one["colour"] == entry["colour"]]
    alike = [one for one in drawn if "silent" not in one] or drawn
    if alike and ("bars" in alike[0] or ("low" in alike[0] and "line" not in alike[0])):
        return Patch(facecolor=colour, alpha=alike[0].get("opacity", 1))
    has_line = any("line" in one for one in alike) or not alike
    has_points = any(one.get("points") for one in alike)
    mark = _mark(next((one.get("mark") for one in alike if one.get("points")), None)) if has_points else {}
    return Line2D([], [], color=colour, **{**mark, "linestyle": "-" if has_line else ""})


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
    """One figure of a description: a row for each of its drawings with several panels, drawings of one panel beside
    each other. Sets the figure's height."""
    first = drawings[0]
    if "roses" in first:
        draw_roses(figure, first["roses"])
    elif "hemispheres" in first:
        draw_hemispheres(figure, first["hemispheres"])
    elif "panels" in first:
        _draw_panels(figure, drawings)
    else:
        _draw_alone(figure, first)
    _write_notes(figure, [drawing["note"] for drawing in drawings if "note" in drawing])


def _write_notes(figure, notes):
    """Below everything, what is not drawn and why."""
    width, height = figure.get_size_inches()
    if lines := [line for one in notes for line in textwrap.wrap(one, int(width / small_letter))]:
        figure.set_size_inches(width, height + note_line * len(lines))
        figure.supxlabel(label("\n".join(lines)), x=0.02, ha="left", fontsize="small")


def _draw_alone(figure, drawing):
    """Outlines or cells, below their key."""
    of_outlines = "outlines" in drawing
    width, entries = figure.get_figwidth(), key_entries(drawing)
    columns = _columns(entries, width) if entries else 1
    lines = math.ceil(len(entries) / columns)
    heights = [key_line * lines + 0.04 * (lines > 0) + 1e-3, width * (0.95 if of_outlines else 0.75)]
    figure.set_size_inches(width, sum(heights) + 0.05)
    grid = figure.add_gridspec(2, 1, height_ratios=heights)
    if entries:
        _draw_key(figure.add_subplot(grid[0]), entries, columns)
    if of_outlines:
        draw_outlines(figure.add_subplot(grid[1], projection="polar"), drawing["outlines"])
    else:
        draw_cells(figure.add_subplot(grid[1]), drawing["cells"])


def _draw_panels(figure, drawings):
    single = all(len(drawing["panels"]) == 1 for drawing in drawings)
    rows = [drawings] if single else [[drawing] for drawing in drawings]
    columns = len(drawings) if single else len(drawings[0]["panels"])
    width = figure.get_figwidth()
    keys = [[key_entries(drawing) for drawing in row] for row in rows]
    counts = [[_columns(key, width / len(rows[0])) if key else 1 for key in row] for row in keys]
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

"""Figures of a study, from the numbers that the program writes beside its page study.html, so that print and page agree."""

import pathlib
import re

import matplotlib
import numpy as np
from matplotlib.collections import LineCollection, PatchCollection
from matplotlib.colors import ListedColormap
from matplotlib.patches import Circle

from .. import _core
from .fields import crack_dots
from .style import bare, colours, label, length_bar, phase_colours, plain, soft, strong

stress_map, most_stress, most_stress_of_nodes = "magma_r", 3, 2


def page_of(path):
    path = pathlib.Path(path)
    return path / "study.html" if path.is_dir() else path


def has_page(path):
    """Whether a study has a page with figures."""
    return page_of(path).is_file()


def study_document(path):
    """The contents of the page of a study, as a dict: `title` and `figures`; `path` is the page or the study's folder."""
    page = page_of(path)
    document = _core._study_figures(page)
    if not document:
        if has_page(path):  # of an older program, or taken out of its folder
            raise ValueError(
                f"{page}: the numbers of its figures, study.hdf5, are missing beside it; give the study's folder, in which `arenite study page RECIPE --out FOLDER` makes both"
            )
        raise ValueError(
            f"{page}: this study has no page yet; `arenite study page RECIPE --out {page.parent}` makes it"
        )
    return document


def is_study(path):
    """Whether it is a study's folder or its page."""
    path = pathlib.Path(path)
    return (path / "study.html").is_file() or (path / "runs.tsv").is_file() or path.name == "study.html"


def not_drawn(path):
    """{name: reason} of the figures of a study that cannot be drawn yet, or only in part."""
    return (
        {figure["id"]: figure["missing"] for figure in study_document(path)["figures"] if "missing" in figure}
        if is_study(path) and has_page(path)
        else {}
    )


def _colours(figure):
    """As on the page: shades if curves are values of one key, distinct colours otherwise."""
    ours = [curve for curve in figure["series"] if not curve["beside"] and not curve["source"]]
    groups = list(dict.fromkeys(curve["group"] for curve in ours))
    if figure["ordered"] and len(groups) > 2:
        shades = matplotlib.colormaps["viridis"](np.linspace(0, 0.9, len(groups)))
        return [strong if curve["beside"] else shades[groups.index(curve["group"])] for curve in figure["series"]]
    simulated = max(1, sum(not curve["film"] and not curve["fit"] for curve in ours))
    place = [
        curve["group"]
        if figure["ordered"]
        else curve["part"] % simulated
        if _is_hollow(figure, curve)
        else curve["part"]
        for curve in figure["series"]
    ]
    return [strong if curve["beside"] else colours[k % len(colours)] for curve, k in zip(figure["series"], place)]


def _is_hollow(figure, curve):
    """In a plot the points of a film have the colour of the simulated ones and are hollow."""
    return curve["film"] and not curve["source"] and figure["kind"] == "plot"


def _legend(axes, figure):
    """Inside the axes if there is room, above them if it is long."""
    names = [curve["name"] for curve in figure["series"] if curve["name"] and not curve["fit"]]
    if len(names) > 4:
        longest = max(len(re.sub(r"[_^{}]", "", name)) for name in names)
        axes.legend(
            loc="lower center",
            bbox_to_anchor=(0.5, 1),
            ncols=3 if longest < 14 else 2,
            columnspacing=1,
            handlelength=1.4,
        )
    elif names:
        axes.legend(handlelength=1.6)


def draw_study_plot(axes, figure):
    """Points with error bars, densities with error bands, their fits and the source's tables; statements of its text are drawn in grey."""
    for curve, colour in zip(figure["series"], _colours(figure)):
        points = np.array([[np.nan if v is None else v for v in point] for point in curve["points"]], float).T
        if curve["fit"]:
            axes.plot(*points[:2], ":" if curve["film"] else "--", color=strong, linewidth=1.0)
        elif curve["source"]:
            axes.plot(
                *points[:2],
                "+" if curve["film"] else "x",
                color=colour,
                markersize=4,
                markeredgewidth=0.8,
                label=label(curve["name"]),
            )
        elif figure["density"] and figure["lines"]:
            _density(axes, figure, curve, points, colour)
        else:
            _points(axes, figure, curve, points, colour)
    for axis in "xy":
        about = figure[axis]
        axes.set(
            **{
                f"{axis}label": label(about["label"]),
                f"{axis}scale": "log" if about["log"] else "linear",
                f"{axis}lim": about["domain"],
            }
        )
    for reference in figure["references"]:
        _reference(axes, reference)
    _legend(axes, figure)


def _style(figure, curve):
    return "--" if figure["ordered"] and curve["part"] > 0 else "-"


def _density(axes, figure, curve, points, colour):
    """A line in its error band; a bin between empty ones is a dot."""
    x, y, error = points
    axes.plot(x, y, _style(figure, curve), color=colour, label=label(curve["name"]) or None, linewidth=1.0)
    if error.any():
        low = np.maximum(y - error, figure["y"]["domain"][0]) if figure["y"]["log"] else y - error
        axes.fill_between(x, low, y + error, color=colour, alpha=0.25, linewidth=0)
    unknown = np.isnan(np.concatenate([[np.nan], y, [np.nan]]))
    alone = unknown[:-2] & unknown[2:] & ~np.isnan(y)
    axes.plot(x[alone], y[alone], ".", color=colour, markersize=2)
    if error[alone].any():
        axes.vlines(
            x[alone],
            np.maximum(y - error, figure["y"]["domain"][0])[alone],
            (y + error)[alone],
            color=colour,
            linewidth=0.6,
        )


def _points(axes, figure, curve, points, colour):
    """Points with error bars, joined if the figure says so; those of `beside` are diamonds."""
    x, y, error = points
    low = np.minimum(error, 0.95 * y) if figure["y"]["log"] else error
    joined = figure["lines"] and not (curve["beside"] and np.all(x == x[0]))
    axes.errorbar(
        x,
        y,
        yerr=[low, error] if error.any() else None,
        fmt=("D" if curve["beside"] else "o") + (_style(figure, curve) if joined else ""),
        color=colour,
        markersize=2.4 if len(x) < 200 else 1,
        elinewidth=0.6,
        linewidth=0.9,
        markerfacecolor="white" if _is_hollow(figure, curve) else colour,
        markeredgewidth=0.6,
        label=label(curve["name"]) or None,
    )


def _reference(axes, reference):
    x, y, text = reference.get("x"), reference.get("y"), label(reference["label"])
    line, note = {"color": soft, "linestyle": ":", "linewidth": 0.9, "zorder": 0}, {
        "color": "#606060",
        "fontsize": 6,
        "bbox": {"facecolor": "white", "edgecolor": "none", "alpha": 0.75, "pad": 0.3},
    }
    if "slope" in reference:
        axes.axline((0, 0), slope=reference["slope"], **line)
    elif x is not None and y is not None:
        axes.plot([x], [y], "x", color="#707070", markersize=4)
        axes.annotate(text, (x, y), xytext=(0, 4), textcoords="offset points", ha="center", **note)
    elif y is not None:
        axes.axhline(y, **line)
        axes.annotate(
            text,
            (1, y),
            xycoords=("axes fraction", "data"),
            xytext=(-2, 1.5),
            textcoords="offset points",
            ha="right",
            va="bottom",
            **note,
        )
    else:
        axes.axvline(x, **line)
        axes.annotate(
            text,
            (x, 1),
            xycoords=("data", "axes fraction"),
            xytext=(-1.5, -3),
            textcoords="offset points",
            rotation=90,
            ha="right",
            va="top",
            **note,
        )


def draw_study_rose(axes, figure):
    """Outlines of the numbers of contacts in sectors, or of their fractions over the isotropic one, which is dotted, with error ticks; `axes` are polar."""
    for place, (curve, colour) in enumerate(zip(figure["series"], _colours(figure))):
        middle, share, error = np.array(curve["points"], float).T
        half = 180 / (2 * len(middle))
        angle = np.concatenate([turn + np.column_stack([middle - half, middle + half]).ravel() for turn in (0, 180)])
        radius = np.tile(np.repeat(share, 2), 2)
        dashed = figure["ordered"] and curve["part"] > 0
        axes.plot(
            np.radians(np.append(angle, angle[0])),
            np.append(radius, radius[0]),
            "--" if dashed else "-",
            color=colour,
            label=label(curve["name"]) or None,
            linewidth=0.9,
        )
        if error.any():
            aside = 0.4 * half * (place % 4 - 1.5)  # curves' ticks stand beside each other
            for turn in (0, 180):
                axes.vlines(
                    np.radians(turn + middle + aside),
                    np.maximum(0, share - error),
                    share + error,
                    color=colour,
                    linewidth=0.6,
                )
    if figure["counts"]:
        axes.annotate("$N_c$", (0, 0), xycoords="axes fraction", ha="left", va="bottom", fontsize=7)
    else:
        axes.plot(np.linspace(0, 2 * np.pi, 181), np.ones(181), ":", color=soft, linewidth=0.8)
    axes.set_ylim(bottom=0)
    axes.set_xticks(np.radians(np.arange(0, 360, 45)))
    axes.set_rlabel_position(22.5)
    axes.yaxis.get_major_locator().base.set_params(nbins=4)
    axes.grid(color="#e0e0e0", linewidth=0.4)
    axes.spines["polar"].set_visible(False)
    if any(curve["name"] for curve in figure["series"]):
        axes.legend(loc="upper center", bbox_to_anchor=(0.5, -0.06), ncols=2, columnspacing=1, handlelength=1.4)


def draw_study_map(axes, figure):
    """A number over two swept keys, with its value in every cell."""
    columns = sorted({point[0] for curve in figure["series"] for point in curve["points"]})
    values = np.full((len(figure["series"]), len(columns)), np.nan)
    for row, curve in enumerate(figure["series"]):
        for x, value, _ in curve["points"]:
            values[row, columns.index(x)] = value
    shown = axes.imshow(values, origin="lower", aspect="auto", cmap="viridis")
    for row, column in np.argwhere(np.isfinite(values)):
        dark = shown.norm(values[row, column]) < 0.55
        axes.text(
            column,
            row,
            f"{values[row, column]:.3g}",
            ha="center",
            va="center",
            fontsize=6,
            color="white" if dark else "black",
        )
    axes.set_xticks(range(len(columns)), [f"{x:.3g}" for x in columns])
    axes.set_yticks(range(len(figure["series"])), [label(curve["name"]) for curve in figure["series"]])
    axes.set_xlabel(label(figure["x"]["label"]))
    axes.tick_params(top=False, right=False, length=0)


def draw_study_sample(axes, sample):
    """Grains by material, with their forces, or by their stress over the mean; returns what a colour bar needs, or None."""
    x, y, r = (1e-3 * np.array(sample[name]) for name in ("x", "y", "r"))
    disks = PatchCollection([Circle((a, b), c) for a, b, c in zip(x, y, r)], linewidth=0.15, edgecolor=strong)
    by_stress = "stress" in sample
    if by_stress:
        disks.set(array=np.array(sample["stress"]), cmap=stress_map, clim=(0, most_stress))
    else:
        disks.set_facecolor([colours[m % len(colours)] for m in sample["material"]])
        disks.set_alpha(0.25 if "f" in sample else 0.8)
    axes.add_collection(disks)
    glued = [Circle((a, b), c) for a, b, c, g in zip(x, y, r, sample["glued"]) if g]
    axes.add_collection(PatchCollection(glued, facecolor="none", edgecolor="#d55e00", linewidth=0.7))
    if "f" in sample:
        _chains(axes, sample, x, y, r)
    width, height = (1e-3 * side for side in sample["size"])
    axes.set(xlim=(0, width), ylim=(-0.07 * height, height))
    length_bar(axes, width, 0, -0.055 * height)
    bare(axes)
    _material_key(axes, sample)
    return disks if by_stress else None


def _chains(axes, sample, x, y, r):
    """Lines between centres; the mean force is a quarter as wide as a mean grain's radius."""
    force, i, j = np.array(sample["f"]), np.array(sample["i"]), np.array(sample["j"])
    points = 72 * axes.figure.get_figwidth() / (1e-3 * sample["size"][0])  # of print to a metre, about
    widths = np.maximum(0.05, 0.25 * r.mean() * points * np.abs(force))
    lines = np.stack([np.column_stack([x[i], y[i]]), np.column_stack([x[j], y[j]])], axis=1)
    axes.add_collection(
        LineCollection(lines, linewidths=widths, colors=np.where(force < 0, "#cc79a7", strong), capstyle="round")
    )


def _material_key(axes, sample):
    names = [(m, name) for m, name in enumerate(sample.get("materials", [])) if m in sample["material"]]
    if "stress" in sample or len(names) < 2:
        return
    handles = [
        axes.plot([], [], "o", color=colours[m % len(colours)], alpha=0.8, label=plain(name))[0] for m, name in names
    ]
    axes.legend(
        handles=handles,
        loc="upper right",
        bbox_to_anchor=(1, 0.005),
        ncols=len(handles),
        handletextpad=0.1,
        columnspacing=0.8,
        borderpad=0,
    )


def draw_study_nodes(axes, sample):
    """Phases of a sample on its nodes, or the stress in and around one grain; returns what a colour bar needs, or None."""
    columns, rows = sample["nodes"]
    width, height = (1e-3 * side for side in sample["size"])
    extent = {"extent": (0, width, 0, height), "interpolation": "nearest", "rasterized": True}
    shown = None
    if "stress" in sample:
        values = np.array([np.nan if v is None else v for v in sample["stress"]]).reshape(rows, columns)
        shown = axes.imshow(values, cmap=stress_map, vmin=0, vmax=most_stress_of_nodes, **extent)
        _edges(axes, sample["edges"], width / columns, height)
    else:
        runs = np.array(sample["phases"]).reshape(-1, 2)
        palette = ListedColormap([phase_colours[name] for name in ("void", "matrix", "particle", "small", "large")])
        axes.imshow(
            np.repeat(runs[:, 0], runs[:, 1]).reshape(rows, columns), cmap=palette, vmin=-0.5, vmax=4.5, **extent
        )
        if "cracks" in sample:
            x, y, kinds = (np.array(sample["cracks"][name]) for name in ("x", "y", "type"))
            crack_dots(axes, width / columns * x, height - width / columns * y, kinds)
    axes.set_ylim(-0.08 * height, height)
    length_bar(axes, width, 0, -0.06 * height)
    bare(axes)
    return shown


def _edges(axes, edges, side, height):
    x, y, upright = np.array(edges, float).T
    start = np.column_stack([x * side, height - y * side])
    end = start + side * np.column_stack([1 - upright, -upright])
    axes.add_collection(LineCollection(np.stack([start, end], axis=1), colors=strong, linewidths=0.6))


def draw_study_figure(canvas, figure):
    """Draws one figure of `study_document` on an empty matplotlib figure."""
    if figure["kind"] == "rose":
        draw_study_rose(canvas.add_subplot(projection="polar"), figure)
    elif figure["kind"] == "map":
        draw_study_map(canvas.add_subplot(), figure)
    elif "sample" in figure:
        axes = canvas.add_subplot()
        shown = (draw_study_nodes if "nodes" in figure["sample"] else draw_study_sample)(axes, figure["sample"])
        if shown is not None:
            component = (
                r"$\sigma_{yy}/\langle\sigma_{yy}\rangle$" if "nodes" in figure["sample"] else r"$\sigma_{norm}$"
            )
            canvas.colorbar(shown, ax=axes, shrink=0.8, label=component, extend="max")
    else:
        draw_study_plot(canvas.add_subplot(), figure)


def has_content(figure):
    """Whether there is anything to draw so far."""
    return bool(figure["series"] or "sample" in figure)


def height_of(figure):
    """A suitable height over width."""
    if "sample" in figure:
        across, up = figure["sample"]["size"]
        bar = "stress" in figure["sample"]
        return min(1.6, (0.82 if bar else 1.08) * up / across + 0.02)
    return 1.05 if figure["kind"] == "rose" else 0.8

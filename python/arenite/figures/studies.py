"""Figures of a study, from what the program writes beside its page study.html, so that print and page agree."""

import pathlib

import numpy as np
from matplotlib.collections import LineCollection, PatchCollection, PolyCollection
from matplotlib.patches import Circle, Polygon

from .. import _core
from .drawing import draw_described
from .fields import crack_dots, palette_of
from .packings import bars, kind_colours, kinds_of
from .style import (
    bare,
    colours,
    drawn,
    kinds,
    length_bar,
    most_stress,
    plain,
    sigma_norm,
    stress_map,
    strong,
    widths_of_forces,
)


def page_of(path):
    path = pathlib.Path(path)
    return path / "study.html" if path.is_dir() else path


def has_page(path):
    """Whether a study has a page with figures."""
    return page_of(path).is_file()


def study_document(path):
    """The contents of the page of a study, as a dict: `title` and `figures`; `path` is the page or the study's
    folder."""
    page = page_of(path)
    document = _core._study_figures(page)
    if not document:
        if has_page(path):  # of an older program, or taken out of its folder
            raise ValueError(
                f"{page}: the numbers of its figures, study.hdf5, are missing beside it; give the study's folder, in "
                "which `arenite study page RECIPE --out FOLDER` makes both"
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


def metres(points):
    """Of {"x", "y"} in mm."""
    return 1e-3 * np.column_stack([points["x"], points["y"]])


def _circles(x, y, r):
    return [Circle((a, b), c) for a, b, c in zip(x, y, r)]


def draw_study_sample(axes, sample):
    """Grains by material, with their forces, or by their stress over the mean; returns what a colour bar needs, or
    None."""
    x, y, r = (1e-3 * np.array(sample[name]) for name in ("x", "y", "r"))
    outlines = [Polygon(metres(rim)) for rim in sample.get("rims", [])] or _circles(x, y, r)
    disks = PatchCollection(outlines, linewidth=0.15, edgecolor=strong)
    by_stress = "stress" in sample
    if by_stress:
        disks.set(array=np.array(sample["stress"]), cmap=stress_map, clim=(0, most_stress))
    else:
        disks.set_facecolor([colours[m % len(colours)] for m in sample["material"]])
        disks.set_alpha(0.25 if "f" in sample else 0.8)
    axes.add_collection(disks)
    glued = [outline for outline, is_glued in zip(outlines, sample["glued"]) if is_glued]
    axes.add_collection(PatchCollection(glued, facecolor="none", edgecolor="#d55e00", linewidth=0.7))
    if "f" in sample:
        _chains(axes, sample, x, y, r)
    there = [boundary for boundary in sample.get("boundaries", []) if boundary["present"]]
    lines = [np.vstack([points, points[:1]]) if b["closed"] else points for b in there for points in [metres(b)]]
    axes.add_collection(LineCollection(lines, colors=strong, linewidths=0.9, zorder=3))
    width, height = (1e-3 * side for side in sample["size"])
    axes.set(xlim=(0, width), ylim=(-0.07 * height, height))
    length_bar(axes, width, 0, -0.055 * height)
    bare(axes)
    _material_key(axes, sample)
    return disks if by_stress else None


def _chains(axes, sample, x, y, r):
    """Forces over their mean, as those of a run are drawn."""
    force, i, j = np.array(sample["f"]), np.array(sample["i"]), np.array(sample["j"])
    start, end = np.column_stack([x[i], y[i]]), np.column_stack([x[j], y[j]])
    width, found = widths_of_forces(force, 1, r.mean()), kinds_of(force, (1, sample["tension"]), np.zeros(len(i), bool))
    for kind, colour in kind_colours.items():
        of = found == kind
        if np.any(of):
            axes.add_collection(PolyCollection(bars(start[of], end[of], width[of]), facecolor=colour, linewidth=0))


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
    """Phases of a sample on its nodes, or the stress in and around one grain; returns what a colour bar needs, or
    None."""
    columns, rows = sample["nodes"]
    width, height = (1e-3 * side for side in sample["size"])
    extent = {"extent": (0, width, 0, height), "interpolation": "nearest", "rasterized": True}
    shown = None
    if "stress" in sample:
        values = np.array([np.nan if v is None else v for v in sample["stress"]]).reshape(rows, columns)
        shown = axes.imshow(values, cmap=stress_map, vmin=0, vmax=drawn["most_stress"]["nodes"], **extent)
        _edges(axes, sample["edges"], width / columns, height)
    else:
        runs = np.array(sample["phases"]).reshape(-1, 2)
        nodes = np.repeat(runs[:, 0], runs[:, 1]).reshape(rows, columns)
        axes.imshow(nodes, **palette_of(len(kinds)), **extent)
        if "cracks" in sample:
            x, y, types = (np.array(sample["cracks"][name]) for name in ("x", "y", "type"))
            crack_dots(axes, width / columns * x, height - width / columns * y, types)
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
    """Draws one figure of `study_document` on an empty matplotlib figure: what the library describes, or the picture of
    a run."""
    if "sample" not in figure:
        draw_described(canvas, [figure["drawing"]])
        return
    axes = canvas.add_subplot()
    shown = (draw_study_nodes if "nodes" in figure["sample"] else draw_study_sample)(axes, figure["sample"])
    if shown is not None:
        component = r"$\sigma_{yy}/\langle\sigma_{yy}\rangle$" if "nodes" in figure["sample"] else sigma_norm
        canvas.colorbar(shown, ax=axes, shrink=0.8, label=component, extend="max")


def has_content(figure):
    """Whether there is anything to draw so far."""
    return "drawing" in figure or "sample" in figure


def height_of(figure):
    """A suitable height over width of a picture."""
    if "sample" not in figure:
        return 0.8
    across, up = figure["sample"]["size"]
    return min(1.6, (0.82 if "stress" in figure["sample"] else 1.08) * up / across + 0.02)

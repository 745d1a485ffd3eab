"""Sizes, colours, scales and fonts that figures share."""

import contextlib
import logging
import math
import re

import matplotlib
import numpy as np
from matplotlib.colors import LinearSegmentedColormap
from matplotlib.patches import Patch
from matplotlib.ticker import ScalarFormatter

from .. import _core

inch = 0.0254  # m
column_width, page_width = (width / inch for width in _core._print_widths)  # one and two columns of most journals

# What pictures here and on the page have in common: names of kinds, sizes, ends of scales.
drawn = _core._drawn

# Okabe and Ito's colours, told apart by colour-blind readers and in grey.
colours = ["#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9", "#000000"]
phase_colours = {"void": "#ffffff", "matrix": "#d9c79c", "small": "#7fa8c9", "large": "#2f5f8a", "particle": "#5583ab"}
set_colours = {"all": "#1a1a1a", "large": colours[0], "small": colours[1], "particle": colours[0], "matrix": colours[2]}
crack_colours = [None, "#d62728", "#111111", "#ff9d00"]  # in the order of `drawn["cracks"]`
broken_colours = ["#d81b60", "#e69f00", "#0072b2", "#6a4fb0"]  # bonds, in the order of `breaks`
strong, weak, soft, pale, tension = "#1a1a1a", "#8c8c8c", "#b5b5b5", "#c8c8c8", "#d81b60"

breaks = drawn["breaks"][1:]  # ways in which bonds between grains break, as `broken` counts them from 1
kinds = drawn["kinds"]  # of nodes, in the order of their numbers

most_stress = drawn["most_stress"]["grains"]  # over the mean
stress_map, diverging_map, even_map, picture_map = "magma_r", "RdBu_r", "viridis", "gray"
# No part of it is as pale as what is lost in noise.
cyclic_map = LinearSegmentedColormap.from_list("cyclic", drawn["cyclic"])
# For the scales of colours that the library names.
scale_maps = {
    "even": even_map,
    "stress": stress_map,
    "diverging": diverging_map,
    "cyclic": cyclic_map,
    "grey": picture_map,
}
centred_map, one_sided_map = (scale_maps[drawn["colours"][scale]] for scale in ("centred", "one_sided"))

crack_half, farthest_crack = drawn["crack"]["half"], drawn["crack"]["farthest"]


def widths_of_forces(forces, mean, mean_radius):
    """How wide forces are drawn, in the unit of the mean radius: proportional to them up to a cap."""
    chain = drawn["chain"]
    return mean_radius * np.minimum(chain["widest"], chain["width"] * np.abs(forces) / mean)


sigma_norm = r"$\sigma_{\mathrm{norm}}$"
force_symbols = {"fn": r"F_{\mathrm{n}}", "ft": r"F_{\mathrm{t}}"}


@contextlib.contextmanager
def journal_style(**changes):
    """Settings for print: 8 pt text, thin lines, ticks inwards, fonts embedded as outlines that stay text."""
    settings = {
        "font.size": 8,
        "axes.labelsize": 8,
        "axes.titlesize": 8,
        "xtick.labelsize": 7,
        "ytick.labelsize": 7,
        "legend.fontsize": 7,
        "axes.linewidth": 0.6,
        "lines.linewidth": 1.1,
        "lines.markersize": 3,
        "xtick.direction": "in",
        "ytick.direction": "in",
        "xtick.top": True,
        "ytick.right": True,
        "xtick.major.width": 0.6,
        "ytick.major.width": 0.6,
        "legend.frameon": False,
        # Letters of formulas at their places in Unicode, so that an SVG's text is read with any font.
        "mathtext.fontset": "dejavusans",
        "pdf.fonttype": 42,
        "ps.fonttype": 42,
        "svg.fonttype": "none",
        "svg.hashsalt": "arenite",
        "axes.formatter.use_mathtext": True,
        "savefig.dpi": 600,
        # Figures are laid out by those who make them, whatever the reader's settings say.
        "figure.autolayout": False,
        "figure.constrained_layout.use": False,
        "axes.prop_cycle": matplotlib.cycler(color=colours),
    }
    with matplotlib.rc_context({**settings, **changes}), _quiet("fontTools"):
        yield


@contextlib.contextmanager
def _quiet(name):
    """Suppresses warnings of fontTools about the dates of embedded fonts."""
    logger = logging.getLogger(name)
    before = logger.level
    logger.setLevel(logging.ERROR)
    try:
        yield
    finally:
        logger.setLevel(before)


class PlainTicks(ScalarFormatter):
    """Tick labels as plain text, which is a hundred times faster than a formula; their common power of ten stays a
    formula."""

    def __init__(self):
        super().__init__(useMathText=False)

    def get_offset(self):
        self.set_useMathText(True)
        try:
            return super().get_offset()
        finally:
            self.set_useMathText(False)


def make_ticks_plain(canvas):
    """For all axes of a figure whose ticks have no formatter yet."""
    for axis in (axis for axes in canvas.axes for axis in (axes.xaxis, axes.yaxis)):
        if type(axis.get_major_formatter()) is ScalarFormatter:
            axis.set_major_formatter(PlainTicks())


def plain(name):
    """A name of somebody's as it is, whose dollar signs begin no formula."""
    return name.replace("$", r"\$")


def label(text):
    """ "σ_{norm}" for matplotlib, as the library says that quantities are written; a letter with an index is in
    italics."""

    def formula(match):
        letter, mark, index = match.groups(default="")
        return f"${letter}{mark}\\mathrm{{{index}}}$".replace("%", r"\%").replace("\u2212", "-")

    return re.sub(_core._notation, formula, plain(text))


def unmarked(text):
    """Without the marks of what is lowered or raised."""
    return re.sub(_core._notation, lambda match: (match[1] or "") + match[3], text)


def numbers(values):
    """An array of a list in which None is what is not known."""
    return np.array([np.nan if v is None else v for v in values], float)


plain_roles = {
    "strong": strong,
    "weak": weak,
    "soft": soft,
    "wall": soft,
    "fit": weak,
    "accent": colours[1],
    "tension": tension,
    "source": "#707070",
}
line_styles = {"solid": "-", "dashed": "--", "dotted": ":"}


def colour_of_role(role):
    """The colour of a role of a description, "strong", "material 0", "set matrix"."""
    name, _, which = role.partition(" ")
    if name == "set":
        return set_colours[which]
    if name == "crack":
        return crack_colours[int(which)]
    if name == "broken":
        return broken_colours[int(which)]
    if name == "scale":
        return matplotlib.colormaps[even_map](0.9 * float(which))
    if name in ("material", "mixed", "line"):
        return colours[(int(which) + 2 * (name == "mixed")) % len(colours)]
    return plain_roles[name]


def note(axes, words, at, coordinates, offset, **options):
    """Small words beside something, on a pale patch."""
    patch = {"facecolor": "white", "edgecolor": "none", "alpha": 0.75, "pad": 0.3}
    style = {"color": "#606060", "fontsize": 6, "bbox": patch}
    axes.annotate(words, at, xycoords=coordinates, xytext=offset, textcoords="offset points", **style, **options)


# A factor and the unit with the prefix that makes the largest of numbers a convenient one: (1e3, "kN").
scaled = _core._scale_of


def bare(axes):
    """No frame and no ticks, equal scales: for pictures."""
    axes.set_aspect("equal")
    axes.set_xticks([])
    axes.set_yticks([])
    for spine in axes.spines.values():
        spine.set_visible(False)


def length_bar(axes, metres, left, bottom, unit=None):
    """A scale bar of a round length, about a fifth of `metres`; with a unit given, of that many."""
    known = [(1.0, unit)] if unit else [(1.0, "m"), (1e3, "mm")]
    per, unit = next(
        ((per, name) for per, name in known if unit or per * metres / 5 >= (1 if name == "m" else 0.1)), (1e6, "µm")
    )
    wanted = per * metres / 5
    power = 10 ** math.floor(math.log10(wanted))
    bar = max(step * power for step in (1, 2, 5) if step * power <= wanted)
    axes.plot(
        [left, left + bar / per], [bottom, bottom], color=strong, linewidth=1.5, solid_capstyle="butt", clip_on=False
    )
    axes.text(left, bottom, f"{bar:g} {unit}", ha="left", va="bottom", fontsize="small")


def patch(colour, label):
    """A legend entry: a small coloured area."""
    return Patch(facecolor=colour, edgecolor=strong, linewidth=0.4, label=label)


def key_below(axes, handles, columns=4):
    """A legend below a picture."""
    if handles:
        axes.legend(
            handles=handles,
            loc="upper center",
            bbox_to_anchor=(0.5, 0),
            ncols=min(columns, len(handles)),
            handlelength=1.1,
            handletextpad=0.4,
            columnspacing=1.2,
            borderpad=0.2,
        )

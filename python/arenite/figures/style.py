"""Sizes, colours and fonts that figures share."""

import contextlib
import math

import matplotlib

column_width, page_width = 3.35, 6.9  # inches: 85 mm and 175 mm, one and two columns of most journals

# Okabe and Ito's colours, told apart by colour-blind readers and in grey.
colours = ["#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9", "#000000"]
phase_colours = {"void": "#ffffff", "matrix": "#d9c79c", "small": "#7fa8c9", "large": "#2f5f8a", "particle": "#5583ab"}
strong, weak, soft = "#1a1a1a", "#8c8c8c", "#b5b5b5"


@contextlib.contextmanager
def journal_style(**changes):
    """Settings for print: 8 pt text, thin lines, ticks inwards, fonts embedded as outlines that stay text."""
    settings = {
        "font.size": 8, "axes.labelsize": 8, "axes.titlesize": 8, "xtick.labelsize": 7, "ytick.labelsize": 7, "legend.fontsize": 7,
        "axes.linewidth": 0.6, "lines.linewidth": 1.1, "lines.markersize": 3, "xtick.direction": "in", "ytick.direction": "in",
        "xtick.top": True, "ytick.right": True, "xtick.major.width": 0.6, "ytick.major.width": 0.6, "legend.frameon": False,
        "mathtext.fontset": "cm", "pdf.fonttype": 42, "ps.fonttype": 42, "svg.fonttype": "none", "svg.hashsalt": "arenite", "axes.formatter.use_mathtext": True, "savefig.dpi": 600,
        "axes.prop_cycle": matplotlib.cycler(color=colours),
    }
    with matplotlib.rc_context({**settings, **changes}):
        yield


def estimate(statistic):
    """(value, error) of {"value", "error"}; error 0 where it is not known."""
    return statistic["value"], statistic.get("error") or 0.0


def scaled(largest, unit):
    """A factor and the unit with the prefix that makes `largest` a handy number: (1e3, "kN")."""
    for factor, prefix in [(1e9, "G"), (1e6, "M"), (1e3, "k"), (1, ""), (1e-3, "m"), (1e-6, "µ")]:
        if abs(largest) >= factor:
            return factor, prefix + unit
    return 1, unit


def bare(axes):
    """No frame and no ticks, equal scales: for pictures."""
    axes.set_aspect("equal")
    axes.set_xticks([])
    axes.set_yticks([])
    for spine in axes.spines.values():
        spine.set_visible(False)


def length_bar(axes, metres, left, bottom):
    """A bar of a round length, about a fifth of `metres`, in millimetres."""
    wanted = 1e3 * metres / 5
    power = 10 ** math.floor(math.log10(wanted))
    bar = max(step * power for step in (1, 2, 5) if step * power <= wanted)
    axes.plot([left, left + 1e-3 * bar], [bottom, bottom], color=strong, linewidth=1.5, solid_capstyle="butt", clip_on=False)
    axes.text(left + 0.5e-3 * bar, bottom, f"{bar:g} mm", ha="center", va="bottom", fontsize="small")

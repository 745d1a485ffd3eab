"""Distributions of a field: stresses of nodes by phase, volumes of pores and voids (P figures 5 to 14)."""

import numpy as np

from .fields import symbols
from .style import colours, soft, strong

order = ["all", "large", "small", "particle", "matrix"]
set_colours = {"all": strong, "large": colours[0], "small": colours[1], "particle": colours[0], "matrix": colours[2]}


def sets_of(component, own=False):
    """(name, distribution, curve) of the sets that have a density; particles only where they have no classes."""
    sets = component["sets"]
    classed = "large" in sets or "small" in sets
    found = [
        (name, sets[name], sets[name].get("own_pdf" if own else "pdf"))
        for name in order
        if name in sets and not (name == "particle" and classed)
    ]
    return [(name, d, curve) for name, d, curve in found if curve]


def draw_densities(axes, statistics, component="sigma_yy", own=False, log=True):
    """Densities of a component by phase over the sample's mean or r.m.s., or over each phase's `own` mean with the fits, logarithmic
    the tail exp(-s x), else the q-Gaussian (P Figs. 9, 13, 14)."""
    about = statistics["components"][component] if "components" in statistics else statistics[component]
    sets = sets_of(about, own)
    most = max((max(curve["y"]) for _, _, curve in sets), default=1.0)
    least = most * (2e-5 if log else 6e-3)
    seen = [x for _, _, curve in sets for x, y in zip(curve["x"], curve["y"]) if y >= least]
    for name, d, curve in sets:
        x, y = np.array(curve["x"]), np.array(curve["y"])
        axes.plot(
            x[y > 0],
            y[y > 0],
            color=set_colours[name],
            label=name,
            linewidth=1.4 if name == "all" else 1.0,
            alpha=0.55 if own else 1.0,
        )
        fit = (tail_of(d) if log else q_gaussian_of(d, min(seen), max(seen))) if own else None
        if fit is not None:
            axes.plot(*fit, "--" if log else ":", color=set_colours[name], linewidth=1.2)
    axes.axvline(1, color=soft, linewidth=0.6, linestyle=":")
    axes.set(
        xlabel=label_of(component, about["normalised_by"], own), ylabel="probability density", ylim=(0, 1.05 * most)
    )
    if own:
        axes.plot(
            [], [], "--" if log else ":", color=strong, linewidth=1.2, label=r"$\exp(-s\,x)$" if log else "$q$-Gaussian"
        )
    if seen:
        axes.set_xlim(min(seen), max(seen))
    if log:
        axes.set(yscale="log", ylim=(least, 2 * most))
    axes.legend()


def label_of(component, by, own):
    if by != "mean":
        return f"${symbols[component]}$ over its r.m.s."
    return f"${symbols[component]}/\\langle {symbols[component]}\\rangle$" + (" of the phase" if own else "")


def tail_of(distribution):
    """(x, y) of the fitted fall-off between its ends; it holds as many nodes as were counted there."""
    tail = distribution.get("tail", {})
    if not {"slope", "low", "high"} <= set(tail):
        return None
    s, low, high = tail["slope"]["value"], tail["low"], tail["high"]
    x = np.linspace(low, high, 120)
    return x, tail["count"] / distribution["count"] * s / (np.exp(-s * low) - np.exp(-s * high)) * np.exp(-s * x)


def q_gaussian_of(distribution, low, high):
    """(x, y) of the fitted (1 + (q - 1) beta (x - centre)^2)^(-1/(q - 1)), scaled to the area 1."""
    fit = distribution.get("q_gaussian", {})
    if not {"q", "beta", "centre"} <= set(fit):
        return None
    q, beta, centre = (fit[name]["value"] for name in ("q", "beta", "centre"))

    def shape(x):
        square = beta * (x - centre) ** 2
        return np.exp(-square) if abs(q - 1) < 1e-6 else np.maximum(0, 1 + (q - 1) * square) ** (-1 / (q - 1))

    # x = centre + tan(t)/sqrt(beta) brings the whole line into (-pi/2, pi/2).
    n = 4000
    t = ((np.arange(n) + 0.5) / n - 0.5) * np.pi
    area = np.sum(shape(centre + np.tan(t) / np.sqrt(beta)) / np.cos(t) ** 2) * np.pi / n / np.sqrt(beta)
    x = np.linspace(low, high, 240)
    return x, shape(x) / area


def draw_cavities(axes, numbers, kinds=("pores", "voids")):
    """Densities of the volume of single pores and voids over that of a large grain, with counting errors; `numbers` of a Field."""
    for kind, colour in zip(kinds, colours):
        about = numbers.get(kind, {})
        if "pdf" not in about:
            continue
        edge, density, error = (np.array(about["pdf"][name], float) for name in ("edge", "density", "error"))
        seen = density > 0
        axes.errorbar(
            np.sqrt(edge[1:] * edge[:-1])[seen],
            density[seen],
            yerr=np.minimum(error, 0.95 * density)[seen],
            fmt="o-",
            color=colour,
            markersize=2.5,
            elinewidth=0.6,
            linewidth=0.9,
            label=f"{kind} ({about['count']})",
        )
    axes.set(xscale="log", yscale="log", xlabel=r"$V/(\pi\, r_{\mathrm{L}}^2)$", ylabel="probability density")
    axes.legend()


def has_cavities(numbers):
    """Whether any kind has more than two bins that hold some."""
    return any(
        np.sum(np.array(numbers.get(kind, {}).get("pdf", {}).get("density", [])) > 0) > 2 for kind in ("pores", "voids")
    )

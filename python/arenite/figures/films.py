"""What an infrared film gives: maps, grains, contact forces (T figures 3.7 to 3.12)."""

import numpy as np
from matplotlib.collections import PatchCollection
from matplotlib.patches import Circle

from .style import bare, colours, scaled, soft, strong


def draw_map(axes, values, label=None, share=0.005, colour_map="inferno"):
    """A map of pixels, top row first, without `share` of the pixels at each end of its colours; `label` gives it a bar."""
    known = values[np.isfinite(values)]
    low, high = np.quantile(known, [share, 1 - share]) if known.size else (0, 1)
    shown = axes.imshow(values, vmin=low, vmax=high, cmap=colour_map, interpolation="nearest", rasterized=True)
    bare(axes)
    if label:
        axes.figure.colorbar(shown, ax=axes, label=label, shrink=0.8)
    return shown


def _disks(axes, grains, values, most=2.5):
    disks = PatchCollection([Circle((x, y), r) for x, y, r in zip(grains.x, grains.y, grains.radius)], linewidth=0.25, edgecolor=strong, cmap="viridis")
    disks.set_array(values)
    disks.set_clim(0, most)
    axes.add_collection(disks)
    axes.autoscale_view()
    axes.invert_yaxis()
    bare(axes)
    return disks


def normalised(sigma):
    """Over the mean of the grains that have one."""
    return sigma / np.nanmean(sigma)


def draw_film_grains(axes, film, most=2.5):
    """sigma_norm of every grain as the film shows it."""
    return _disks(axes, film.grains, normalised(film.sigma_hyd), most)


def draw_twin_grains(axes, film, which="swing", most=2.5):
    """The same of the simulation beside the film, its "swing" or its "state"."""
    return _disks(axes, film.grains, normalised(film.twin[which]), most)


def draw_against_twin(axes, film, which="swing"):
    """Film against simulation, grain by grain."""
    x, y = normalised(film.twin[which]), normalised(film.sigma_hyd)
    error = film.sigma_hyd_error / abs(np.nanmean(film.sigma_hyd))
    axes.errorbar(x, y, yerr=error, fmt=".", color=colours[0], markersize=2, elinewidth=0.3, alpha=0.7)
    ends = [min(0, np.nanmin(x), np.nanmin(y)), max(np.nanmax(x), np.nanmax(y))]
    axes.plot(ends, ends, "--", color=soft)
    known = np.isfinite(x) & np.isfinite(y)
    axes.text(0.05, 0.95, f"$r$ = {np.corrcoef(x[known], y[known])[0, 1]:.3f}", transform=axes.transAxes, va="top")
    axes.set(xlabel=r"simulation, $\sigma_{norm}$", ylabel=r"film, $\sigma_{norm}$")


def _ranked(axes, values, errors, unit, label):
    order = np.argsort(-values)
    factor, unit = scaled(np.nanmax(np.abs(values)), unit)
    rank = np.arange(1, len(values) + 1)
    axes.errorbar(rank, values[order] / factor, yerr=errors[order] / factor, fmt=".", color=colours[0], ecolor=soft, markersize=1.5, elinewidth=0.5)
    axes.axhline(0, color=soft, linewidth=0.6)
    axes.set(xlabel="rank", ylabel=f"{label}, {unit}")


def draw_ranked_forces(axes, film):
    """Normal forces of the swing in order, with standard errors."""
    _ranked(axes, film.packing.contacts.fn, film.fn_error, "N", "$F_n$")


def draw_ranked_stresses(axes, film):
    """Pressures of grains in order, with standard errors."""
    _ranked(axes, -film.sigma_hyd, film.sigma_hyd_error, "Pa", r"$-\sigma_{hyd}$")


def draw_certainty(axes, film):
    """How many standard errors normal forces are worth."""
    ratio = film.packing.contacts.fn / film.fn_error
    ratio = ratio[np.isfinite(ratio)]
    axes.hist(np.clip(ratio, -6, np.quantile(ratio, 0.98)), bins=36, color=colours[0], alpha=0.8)
    axes.set(xlabel="$F_n$ / standard error", ylabel="contacts")

"""Grains and contacts measured on an infrared film, with errors (T figures 3.11 and 3.12)."""

import numpy as np
from matplotlib.colors import to_rgba

from .films import mean_stress, normalised
from .style import colours, force_symbols, plain, scaled, sigma_norm, soft, strong, tension

simulation_names = {"peak_to_peak": "simulation, peak to peak", "state": "simulation, state"}


def materials_of(film):
    """(name, colour, which grains) of the materials present."""
    material = np.asarray(film.packing.material)
    names = [m.name for m in film.packing.materials] or ["grains"]
    return [
        (plain(name), colours[m % len(colours)], material == m) for m, name in enumerate(names) if np.any(material == m)
    ]


def uncertain(film):
    """One flag per contact: accepted as present, but possibly absent."""
    return np.asarray(film.presence) < 0.95


def certainty_sets(film):
    """(name, colour, which contacts)."""
    may = uncertain(film)
    return [
        (name, colour, which)
        for name, colour, which in [
            (f"{np.sum(~may)} present", strong, ~may),
            (f"{np.sum(may)} may be absent", tension, may),
        ]
        if which.any()
    ]


def draw_against_simulation(axes, film, which="peak_to_peak"):
    """Film against simulation, grain by grain; the correlation is the stored one, for grains away from the border."""
    x, y = normalised(film, film.simulation[which]), normalised(film, film.sigma_hyd)
    error = film.sigma_hyd_error / abs(mean_stress(film, film.sigma_hyd))
    for name, colour, of in materials_of(film):
        axes.errorbar(
            x[of], y[of], yerr=error[of], fmt=".", color=colour, markersize=2, elinewidth=0.3, alpha=0.7, label=name
        )
    ends = [min(0, np.nanmin(x), np.nanmin(y)), max(np.nanmax(x), np.nanmax(y))]
    axes.plot(ends, ends, "--", color=soft)
    agreement = film.numbers.get("agreement", {}).get(f"simulation_{which}", {}).get("all", {})
    if "correlation" in agreement:
        axes.text(0.04, 0.96, f"$r$ = {agreement['correlation']['value']:.3f}", transform=axes.transAxes, va="top")
    axes.set(xlabel=f"{simulation_names[which]}, {sigma_norm}", ylabel=f"film, {sigma_norm}")
    axes.legend(loc="lower right")


def _ranked(axes, values, errors, unit, label, sets):
    rank = np.empty(len(values))
    rank[np.argsort(-values, kind="stable")] = np.arange(1, len(values) + 1)
    factor, unit = scaled(np.nanmax(np.abs(values)), unit)
    for name, colour, of in sets:
        axes.errorbar(
            rank[of],
            values[of] / factor,
            yerr=errors[of] / factor,
            fmt=".",
            color=colour,
            ecolor=to_rgba(colour, 0.35),
            markersize=1.5,
            elinewidth=0.5,
            label=name,
        )
    axes.axhline(0, color=soft, linewidth=0.6)
    axes.set(xlabel="rank", ylabel=f"{label}, {unit}")
    if len(sets) > 1:
        axes.legend(markerscale=3)


def draw_ranked_forces(axes, film, component="fn"):
    """Peak-to-peak forces in order, normal or tangential ("ft"), with standard errors; contacts that may be absent are shown separately."""
    errors = film.fn_error if component == "fn" else film.ft_error
    _ranked(
        axes,
        np.asarray(getattr(film.packing.contacts, component)),
        errors,
        "N",
        f"${force_symbols[component]}$",
        certainty_sets(film),
    )


def draw_ranked_stresses(axes, film):
    """Pressures of grains in order, with standard errors, by material."""
    _ranked(axes, -film.sigma_hyd, film.sigma_hyd_error, "Pa", r"$-\sigma_{\mathrm{hyd}}$", materials_of(film))


def certainty_bins(ratio):
    """Edges of bars over F_n / standard error: round steps up to the value that 98 % do not exceed; the rest is in the first and the last bar."""
    order = np.sort(ratio)
    high, low = max(4.0, order[int(0.98 * (len(order) - 1))]), min(0.0, max(-6.0, order[0]))
    step = next(
        v
        for decade in range(-1, 308)
        for v in (1.0 * 10.0**decade, 2.0 * 10.0**decade, 5.0 * 10.0**decade)
        if v >= 0.5 and (high - low) / v <= 36
    )
    first = np.floor(low / step)
    return step * np.arange(first, np.ceil(high / step) + 1)


def draw_certainty(axes, film):
    """Normal forces over their standard errors."""
    with np.errstate(divide="ignore", invalid="ignore"):
        ratio = film.packing.contacts.fn / film.fn_error
    if not np.isfinite(ratio).any():
        return
    edges = certainty_bins(ratio[np.isfinite(ratio)])
    inside = np.clip(ratio, edges[0], np.nextafter(edges[-1], 0))
    sets = [(name, colour, of & np.isfinite(ratio)) for name, colour, of in certainty_sets(film)]
    axes.hist(
        [inside[of] for _, _, of in sets],
        bins=edges,
        stacked=True,
        color=[colour for _, colour, _ in sets],
        label=[name for name, _, _ in sets],
        alpha=0.75,
        rwidth=0.92,
    )
    axes.set(xlabel=f"${force_symbols['fn']}$ / standard error", ylabel="contacts")
    outside = [
        (np.sum(ratio[np.isfinite(ratio)] < edges[0]), "below", edges[0], "first"),
        (np.sum(ratio[np.isfinite(ratio)] > edges[-1]), "beyond", edges[-1], "last"),
    ]
    axes.set_title(
        "; ".join(f"{count} {where} {edge:g} in the {bar} bar" for count, where, edge, bar in outside if count),
        fontsize="small",
    )
    axes.legend()

"""Statistics of grains and contacts (T chapters 1.2, 3 to 6), from the dict that `arenite.measure` gives."""

import numpy as np

from .style import colours, estimate, soft, strong, weak


def sets_of(distribution):
    """("all", d), then the parts by material, zone or type of contact, those with more than one member."""
    parts = distribution.get("by_type") or distribution.get("by_material") or {}
    return [(name, d) for name, d in [("all", distribution), *parts.items()] if d.get("count", 0) > 1 and "cumulative" in d]


def draw_cumulative(axes, distribution, label=r"$\sigma_{norm}$", share="P0"):
    """Share above x with its tail P_0 exp(beta (1 - x)), semi-logarithmic (T figures 3.12, 6.4): all, and the parts."""
    draw_cumulative_sets(axes, sets_of(distribution), label, share)


def draw_cumulative_sets(axes, sets, label=r"$\sigma_{norm}$", share="P0"):
    """The same of several distributions, (name, distribution)."""
    for (name, d), colour in zip(sets, [strong, *colours]):
        if "cumulative" not in d:
            continue
        curve, least = d["cumulative"], 0.7 / d["count"]
        x, y = np.array(curve["x"]), np.array(curve["y"])
        axes.plot(x[y >= least], y[y >= least], ".", color=colour, markersize=2.5, label=name)
        if "beta" in d and share in d:
            line = np.linspace(1, max(x[-1], 2), 100)
            tail = d[share]["value"] * np.exp(d["beta"]["value"] * (1 - line))
            axes.plot(line[tail >= least], tail[tail >= least], "--", color=colour, linewidth=0.9)
    axes.axvline(1, color=soft, linewidth=0.6, linestyle=":")
    axes.set(xlabel=label, ylabel="share above", yscale="log", xlim=(0, None), ylim=(None, 1))
    axes.legend()


def draw_density(axes, force):
    """Density of F/<F> with its fits, weak k x^-alpha and strong k exp(beta (1 - x)) (T eq. 1.3 and 1.4)."""
    for (name, d), colour in list(zip(sets_of(force), [strong, *colours]))[::-1]:
        x, y = np.array(d["pdf"]["x"]), np.array(d["pdf"]["y"])
        error = np.array(d["pdf"].get("error", np.zeros_like(y)))
        seen = y > 0
        axes.errorbar(x[seen], y[seen], yerr=np.minimum(error[seen], 0.95 * y[seen]) if name == "all" else None, fmt=".", color=colour, markersize=3, elinewidth=0.6, label=name)
    if "k" in force and "alpha" in force and "beta" in force:
        k, low, high = force["k"]["value"], np.linspace(0.03, 1, 60), np.linspace(1, max(force["pdf"]["x"]), 60)
        axes.plot(low, k * low ** -force["alpha"]["value"], "--", color=weak)
        axes.plot(high, k * np.exp(force["beta"]["value"] * (1 - high)), "--", color=weak)
    axes.set(xlabel=r"$F_n/\langle F_n\rangle$", ylabel="probability density", yscale="log", xlim=(0, None))
    axes.legend()


def draw_rose(axes, sectors, fabric=None):
    """Polar histogram of contact directions in sectors of 10 degrees over the isotropic share (T Fig. 3.8); `axes` are polar."""
    sectors = np.array(sectors, float)
    share = np.tile(sectors / sectors.mean(), 2)
    angle = np.radians(np.arange(5, 365, 10))
    axes.bar(angle, share, width=np.radians(10), color=colours[0], alpha=0.6, edgecolor="white", linewidth=0.3)
    line = np.linspace(0, 2 * np.pi, 361)
    axes.plot(line, np.ones_like(line), linestyle=":", color=soft, linewidth=0.8)
    if fabric and "a_c" in fabric:
        axes.plot(line, 1 + fabric["a_c"]["value"] * np.cos(2 * (line - np.radians(fabric["theta_c_deg"]["value"]))), color=strong, linewidth=0.9)
    axes.set(xticks=np.radians(np.arange(0, 360, 45)), yticks=[])
    axes.grid(False)
    axes.spines["polar"].set_visible(False)


def draw_coordination(axes, coordination):
    """Mean contacts of a grain by material, with standard errors."""
    names = [n for n in coordination if isinstance(coordination[n], dict) and "value" in coordination[n] and n != "rattlers"]
    values, errors = zip(*[estimate(coordination[n]) for n in names])
    at = np.arange(len(names))[::-1]
    axes.barh(at, values, xerr=errors, color=[strong if n == "all" else colours[0] for n in names], alpha=0.8, height=0.65, error_kw={"elinewidth": 0.8})
    axes.set(yticks=at, yticklabels=[n.replace("_", " ") for n in names], xlabel="contacts of a grain")


def draw_contact_numbers(axes, coordination):
    """Share of grains with 0, 1, 2, ... contacts."""
    share = 100 * np.array(coordination["histogram"])
    axes.bar(np.arange(len(share)), share, color=colours[0], alpha=0.8)
    axes.set(xlabel="contacts", ylabel="grains, %")


def draw_rev(axes, texture):
    """Solid fraction of windows of growing area and random place: mean, standard error, one deviation (T Fig. 3.6)."""
    rev = {name: np.array(values, float) for name, values in texture["rev"].items() if np.ndim(values) == 1}
    x = 100 * rev["area_share"]
    axes.fill_between(x, rev["mean"] - rev["deviation"], rev["mean"] + rev["deviation"], color=colours[0], alpha=0.15, linewidth=0)
    axes.errorbar(x, rev["mean"], yerr=rev["error"], fmt="o", color=colours[0], elinewidth=0.7)
    if "solid_fraction" in texture:
        axes.axhline(texture["solid_fraction"]["value"], color=weak, linestyle="--", linewidth=0.8)
    axes.set(xlabel="window, % of the area", ylabel="solid fraction", xlim=(0, 100))


def draw_threshold(axes, threshold):
    """Signed anisotropy of the contacts above and below a force threshold (T Fig. 1.12a), with the bands of random directions."""
    force = np.array(threshold["force"], float)
    for part, colour, label in [("above", colours[0], r"$F>\xi\langle F\rangle$"), ("below", colours[1], r"$F<\xi\langle F\rangle$")]:
        value, noise = np.array(threshold[f"a_c_{part}"], float), np.array(threshold[f"noise_{part}"], float)
        seen = noise < 0.6
        axes.fill_between(force[seen], -noise[seen], noise[seen], color=colour, alpha=0.1, linewidth=0)
        axes.plot(force[seen], value[seen], color=colour, label=label)
    axes.axhline(0, color=soft, linewidth=0.6)
    axes.set(xlabel=r"$\xi$", ylabel="$a_c$")
    axes.legend()


def draw_course(axes, textures, of="anisotropy"):
    """Over the stored states: "coordination", with and without rattlers, or "anisotropy" of contacts beside the stress ratio."""
    lines = {
        "coordination": [("$z$", lambda t: t["coordination"]["all"]), ("without rattlers", lambda t: t["coordination"]["without_rattlers"])],
        "anisotropy": [("$q/p$", lambda t: {"value": t["stress_details"]["deviator_Pa"] / t["stress_details"]["pressure_Pa"]}),
                       ("$a_c$", lambda t: t["fabric"]["a_c_signed"]), ("$a_c$, strong", lambda t: t["fabric"]["sets"]["strong"]["a_c_signed"])],
    }[of]
    for (label, number), colour in zip(lines, colours):
        points = []
        for k, texture in enumerate(textures):
            try:
                points.append((k + 1, *estimate(number(texture))))
            except (KeyError, TypeError, ZeroDivisionError):
                continue
        if points:
            state, value, error = np.array(points).T
            axes.errorbar(state, value, yerr=error, fmt="o-", color=colour, elinewidth=0.7, label=label)
    axes.xaxis.get_major_locator().set_params(integer=True)
    axes.set(xlabel="stored state", ylabel=of)
    axes.legend()

"""Statistics of grains and contacts (T chapters 1.2, 3 to 6), from the dict that `arenite.measure` gives."""

import numpy as np

from .style import colour_of, colours, estimate, force_symbols, measured, plain, sigma_norm, soft, strong, weak

over_mean = f"${force_symbols['fn']}/\\langle {force_symbols['fn']}\\rangle$"
a_c = r"$a_{\mathrm{c}}$"


def sets_of(distribution, materials=()):
    """(name, d, colour) of all, then of the parts by material, zone or type of contact that have more than one member."""
    parts = distribution.get("by_type") or distribution.get("by_material") or {}
    sets = [("all", distribution), *parts.items()]
    return [
        (name, d, colour_of(name, list(materials), k))
        for k, (name, d) in enumerate(sets, -1)
        if d.get("count", 0) > 1 and "cumulative" in d
    ]


def name_of(name):
    """ "HDPE-POM" as it is printed."""
    return plain(name).replace("-ANY", "–any").replace("-", "–").replace("_", " ")


def draw_cumulative(axes, distribution, label=sigma_norm, share="P0", materials=(), log=True):
    """Fraction above x with its tail P_0 exp(beta (1 - x)) (T figures 3.12, 6.4): all, and the parts in the colours of `materials` (names)."""
    draw_cumulative_sets(axes, sets_of(distribution, materials), label, share, log)


def draw_cumulative_sets(axes, sets, label=sigma_norm, share="P0", log=True):
    """The same of several distributions, (name, distribution, colour)."""
    for name, d, colour in sets:
        if "cumulative" not in d:
            continue
        curve, least = d["cumulative"], 0.7 / d["count"] if log else -1
        x, y = np.array(curve["x"]), np.array(curve["y"])
        axes.plot(
            x[y >= least], y[y >= least], ".", color=colour, markersize=2.5, label=name_of(name) + numbers_of(d, share)
        )
        if "beta" in d and share in d:
            line = np.linspace(1, max(x[-1], 2), 100)
            tail = d[share]["value"] * np.exp(d["beta"]["value"] * (1 - line))
            axes.plot(line[tail >= least], tail[tail >= least], "--", color=colour, linewidth=0.9)
    axes.axvline(1, color=soft, linewidth=0.6, linestyle=":")
    axes.set(xlabel=label, ylabel="survival function", xlim=(0, None))
    axes.set(**{"yscale": "log", "ylim": (None, 1)} if log else {"ylim": (0, 1)})
    axes.legend(
        **{"loc": "lower center", "bbox_to_anchor": (0.5, 1), "handletextpad": 0.2} if log else {"loc": "upper right"}
    )


def numbers_of(distribution, share):
    """The tail's numbers, for a legend."""
    symbols = [(r"$P_0$", share), (r"$\beta$", "beta")]
    return "".join(f", {symbol} = {measured(distribution[name])}" for symbol, name in symbols if name in distribution)


def draw_density(axes, force, materials=()):
    """Density of F/<F>, each type over its own mean, with the fits of all: weak k x^-alpha and strong k exp(beta (1 - x)) (T eq. 1.3 and 1.4)."""
    for name, d, colour in sets_of(force, materials)[::-1]:
        x, y = np.array(d["pdf"]["x"]), np.array(d["pdf"]["y"])
        error = np.array(d["pdf"].get("error", np.zeros_like(y)))
        seen = y > 0
        axes.errorbar(
            x[seen],
            y[seen],
            yerr=np.minimum(error[seen], 0.95 * y[seen]) if name == "all" else None,
            fmt=".",
            color=colour,
            markersize=3,
            elinewidth=0.6,
            label=name_of(name),
        )
    if "k" in force and "alpha" in force and "beta" in force:
        k, low, high = force["k"]["value"], np.linspace(0.03, 1, 60), np.linspace(1, max(force["pdf"]["x"]), 60)
        axes.plot(low, k * low ** -force["alpha"]["value"], "--", color=weak, label="fits")
        axes.plot(high, k * np.exp(force["beta"]["value"] * (1 - high)), "--", color=weak)
    axes.axvline(1, color=soft, linewidth=0.6, linestyle=":")
    axes.set(xlabel=over_mean, ylabel="probability density", yscale="log", xlim=(0, None))
    axes.legend(loc="lower center", bbox_to_anchor=(0.5, 1), ncols=3, columnspacing=1, handletextpad=0.4)


def reach_of(fabric):
    """Largest radius of a rose and its line, over the isotropic fraction."""
    share = np.array(fabric["sectors"], float)
    return max(1.6, share.max() / share.mean(), 1 + fabric.get("a_c", {}).get("value", 0))


def draw_rose(axes, sectors, fabric=None, inner=None, colour=colours[0], reach=None, load_axis=None):
    """Polar histogram of contact orientations in sectors of 10 degrees over the isotropic fraction (T Fig. 3.8), darker the sectors of
    a subset, `inner`; `reach` is the outer circle, arrows mark `load_axis` (degrees). `axes` are polar."""
    isotropic = np.mean(sectors)
    angle, width = np.radians(np.arange(5, 365, 10)), np.radians(9)
    axes.bar(
        angle,
        np.tile(sectors, 2) / isotropic,
        width=width,
        color=colour,
        alpha=0.5 if inner is None else 0.35,
        linewidth=0,
    )
    if inner is not None:
        axes.bar(angle, np.tile(inner, 2) / isotropic, width=width, color=colour, alpha=0.75, linewidth=0)
    line = np.linspace(0, 2 * np.pi, 361)
    axes.plot(line, np.ones_like(line), linestyle=":", color=weak, linewidth=0.8)
    if fabric and "a_c" in fabric and "theta_c_deg" in fabric:
        axes.plot(
            line,
            1 + fabric["a_c"]["value"] * np.cos(2 * (line - np.radians(fabric["theta_c_deg"]["value"]))),
            color=strong,
            linewidth=0.9,
        )
    reach = reach or reach_of(fabric or {"sectors": sectors})
    for turn in () if load_axis is None else (0, 180):
        axes.annotate(
            "",
            (np.radians(load_axis + turn), reach),
            (np.radians(load_axis + turn), 1.12 * reach),
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


def rose_numbers(fabric):
    """Two lines: the anisotropy, and its direction or a note that it is below the noise."""
    if "a_c" not in fabric:
        return ""
    lost = fabric["a_c"]["value"] < fabric.get("a_c_noise", 0)
    direction = (
        f"below its noise, {fabric['a_c_noise']:.2g}"
        if lost
        else rf"$\theta_{{\mathrm{{c}}}}$ = {measured(fabric['theta_c_deg'])}°"
        if "theta_c_deg" in fabric
        else ""
    )
    return f"{a_c} = {measured(fabric['a_c'])}\n{direction}"


def draw_coordination(axes, coordination, materials=()):
    """Mean number of contacts per grain by material, with standard errors; X–Y are the Y neighbours of an X grain."""
    names = [
        n for n in coordination if isinstance(coordination[n], dict) and "value" in coordination[n] and n != "rattlers"
    ]
    values, errors = zip(*[estimate(coordination[n]) for n in names])
    at = np.arange(len(names))[::-1]
    bars = [soft if n == "without_rattlers" else colour_of(n.removesuffix("-ANY"), list(materials)) for n in names]
    axes.barh(at, values, xerr=errors, color=bars, alpha=0.8, height=0.65, error_kw={"elinewidth": 0.8})
    axes.set(yticks=at, yticklabels=[name_of(n) for n in names], xlabel="contacts per grain")


def draw_contact_numbers(axes, coordination):
    """Fraction of grains with 0, 1, 2, ... contacts."""
    share = 100 * np.array(coordination["histogram"])
    axes.bar(np.arange(len(share)), share, color=colours[0], alpha=0.8)
    axes.set(xlabel="contacts", ylabel="grains, %")


def draw_rev(axes, texture):
    """Solid fraction of windows of growing area at random positions: mean, standard error, standard deviation (T Fig. 3.6)."""
    rev = {name: np.array(values, float) for name, values in texture["rev"].items() if np.ndim(values) == 1}
    x = 100 * rev["area_share"]
    axes.fill_between(
        x,
        rev["mean"] - rev["deviation"],
        rev["mean"] + rev["deviation"],
        color=colours[0],
        alpha=0.15,
        linewidth=0,
        label="standard deviation",
    )
    axes.errorbar(x, rev["mean"], yerr=rev["error"], fmt="o", color=colours[0], elinewidth=0.7, label="mean")
    if "solid_fraction" in texture:
        axes.axhline(
            texture["solid_fraction"]["value"],
            color=weak,
            linestyle="--",
            linewidth=0.8,
            label="whole sample, without its border",
        )
    axes.set(xlabel="window, % of the area", ylabel="solid fraction", xlim=(0, 100))
    axes.legend()


def draw_threshold(axes, threshold):
    """Signed anisotropy of the contacts above and below a force threshold (T Fig. 1.12a), with bands for random orientations."""
    force, symbol = np.array(threshold["force"], float), force_symbols["fn"]
    for part, sign, colour in [("above", ">", colours[0]), ("below", "<", colours[1])]:
        value, noise = np.array(threshold[f"a_c_{part}"], float), np.array(threshold[f"noise_{part}"], float)
        seen = noise < 0.6
        label = rf"${symbol}{sign}\xi\langle {symbol}\rangle$"
        axes.fill_between(
            force[seen], -noise[seen], noise[seen], color=colour, alpha=0.12, linewidth=0, label="random orientations"
        )
        axes.plot(force[seen], value[seen], color=colour, label=label)
    axes.axhline(0, color=soft, linewidth=0.6)
    axes.set(xlabel=r"$\xi$", ylabel=a_c)
    axes.legend(ncols=2, loc="lower center", bbox_to_anchor=(0.5, 1))


def stress_path_lines(of):
    """(label, colour, function of a texture) of the quantities shown over the states."""

    def ratio(t):
        return {"value": t["stress_details"]["deviator_Pa"] / t["stress_details"]["pressure_Pa"]}

    return {
        "coordination": [
            ("$z$", strong, lambda t: t["coordination"]["all"]),
            ("$z$ without rattlers", weak, lambda t: t["coordination"]["without_rattlers"]),
        ],
        "anisotropy": [
            ("$q/p$", colours[1], ratio),
            (f"{a_c}, all", soft, lambda t: t["fabric"]["a_c_signed"]),
            (f"{a_c}, strong", strong, lambda t: t["fabric"]["sets"]["strong"]["a_c_signed"]),
            (f"{a_c}, weak", weak, lambda t: t["fabric"]["sets"]["weak"]["a_c_signed"]),
        ],
    }[of]


def draw_stress_path(axes, textures, of="anisotropy", numbers=None):
    """Over the stored states, numbered from 1 if no `numbers` are given: "coordination", with and without rattlers, or "anisotropy"
    of all, strong and weak contacts beside the stress ratio."""
    for (label, colour, number), marker in zip(stress_path_lines(of), "os^v"):
        points = []
        for k, texture in zip(numbers or range(1, len(textures) + 1), textures):
            try:
                points.append((k, *estimate(number(texture))))
            except (KeyError, TypeError, ZeroDivisionError):
                continue
        if points:
            state, value, error = np.array(points).T
            axes.errorbar(state, value, yerr=error, fmt=marker + "-", color=colour, elinewidth=0.7, label=label)
    axes.xaxis.get_major_locator().set_params(integer=True)
    axes.set(
        xlabel="stored state",
        ylabel="contacts per grain" if of == "coordination" else "anisotropy of contacts and stress",
    )
    axes.legend(ncols=2, loc="lower center", bbox_to_anchor=(0.5, 1))

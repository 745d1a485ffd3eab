"""Curves of a mechanical test (`arenite.curves`): stress against strain, cycles of load, rheology of several runs."""

import numpy as np

from .. import curves
from .._core import critical_state, study_kind
from .._core import open as open_result
from .style import colours, scaled, soft, strong

names = {"q_over_p": "$q/p$", "mu": r"$\mu = \tau/\sigma_{\mathrm{n}}$"}
many = 400  # rows of a history that are drawn as they are; of more a running mean is drawn over them


def test_of(state):
    """The stage of a State with the packing before it; the same object as long as the state exists."""
    if not hasattr(state, "_test"):
        before = [
            snapshot.packing
            for snapshot in state.snapshots
            if curves.has_history(state.stage) and snapshot.time < state.stage.history["time"][0]
        ]
        state._test = curves.Test(state.stage, before[-1] if before else None)
    return state._test


def smooth(values, rows):
    """Running mean over `rows` rows, fewer at the ends."""
    sums = np.concatenate([[0], np.cumsum(np.nan_to_num(values))])
    known = np.concatenate([[0], np.cumsum(np.isfinite(values))])
    k = np.arange(len(values))
    half = np.minimum(rows // 2, np.minimum(k, len(values) - 1 - k))
    return (sums[k + half + 1] - sums[k - half]) / np.maximum(known[k + half + 1] - known[k - half], 1)


def draw_curve(axes, x, y, colour=colours[0], label=None, width=1.1):
    """A line; a fluctuating one with many rows is drawn pale, under its running mean."""
    if len(x) > many:
        axes.plot(x, y, color=colour, alpha=0.25, linewidth=0.4)
        y = smooth(y, len(y) // 100)
    axes.plot(x, y, color=colour, label=label, linewidth=width)


def strain_of(found):
    """(values in per cent, label) of the abscissa of a test: the shear strain if something is sheared along a wall, else the axial strain."""
    name = "shear_strain" if "mu" in found else "axial_strain"
    return 100 * found[name].values, f"{name.replace('_', ' ')}, %"


def draw_critical_state(axes, critical):
    """The plateau of the ratio over the strain range from which it was determined, with its 95 % band (`arenite.critical_state`)."""
    about = critical["mu" if "mu" in critical else "q_over_p"]
    ends = 100 * np.array([critical["from"], critical["to"]])
    axes.fill_between(ends, about["low_95"], about["high_95"], color=colours[3], alpha=0.35, linewidth=0)
    axes.plot(
        ends,
        [about["value"]] * 2,
        color=colours[3],
        label=f"critical state: {about['value']:.3f} ± {0.5 * (about['high_95'] - about['low_95']):.3f}",
    )
    axes.legend(loc="lower right")


def draw_friction(axes, found):
    """q/p, or shear over normal stress of a sheared cell, or the stress of a test without confinement or in tension, against strain; `found` as curves.along gives it."""
    x, label = strain_of(found)
    if "axial_stress" in found:
        stress = found["axial_stress"].values
        factor, unit = scaled(np.max(np.abs(stress)), "Pa")
        draw_curve(axes, x, stress / factor)
        axes.set(xlabel=label, ylabel=f"stress along the axis, {unit}")
        return
    name = "mu" if "mu" in found else "q_over_p"
    draw_curve(axes, x, found[name].values)
    axes.set(xlabel=label, ylabel=names[name])


def draw_volume(axes, found):
    """Volumetric strain against strain; above zero the sample is denser than before the stage."""
    x, label = strain_of(found)
    axes.axhline(0, color=soft, linewidth=0.6)
    draw_curve(axes, x, 100 * found["volumetric_strain"].values, colours[1])
    axes.set(xlabel=label, ylabel="volumetric strain, %")


def has_test(state):
    """Whether a stage strains its sample and has the forces on it."""
    if not curves.has_history(state.stage):
        return False
    history = state.stage.history
    stressed = any(np.any(history.get(f"{side}_force", 0)) for side in ("left", "bottom"))
    return stressed and np.ptp(strain_of(curves.curves_of(test_of(state)))[0]) > 1e-3


def draw_pressure(axes, found):
    """Mean pressure on the sides against strain."""
    x, label = strain_of(found)
    factor, unit = scaled(np.max(np.abs(found["p"].values)), "Pa")
    draw_curve(axes, x, found["p"].values / factor, colours[1])
    axes.set(xlabel=label, ylabel=f"$p$, {unit}")


def stress_strain(figure, state):
    """Friction above volumetric strain, or above pressure in a box with fixed sides, in which all strain is volumetric."""
    found = curves.curves_of(test_of(state))
    upper, lower = figure.subplots(2, 1, sharex=True)
    draw_friction(upper, found)
    critical = critical_state(*test_of(state))
    if critical:
        draw_critical_state(upper, critical)
    is_confined = (
        "mu" not in found
        and "axial_stress" not in found
        and np.allclose(found["volumetric_strain"].values, found["axial_strain"].values, atol=1e-9)
    )
    (draw_pressure if is_confined else draw_volume)(lower, found)
    upper.set_xlabel("")


def has_cycles(state):
    return curves.has_history(state.stage) and (has_table(state) or len(curves.whole_cycles(state.stage)) > 1)


def has_table(state):
    """Whether every cycle is known, stored or not; results of former versions have only the stored ones."""
    return len(getattr(state.stage, "cycles", {}).get("cycle", [])) > 3


def draw_cycles(axes, found):
    """Axial strain at the largest and the smallest load against the number of the cycle; `found` as curves.of_cycles or curves.every_cycle
    gives it."""
    few = len(found["cycle"].values) <= 50
    for end, marker, colour in (("maximum", "o", colours[1]), ("minimum", "s", colours[0])):
        axes.plot(
            found["cycle"].values,
            100 * found[f"axial_strain_{end}"].values,
            f"{marker}-" if few else "-",
            color=colour,
            label=f"{end} of the load",
        )
    axes.set(xlabel="cycle", ylabel="axial strain, %")
    axes.xaxis.get_major_locator().set_params(integer=True)
    axes.legend()


def cycles(figure, state):
    test = test_of(state)
    draw_cycles(figure.add_subplot(), curves.every_cycle_of(test) if has_table(state) else curves.cycles_of(test))


def draw_against_rate(axes, found, name):
    """`name`, "mu" or "solid_fraction", with its error over the inertial number; `found` as curves.rheology gives it."""
    axes.errorbar(
        found["inertial_number"].values,
        found[name].values,
        yerr=found[f"{name}_error"].values,
        fmt="o",
        color=strong,
        elinewidth=0.6,
        markersize=3,
    )
    axes.set(
        xlabel="inertial number $I$",
        ylabel={"mu": r"$\mu$", "solid_fraction": r"solid fraction $\phi$"}[name],
        xscale="log",
    )


def rheology(figure, runs):
    """mu(I) and phi(I) of the runs in these folders."""
    found = rheology_of(runs)
    for k, name in enumerate(("mu", "solid_fraction")):
        draw_against_rate(figure.add_subplot(1, 2, k + 1), found, name)


def driven_runs(study):
    """Folders of the runs of a study whose last stage strains its sample at a rate; none if it also has other runs."""
    return study_kind(study)["driven"]


def rheology_of(runs):
    """curves.rheology of the runs in these folders that are done."""
    results = []
    for run in runs:
        try:
            results.append(open_result(run))
        except ValueError:  # not done yet, or failed
            continue
    return curves.rheology(results)

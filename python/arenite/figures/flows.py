"""Figures of studies of gravity flows and of the critical state (`arenite.flows`)."""

import pathlib

import numpy as np

from .. import flows
from .._core import open as open_result
from .._core import study_kind
from .style import soft, strong


def points(axes, found, x, y, **options):
    axes.errorbar(
        found[x].values,
        found[y].values,
        yerr=found[f"{y}_error"].values,
        fmt="o",
        color=strong,
        elinewidth=0.6,
        markersize=3,
        **options,
    )


def draw_beverloo(axes, found):
    """W^(2/3) against D, and the line of exponent 3/2."""
    x, y, error = (found[name].values for name in ("opening", "rate", "rate_error"))
    law = flows.fit_beverloo(found, exponent=1.5)
    at = np.array([law["lost_width"][0], np.max(x)])
    axes.plot(1e3 * at, (law["factor"][0] ** (2 / 3)) * (at - law["lost_width"][0]), color=soft, zorder=0)
    axes.errorbar(
        1e3 * x, y ** (2 / 3), yerr=2 / 3 * error * y ** (-1 / 3), fmt="o", color=strong, elinewidth=0.6, markersize=3
    )
    axes.set(xlabel="opening $D$ (mm)", ylabel=r"$W^{2/3}$ (kg/s)$^{2/3}$", xlim=(0, None), ylim=(0, None))


def draw_runout(axes, found):
    """Run-out over the initial width against the aspect ratio, with the power laws of both regimes."""
    points(axes, found, "aspect_ratio", "runout")
    for name, law in flows.fit_runout(found).items():
        a = found["aspect_ratio"].values
        at = np.geomspace(np.min(a), 3, 20) if name == "low" else np.geomspace(1.5, np.max(a), 20)
        axes.plot(
            at,
            law["factor"][0] * at ** law["exponent"][0],
            color=soft,
            linestyle="-" if name == "low" else "--",
            zorder=0,
            label=rf"$\propto a^{{{law['exponent'][0]:.2f}}}$",
        )
    axes.set(xlabel="aspect ratio $a$", ylabel=r"run-out $(L_\infty - L_0)/L_0$", xscale="log", yscale="log")
    axes.legend()


def draw_janssen(axes, found):
    """Pressure at the bottom against the height of the filling, with Janssen's law and the pressure of a liquid."""
    law = flows.fit_janssen(found)
    at = np.linspace(0, np.max(found["height"].values), 200)
    axes.plot(1e3 * at, -law["saturation"][0] * np.expm1(-at / law["length"][0]), color=soft, zorder=0)
    axes.plot(1e3 * found["height"].values, found["hydrostatic"].values, color=soft, linestyle=":", zorder=0)
    axes.errorbar(
        1e3 * found["height"].values,
        found["pressure"].values,
        yerr=found["pressure_error"].values,
        fmt="o",
        color=strong,
        elinewidth=0.6,
        markersize=3,
    )
    axes.set(
        xlabel="height of the filling (mm)",
        ylabel="pressure at the bottom (Pa)",
        xlim=(0, None),
        ylim=(0, 2 * law["saturation"][0]),
    )


def draw_critical(figure, found):
    """Friction and solid fraction of the critical state against the grains' friction."""
    for k, (name, label) in enumerate(
        (
            ("mu", r"critical friction $\mu_{\mathrm{c}}$"),
            ("solid_fraction", r"critical solid fraction $\phi_{\mathrm{c}}$"),
        )
    ):
        axes = figure.add_subplot(1, 2, k + 1)
        points(axes, found, "friction", name)
        axes.set(xlabel=r"friction of the grains $\mu$", ylabel=label, xlim=(0, None))


def done_runs(study):
    """Results of the finished runs of a study."""
    path = pathlib.Path(study)
    results = []
    for run in sorted(((path if path.is_dir() else path.parent) / "runs").glob("*/status")):
        if run.read_text(encoding="utf-8").split()[:1] == ["done"]:
            results.append(open_result(str(run.parent)))
    return results


def beverloo(figure, study):
    draw_beverloo(figure.add_subplot(), flows.discharges(done_runs(study)))


def runout(figure, study):
    draw_runout(figure.add_subplot(), flows.runouts(done_runs(study)))


def janssen(figure, study):
    draw_janssen(figure.add_subplot(), flows.silos(done_runs(study)))


def critical(figure, study):
    draw_critical(figure, flows.critical_states(done_runs(study)))


def kind_of(study):
    """Name of the figure that suits the runs of a study, by the last stage of their recipes; None for other studies."""
    return study_kind(study)["flow"]


drawings = {"beverloo": beverloo, "runout": runout, "janssen": janssen, "critical-state": critical}

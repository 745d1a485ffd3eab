"""Curves of a test to failure and of the solver; labels have the units of their columns if these are given (`Field.curve_units`)."""

import numpy as np

from .style import colours, crack_colours, labelled, strong


def draw_convergence(axes, convergence):
    """Relative residual of the solver."""
    axes.semilogy(
        convergence["iteration"],
        convergence["residual"],
        "o-" if len(convergence["residual"]) < 60 else "-",
        color=colours[0],
    )
    axes.set(xlabel="iteration", ylabel="relative residual")


def draw_stress_strain(axes, curve, units={}):
    """Mean stress of the tested row against strain, before every round of breaking."""
    factor, label = labelled("stress", curve["stress"], units.get("stress"))
    axes.plot(1e3 * np.append(0, curve["strain"]), np.append(0, curve["stress"]) / factor, color=colours[0])
    axes.set(xlabel=r"strain, $10^{-3}$", ylabel=label, ylim=(0, None), xlim=(0, None))


def draw_broken_bonds(axes, field):
    """Number of broken bonds by type over the steps of a test."""
    until = np.asarray(field.curve["broken"], int)
    step = np.arange(1, len(until) + 1)
    for kind, (name, colour) in crack_colours.items():
        count = np.concatenate([[0], np.cumsum(field.cracks["type"] == kind)])
        axes.step(step, count[np.minimum(until, len(count) - 1)], where="post", color=colour, label=name)
    axes.set(xlabel="step", ylabel="broken bonds", ylim=(0, None))
    axes.legend()


def draw_energy_balance(axes, curve, units={}):
    """Work of the clamp, stored elastically or released by broken bonds, per unit thickness."""
    factor, label = labelled("energy", curve["work"], units.get("work"))
    step = np.arange(1, len(curve["work"]) + 1)
    axes.stackplot(
        step,
        curve["released"] / factor,
        curve["elastic"] / factor,
        labels=["released", "elastic"],
        colors=[colours[1], colours[0]],
        alpha=0.5,
        linewidth=0,
    )
    axes.plot(step, curve["work"] / factor, color=strong, label="work")
    axes.set(xlabel="step", ylabel=label)
    axes.legend()

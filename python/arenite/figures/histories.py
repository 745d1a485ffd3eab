"""What was sampled while a stage ran (`Stage.history`)."""

import numpy as np

from .style import colours, scaled

sides = {"bottom": 1, "top": -1, "left": 1, "right": -1}  # direction into the sample


def _time(history):
    return history["time"] - history["time"][0]


def _lines(axes, history, names, factor=1.0, positive=False):
    for (name, label), colour in zip(names, colours):
        if name in history and np.any(np.abs(history[name]) > 0):
            values = history[name] / factor
            axes.plot(_time(history), np.where(values > 0, values, np.nan) if positive else values, color=colour, label=label)
    axes.set_xlabel("time, s")
    if axes.lines:
        axes.legend(loc="lower center", bbox_to_anchor=(0.5, 1), ncols=3, columnspacing=1)


def draw_wall_forces(axes, history):
    """Normal force of the grains on each wall."""
    present = [f"{side}_force" for side in sides if f"{side}_force" in history]
    factor, unit = scaled(max(np.abs(history[name]).max() for name in present), "N")
    _lines(axes, history, [(name, name.split("_")[0]) for name in present], factor)
    axes.set_ylabel(f"force, {unit}")


def draw_travel(axes, history):
    """Force on the wall that moves farthest against its travel into the sample."""
    side = max((s for s in sides if f"{s}_position" in history), key=lambda s: abs(history[f"{s}_position"][-1] - history[f"{s}_position"][0]))
    way, force = sides[side] * (history[f"{side}_position"] - history[f"{side}_position"][0]), history[f"{side}_force"]
    factor, unit = scaled(np.abs(force).max(), "N")
    axes.plot(1e3 * way, force / factor, color=colours[0])
    axes.set(xlabel=f"travel of the {side} wall, mm", ylabel=f"force, {unit}")


def draw_energies(axes, history):
    """Stored and dissipated energy and work, logarithmic."""
    _lines(axes, history, [("elastic", "elastic"), ("kinetic", "kinetic"), ("dissipated_friction", "friction"), ("dissipated_normal", "dashpots"),
                           ("dissipated_drag", "drag"), ("work_walls", "work of walls"), ("work_gravity", "work of gravity")], positive=True)
    axes.set(ylabel="energy, J", yscale="log")


def draw_rest(axes, history):
    """How far the sample is from equilibrium."""
    _lines(axes, history, [("unbalanced_ratio", "unbalanced force"), ("kinetic_ratio", "kinetic/elastic"), ("mobilisation", r"mean $|F_t|/F_n$")], positive=True)
    axes.set(ylabel="ratio", yscale="log")

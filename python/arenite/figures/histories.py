"""The history of a stage (`Stage.history`); labels have the units of its columns if these are given (`Stage.history_units`)."""

import numpy as np

from .style import colours, labelled, scaled, soft, strong

sides = {"bottom": 1, "top": -1, "left": 1, "right": -1}  # direction into the sample


def _time(history):
    return history["time"] - history["time"][0]


def _lines(axes, history, names, factor=1.0, positive=False, columns=3):
    """Lines of the columns that have values; the second and fourth are dashed, so that equal forces remain visible."""
    shown = [
        (k, name, label)
        for k, (name, label) in enumerate(names)
        if name in history and np.any(np.abs(history[name]) > 0)
    ]
    for k, name, label in shown:
        values = history[name] / factor
        axes.plot(
            _time(history),
            np.where(values > 0, values, np.nan) if positive else values,
            color=colours[k % len(colours)],
            label=label,
            linestyle="-" if positive or k % 2 == 0 else "--",
        )
    axes.set_xlabel("time, s")
    if shown:
        axes.legend(
            loc="lower center",
            bbox_to_anchor=(0.5, 1),
            ncols=columns,
            columnspacing=1,
            handlelength=1.4,
            handletextpad=0.4,
        )


def draw_wall_forces(axes, history, units={}):
    """Normal force of the grains on each wall."""
    present = [f"{side}_force" for side in sides if f"{side}_force" in history]
    factor, label = labelled("force", [np.abs(history[name]).max() for name in present], units.get(present[0]))
    _lines(axes, history, [(name, name.split("_")[0]) for name in present], factor, columns=4)
    axes.set_ylabel(label)


def moving_wall(history):
    """The side whose wall moves farthest; None if none moves."""
    ways = {
        side: abs(history[f"{side}_position"][-1] - history[f"{side}_position"][0])
        for side in sides
        if len(history.get(f"{side}_position", [])) > 1 and f"{side}_force" in history
    }
    side = max(ways, key=ways.get, default=None)
    return side if side and ways[side] > 1e-9 else None


def draw_travel(axes, history, snapshots=(), units={}):
    """Force on the wall that moves farthest against its displacement into the sample; dots: the stored states `snapshots`."""
    side = moving_wall(history)
    start, force = history[f"{side}_position"][0], history[f"{side}_force"]
    factor, label = labelled("force", force, units.get(f"{side}_force"))
    axes.plot(
        1e3 * sides[side] * (history[f"{side}_position"] - start),
        force / factor,
        color=soft if len(snapshots) else colours[0],
    )
    walls = [snapshot.packing.domain[side] for snapshot in snapshots]
    axes.plot(
        [1e3 * sides[side] * (w["position"] - start) for w in walls],
        [w["force"] / factor for w in walls],
        "o",
        color=strong,
        label="stored states",
    )
    axes.set(xlabel=f"displacement of the {side} wall, mm", ylabel=label)
    if walls:
        axes.legend()


def draw_energies(axes, history, units={}):
    """Stored and dissipated energy and work, logarithmic."""
    names = [
        ("elastic", "elastic"),
        ("kinetic", "kinetic"),
        ("dissipated_friction", "friction"),
        ("dissipated_normal", "dashpots"),
        ("dissipated_drag", "drag"),
        ("work_walls", "work of walls"),
        ("work_gravity", "work of gravity"),
    ]
    _lines(axes, history, names, positive=True)
    values = np.concatenate([history[name] for name, _ in names if name in history])
    axes.set(ylabel=", ".join(filter(None, ["energy", units.get("elastic")])), yscale="log")
    if (values > 0).any():  # a sample at rest would stretch the axis over tens of decades
        axes.set_ylim(max(values[values > 0].min(), 1e-7 * values.max()) / 2, 2 * values.max())


def draw_discharge(axes, history):
    """Mass of the grains below the height `count_below` of the recipe."""
    mass = history["passed_mass"]
    factor, unit = scaled(1e3 * np.max(np.abs(mass)), "g")
    axes.plot(_time(history), 1e3 * mass / factor, color=strong)
    axes.set(xlabel="time, s", ylabel=f"mass passed, {unit}")


def draw_equilibrium(axes, history):
    """Distance of the sample from equilibrium."""
    _lines(
        axes,
        history,
        [
            ("unbalanced_ratio", "unbalanced force"),
            ("kinetic_ratio", "kinetic/elastic"),
            ("mobilisation", r"mean $|F_{\mathrm{t}}|/F_{\mathrm{n}}$"),
        ],
        positive=True,
        columns=2,
    )
    axes.set(ylabel="ratio", yscale="log")

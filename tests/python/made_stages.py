"""Stages that are made up, of which every curve is known."""

import types

import arenite
import numpy as np

density, thickness = 1000.0, 0.1


def a_stage(width, height, forces=None, shear=None, name="test", cycles=None, asked=None, texture=None, **columns):
    """A stage whose box has this `width` and `height` in time 0, 1, 2, ...; `forces` and `shear` of its sides, N.

    `cycles` names the rows at which half cycles end: {row: (number, "maximum")}.
    """
    n = len(height)
    history = {
        "time": np.arange(n, dtype=float),
        "left_position": np.zeros(n),
        "right_position": np.array(width, float),
        "bottom_position": np.zeros(n),
        "top_position": np.array(height, float),
    }
    for side in ("left", "right", "bottom", "top"):
        history[f"{side}_force"] = np.broadcast_to((forces or {}).get(side, 0.0), n).astype(float)
        history[f"{side}_shear_force"] = np.broadcast_to((shear or {}).get(side, 0.0), n).astype(float)
    history.update({key: np.array(values, float) for key, values in columns.items()})
    states = [(float(k), "state", a_box(width[k], height[k])) for k in range(n)]
    ends = {name: values[list(cycles)] for name, values in history.items()} if cycles else {}
    if cycles:
        ends["cycle"] = np.array([number for number, _ in cycles.values()], float)
        ends["at_maximum"] = np.array([end == "maximum" for _, end in cycles.values()], float)
    return arenite.Stage(name, history=history, states=states, cycles=ends, asked=asked or {}, texture=texture or {})


def a_box(width, height):
    """Four disks that a box of this size holds, however small it is."""
    middle = [0.5 * width, 0.5 * height]
    return arenite.Packing(
        [middle[0]] * 4,
        [middle[1]] * 4,
        [1, 1, 1, 1],
        materials=[arenite.Material("clay", density=density)],
        width=width,
        height=height,
        thickness=thickness,
    )


def alone(stage, *before):
    return types.SimpleNamespace(stages=[*before, stage])


def a_cyclic_stage():
    """Two cycles and a half after equilibrium."""
    ends = [(1, "maximum"), (1, "minimum"), (2, "maximum"), (2, "minimum"), (3, "maximum")]
    cycles = {row: end for row, end in enumerate(ends, 1)}
    return a_stage([4.0] * 6, [4.0, 3.6, 3.8, 3.5, 3.7, 3.4], cycles=cycles, dissipated_friction=[0, 1, 3, 4, 5, 9])

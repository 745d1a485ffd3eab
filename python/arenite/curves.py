"""Curves of a test: strains, stresses and fabric along a loading and over its cycles, and mu(I), phi(I) over several
runs.

Each function returns a dict, {"axial_strain": Curve(values, unit), ...}; a Curve is a tuple of an array and its SI unit
("1" for numbers), with what it is as its `meaning`. Strains are positive in compression, as in `arenite show --states`,
relative to the state before the stage; stresses of the sides are positive in compression, p their mean and q half the
difference of the principal ones, so that q/p is the sine of the mobilised angle of friction. Quantities that a result
lacks are left out. The numbers are those that `arenite show` and the page have (`grains/fields` of the library). For
pandas: `pandas.DataFrame({name: c.values for name, c in along(result).items()})`.
"""

import collections
from typing import NamedTuple

import numpy as np

from . import _core
from ._core import steady_ratio, steady_state, whole_cycles  # noqa: F401


class Curve(collections.namedtuple("Curve", ["values", "unit"])):
    """Values along a loading and their SI unit; `meaning`: what they are."""

    def __new__(cls, values, unit, meaning=""):
        curve = super().__new__(cls, values, unit)
        curve.meaning = meaning
        return curve


class Test(NamedTuple):
    """A loading stage and the packing before it, the reference of strains; None if there is none."""

    stage: object
    before: object


def named_curves(columns):
    """{name: Curve} of the library's columns, their errors as `name_error` behind them (`name_error_maximum` over
    cycles)."""
    found = {}
    for name, (values, error, unit, meaning) in columns.items():
        found[name] = Curve(values, unit, meaning)
        if error is not None:
            ends = [end for end in ("_maximum", "_minimum") if name.endswith(end)]
            stem, end = (name[: -len(ends[0])], ends[0]) if ends else (name, "")
            found[f"{stem}_error{end}"] = Curve(error, unit, f"Standard error: {meaning}")
    return found


def find_test(result, stage=None):
    """The stage of this name, or the last one that has a history. Raises ValueError if there is none."""
    stages = list(result.stages) or list(result.spheres)
    place = _core.stage_with_history(stages, stage)
    earlier = [snapshot.packing for part in stages[:place] for snapshot in part.snapshots[-1:]]
    return Test(stages[place], earlier[-1] if earlier else None)


def has_history(stage):
    """Whether a stage has curves."""
    return len(stage.history.get("time", [])) > 1 and len(stage.snapshots) > 0


def along(result, stage=None):
    """The history sampled while a stage ran: `time`; `strain_x`, `strain_y`, `axial_strain` (of the axis that shortens
    most, or, without confinement, strains most), `volumetric_strain`, `shear_strain` (of a sheared cell or between
    sliding walls; otherwise axial minus lateral strain);
    `sigma_xx`, `sigma_yy`, `tau`, `p`, `q`, `q_over_p` and, if a cell is sheared or a wall slides, `mu`, shear over
    normal stress there, negative for shear to the left; `axial_stress` of a test without confinement or in tension;
    ratios are NaN if the sides are almost unloaded; `solid_fraction` of the whole box, `inertial_number`; for runs with
    track_energy `dissipated_energy` and `work` since the first row. Of spheres p is the mean of three stresses and q
    the axial one less the mean of the two others. Raises ValueError for a result without such a stage.
    """
    return curves_of(find_test(result, stage))


def curves_of(test):
    """As `along`, of a Test."""
    return named_curves(_core.curves_along(*test))


def slides(stage):
    """{side: m/s} of sliding walls; the initial value if a programme drives them."""
    speeds = stage.asked.get("slide", {})
    sides = ("left", "right", "bottom", "top")
    return {side: speeds.get(side, 0.0) for side in sides if f"{side}_slid" in stage.history}


def of_states(result, stage=None):
    """Fabric against strain, for the stored states of a stage: the strains of `along` and `solid_fraction` (away from
    the walls), `z`, `z_without_rattlers`, `rattlers`, `a_c` (and signed along the compression: all, strong, weak
    contacts), `a_n`, `a_t`, `theta_c`, `mean_force`, `p`, `q`, `q_over_p` of the contacts; with standard errors such as
    `z_error`. NaN if a state has no value. Spheres have those of these strains and numbers that their test has. Raises
    ValueError for a result without such a stage."""
    return states_of(find_test(result, stage))


def states_of(test):
    """As `of_states`, of a Test."""
    return named_curves(_core.curves_of_states(*test))


def of_cycles(result, stage=None):
    """Curves over the cycles of a stage with `cycles`: `cycle`, and every curve of `of_states` at the largest and at
    the smallest load of each, `axial_strain_maximum`, `z_minimum`; `strain_amplitude` between the two;
    `accumulated_strain` at the smallest load since the end of the first cycle; `dissipated_energy` in each cycle.
    Raises ValueError for a stage without cycles.
    """
    return cycles_of(find_test(result, stage))


def cycles_of(test):
    """As `of_cycles`, of a Test."""
    return named_curves(_core.curves_of_cycles(*test))


def every_cycle(result, stage=None):
    """Strains, stresses and energies of `along` at the largest and at the smallest load or strain of every cycle, of a
    stage with `cycles` or `strain_cycles`, whether their states are stored or not: `cycle`, `axial_strain_maximum`,
    `shear_strain_minimum`; `accumulated_strain` at the smallest since the end of the first. Raises ValueError for a
    stage without cycles."""
    return every_cycle_of(find_test(result, stage))


def every_cycle_of(test):
    """As `every_cycle`, of a Test."""
    return named_curves(_core.curves_of_every_cycle(*test))


def steady(values):
    """(mean, standard error) of the steady part of a series (`arenite.steady_state`): neighbours in time are not
    independent."""
    known = values[np.isfinite(values)]
    found = steady_state(known) if len(known) else {"mean": np.nan, "error": np.nan}
    return found["mean"], found["error"]


def in_plane(stage, before):
    """The packing before a stage of disks; what a stage of spheres begins with tells nothing of its test."""
    return before if isinstance(stage, _core.Stage) else None


def tests_of(results, stage=None):
    """(stages, packings before them) of several results."""
    tests = [find_test(result, stage) for result in results]
    return [test.stage for test in tests], [in_plane(*test) for test in tests]


def rheology(results, stage=None):
    """mu(I) and phi(I) of sheared runs of disks or spheres: `inertial_number`, `mu` and `solid_fraction`, each the mean
    over the steady part of a run with its error (`mu_error`, `solid_fraction_error`), in the order of I. mu is q/p
    unless a wall slides or a cell is sheared, and the ratio of the means of the two stresses."""
    return named_curves(_core.rheology(*tests_of(results, stage)))

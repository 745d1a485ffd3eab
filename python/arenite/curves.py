"""Curves of a test: strains, stresses and fabric along a loading and over its cycles, and mu(I), phi(I) over several runs.

Each function returns a dict, {"axial_strain": Curve(values, unit), ...}; a Curve is a tuple of an array and its SI unit ("1"
for numbers). Strains are positive in compression, as in `arenite show --states`, relative to the state before the stage;
stresses of the sides are positive in compression, p their mean and q half the difference of the principal ones, so that q/p is the
sine of the mobilised angle of friction. Quantities that a result lacks are left out. For pandas: `pandas.DataFrame({name: c.values for
name, c in along(result).items()})`.
"""

import re
import tomllib
import types
from typing import NamedTuple

import numpy as np

from ._core import measure, steady_state

dissipations = ["dissipated_normal", "dissipated_friction", "dissipated_drag", "dissipated_breakage"]


class Curve(NamedTuple):
    """Values along a loading and their SI unit."""

    values: np.ndarray
    unit: str


class Test(NamedTuple):
    """A loading stage and the packing before it, the reference of strains; None if there is none."""

    stage: object
    before: object


def find_test(result, stage=None):
    """The stage of this name, or the last one that has a history. Raises ValueError if there is none."""
    stages = list(result.stages)
    found = [k for k, part in enumerate(stages) if has_history(part) and stage in (None, part.name)]
    if not found:
        names = ", ".join(part.name for part in stages)
        raise ValueError(
            f"there is no stage {stage} with a history; there are {names}"
            if stage
            else "this result holds no loading stage with a history"
        )
    earlier = [snapshot.packing for part in stages[: found[-1]] for snapshot in part.snapshots[-1:]]
    return Test(stages[found[-1]], earlier[-1] if earlier else None)


def has_history(stage):
    return len(stage.history.get("time", [])) > 1 and len(stage.snapshots) > 0


def along(result, stage=None):
    """The history sampled while a stage ran: `time`; `strain_x`, `strain_y`, `axial_strain` (of the axis that shortens
    most), `volumetric_strain`, `shear_strain` (of a sheared cell or between sliding walls; otherwise axial minus lateral strain);
    `sigma_xx`, `sigma_yy`, `tau`, `p`, `q`, `q_over_p` and, if a cell is sheared or a wall slides, `mu`, shear over normal stress
    there, negative for shear to the left; ratios are NaN if the
    sides are almost unloaded; `solid_fraction` of the whole box, `inertial_number`; for runs with
    track_energy `dissipated_energy` and `work` since the first row. Raises ValueError for a result without such a stage.
    """
    return curves_of(find_test(result, stage))


def curves_of(test):
    """As `along`, of a Test."""
    history, packing = test.stage.history, test.stage.snapshots[-1].packing
    found = {"time": Curve(history["time"] - history["time"][0], "s"), **strains(test)}
    found.update(stresses(test))
    area = extent(history, "x") * extent(history, "y")
    found["solid_fraction"] = Curve(np.pi * np.sum(packing.radius**2) / area, "1")
    pressure = found.get("sigma_xx" if sides_shear(test) else "sigma_yy") if "mu" in found else found.get("p")
    if pressure:
        found["inertial_number"] = Curve(inertial_number(found, pressure.values, packing), "1")
    found.update(energies(history))
    return found


def extent(history, axis):
    low, high = ("left", "right") if axis == "x" else ("bottom", "top")
    return history[f"{high}_position"] - history[f"{low}_position"]


def strains(test, snapshots=None):
    """{name: Curve} of the strains of a stage's history, or of stored states of it."""
    history = test.stage.history
    first, last = ({axis: extent(history, axis)[row] for axis in "xy"} for row in (0, -1))
    start = {"x": test.before.domain["width"], "y": test.before.domain["height"]} if test.before else first
    is_upright = last["y"] / start["y"] <= last["x"] / start["x"]
    shear = sheared_by(test)
    if snapshots is None:
        size = {axis: extent(history, axis) for axis in "xy"}
    else:
        size = {
            axis: np.array([snapshot.packing.domain[name] for snapshot in snapshots])
            for axis, name in (("x", "width"), ("y", "height"))
        }
        shear = None if shear is None else np.interp([snapshot.time for snapshot in snapshots], history["time"], shear)
    x, y = (1 - size[axis] / start[axis] for axis in "xy")
    axial, lateral = (y, x) if is_upright else (x, y)
    named = {
        "strain_x": x,
        "strain_y": y,
        "axial_strain": axial,
        "volumetric_strain": 1 - (1 - x) * (1 - y),
        "shear_strain": axial - lateral if shear is None else shear,
    }
    return {name: Curve(values, "1") for name, values in named.items()}


def sheared_by(test):
    """Shear strain of a sheared cell, or by walls that slide, from the first row of the history on; None where nothing is sheared."""
    history = test.stage.history
    if "shear_strain" in history:
        return history["shear_strain"] - history["shear_strain"][0]
    slide = {side: speed_in_time(test.stage, f"slide.{side}", speed) for side, speed in slides(test.stage).items()}
    rate = np.zeros(len(history["time"]))
    for one, other, axis in (("top", "bottom", "y"), ("right", "left", "x")):
        rate = rate + (slide.get(one, 0) - slide.get(other, 0)) / extent(history, axis)
    if not np.any(rate):
        return None
    return np.concatenate([[0], np.cumsum(0.5 * (rate[1:] + rate[:-1]) * np.diff(history["time"]))])


def stage_recipe(stage):
    """The recipe of a stage; {} if it is not known."""
    recipe = tomllib.loads(stage.provenance.get("recipe", ""))
    own = [part for part in recipe.get("stages", []) if part.get("name") == stage.name]
    return own[-1] if own else {}


def slides(stage):
    """{side: m/s} of sliding walls, from the stage's recipe; the initial value if a programme drives them."""
    own = stage_recipe(stage)
    speeds = {side: speed_of(text) for side, text in own.get("slide", {}).items()}
    driven = {
        programme["of"].removeprefix("slide.")
        for programme in own.get("programmes", [])
        if programme["of"].startswith("slide.")
    }
    return {side: speed for side, speed in speeds.items() if speed or side in driven}


def speed_in_time(stage, of, speed):
    """m/s at every row of the history: of the stage's programme for `of`, which begins with the stage, else `speed`."""
    own, time = stage_recipe(stage), stage.history["time"]
    begin = time[-1] - seconds(own["duration"]) if "duration" in own else time[0]
    for programme in own.get("programmes", []):
        if programme["of"] == of:
            return programme_at(programme, time - begin, speed_of)
    return np.full(len(time), speed)


def programme_at(programme, time, value_of):
    """What a programme of a recipe says at times (s) since its stage began."""
    rows = [(seconds(at), value_of(value)) for at, value in programme["table"]]
    return np.interp(np.mod(time, rows[-1][0]) if programme.get("repeat") else time, *np.array(rows).T)


def seconds(text):
    """s of "0.5 s" or "20 ms", as resolved recipes write it."""
    number, unit = (str(text).split() + ["s"])[:2]
    return float(number) * {"us": 1e-6, "ms": 1e-3, "s": 1.0}[unit]


def speed_of(text):
    """m/s of "50 mm/s" or "0.05 m/s", as resolved recipes write it."""
    number, unit = str(text).split()
    return float(number) * {"mm/s": 1e-3, "m/s": 1.0}[unit]


def stresses(test):
    """{name: Curve} of the mean stresses on the sides, or of a periodic cell."""
    history, thickness = test.stage.history, test.stage.snapshots[-1].packing.domain["thickness"]
    over = {"x": extent(history, "y") * thickness, "y": extent(history, "x") * thickness}
    xx = 0.5 * (history["left_force"] + history["right_force"]) / over["x"]
    yy = 0.5 * (history["bottom_force"] + history["top_force"]) / over["y"]
    aside = sides_shear(test)
    # Positive where the top, or the right side, is held back from going right, or up.
    tau = 0.5 * (
        (history["left_shear_force"] - history["right_shear_force"]) / over["x"]
        if aside
        else (history["bottom_shear_force"] - history["top_shear_force"]) / over["y"]
    )
    known = {name: Curve(values, "Pa") for name, values in (("sigma_xx", xx), ("sigma_yy", yy)) if np.any(values)}
    if not known:
        return {}
    if np.any(tau):
        known["tau"] = Curve(tau, "Pa")
    if len(known.keys() & {"sigma_xx", "sigma_yy"}) == 2:
        p, q = 0.5 * (xx + yy), np.hypot(0.5 * (xx - yy), tau)
        known.update(p=Curve(p, "Pa"), q=Curve(q, "Pa"), q_over_p=Curve(ratio(q, loaded(p)), "1"))
    if sheared_by(test) is not None:
        known["mu"] = Curve(ratio(tau, loaded(xx if aside else yy)), "1")
    return known


def sides_shear(test):
    """Whether the left or the right wall slides."""
    return bool(slides(test.stage).keys() & {"left", "right"})


def loaded(stress):
    """A stress, set to 0 below a hundredth of its largest value, where ratios to it are noise."""
    return np.where(stress > 0.01 * np.max(stress), stress, 0)


def ratio(a, b):
    """a/b, and NaN where b is 0."""
    return np.divide(a, b, out=np.full(np.shape(a), np.nan), where=b != 0)


def inertial_number(found, pressure, packing):
    """Rate of shear times mean diameter over the speed sqrt(pressure/density) (GDR MiDi, Eur. Phys. J. E 14, 341, 2004); the pressure
    is that on the sheared plane, or p where there is none."""
    rate = np.gradient(found["shear_strain"].values, found["time"].values)
    density = np.array([material.density for material in packing.materials])[packing.material]
    mean_density = np.sum(density * packing.radius**2) / np.sum(packing.radius**2)
    return (
        np.abs(rate) * 2 * np.mean(packing.radius) * np.sqrt(ratio(np.full(len(rate), mean_density), loaded(pressure)))
    )


def energies(history):
    """Relative to the first row; empty if the run did not track energies."""
    none = np.zeros(len(history["time"]))
    spent, work = (
        sum((history.get(name, none) for name in names), none)
        for names in (dissipations, ["work_walls", "work_gravity"])
    )
    if not np.any(spent) and not np.any(work):
        return {}
    return {"dissipated_energy": Curve(spent - spent[0], "J"), "work": Curve(work - work[0], "J")}


# (name, unit) and its path in the statistics of a state.
textures = {
    ("solid_fraction", "1"): ("solid_fraction",),
    ("z", "1"): ("coordination", "all"),
    ("z_without_rattlers", "1"): ("coordination", "without_rattlers"),
    ("rattlers", "1"): ("coordination", "rattlers"),
    ("a_c", "1"): ("fabric", "a_c"),
    ("a_c_signed", "1"): ("fabric", "a_c_signed"),
    ("a_c_strong", "1"): ("fabric", "sets", "strong", "a_c_signed"),
    ("a_c_weak", "1"): ("fabric", "sets", "weak", "a_c_signed"),
    ("a_n", "1"): ("fabric", "a_n"),
    ("a_t", "1"): ("fabric", "a_t"),
    ("theta_c", "deg"): ("fabric", "theta_c_deg"),
    ("mean_force", "N"): ("force", "mean_N"),
    ("p", "Pa"): ("stress_details", "pressure_Pa"),
    ("q", "Pa"): ("stress_details", "deviator_Pa"),
}


def of_states(result, stage=None):
    """Fabric against strain, for the stored states of a stage: the strains of `along` and `solid_fraction` (away from the walls),
    `z`, `z_without_rattlers`, `rattlers`, `a_c` (and signed along the compression: all, strong, weak contacts), `a_n`, `a_t`,
    `theta_c`, `mean_force`, `p`, `q`, `q_over_p` of the contacts; with standard errors such as `z_error`. NaN if a state has
    no value. Raises ValueError for a result without such a stage."""
    return states_of(find_test(result, stage))


def states_of(test):
    """As `of_states`, of a Test."""
    snapshots = test.stage.snapshots
    found = {
        "time": Curve(np.array([snapshot.time for snapshot in snapshots]) - test.stage.history["time"][0], "s"),
        **strains(test, snapshots),
    }
    measured = [
        measure(snapshot.packing, curves=False) if len(snapshot.packing.contacts) > 0 else {} for snapshot in snapshots
    ]
    for (name, unit), path in textures.items():
        values, errors = np.array([statistic(about, path) for about in measured], float).reshape(-1, 2).T
        if np.any(np.isfinite(values)):
            found[name] = Curve(values, unit)
        if np.any(np.isfinite(errors)):
            found[f"{name}_error"] = Curve(errors, unit)
    if "p" in found and "q" in found:
        found["q_over_p"] = Curve(ratio(found["q"].values, found["p"].values), "1")
    return found


def statistic(about, path):
    """(value, error) of a statistic; NaN if there is none."""
    for name in path:
        about = about.get(name, {}) if isinstance(about, dict) else {}
    if isinstance(about, dict):
        return [np.nan if about.get(key) is None else about[key] for key in ("value", "error")]
    return [about, np.nan]


def of_cycles(result, stage=None):
    """Curves over the cycles of a stage with `cycles`: `cycle`, and every curve of `of_states` at the largest and at the
    smallest load of each, `axial_strain_maximum`, `z_minimum`; `strain_amplitude` between the two; `accumulated_strain` at the
    smallest load since the end of the first cycle; `dissipated_energy` in each cycle. Raises ValueError for a stage without cycles.
    """
    return cycles_of(find_test(result, stage))


def whole_cycles(stage):
    """{number: (place of the maximum, place of the minimum)} of the stored states of whole cycles."""
    labels = [re.fullmatch(r"cycle (\d+) (maximum|minimum)", snapshot.label) for snapshot in stage.snapshots]
    place = {(int(found[1]), found[2]): k for k, found in enumerate(labels) if found}
    return {
        n: (place[n, "maximum"], k)
        for (n, end), k in sorted(place.items())
        if end == "minimum" and (n, "maximum") in place
    }


def cycles_of(test):
    """As `of_cycles`, of a Test."""
    cycles = whole_cycles(test.stage)
    if not cycles:
        raise ValueError(f"the stage {test.stage.name} has no complete load cycle")
    found = {"cycle": Curve(np.array(list(cycles), float), "1")}
    for name, curve in states_of(test).items():
        for end, places in zip(("maximum", "minimum"), zip(*cycles.values())):
            found[f"{name}_{end}"] = Curve(curve.values[list(places)], curve.unit)
    low, high = found["axial_strain_minimum"].values, found["axial_strain_maximum"].values
    found["strain_amplitude"], found["accumulated_strain"] = Curve(high - low, "1"), Curve(low - low[0], "1")
    spent = energies(test.stage.history).get("dissipated_energy")
    if spent:
        found["dissipated_energy"] = Curve(
            np.diff(np.interp(ends_of(test.stage, cycles), test.stage.history["time"], spent.values)), "J"
        )
    return found


def every_cycle(result, stage=None):
    """Strains, stresses and energies of `along` at the largest and at the smallest load or strain of every cycle, of a stage with `cycles` or
    `strain_cycles`, whether their states are stored or not: `cycle`, `axial_strain_maximum`, `shear_strain_minimum`; `accumulated_strain` at the
    smallest since the end of the first. Raises ValueError for a stage without cycles."""
    return every_cycle_of(find_test(result, stage))


def every_cycle_of(test):
    """As `every_cycle`, of a Test."""
    table, history = dict(getattr(test.stage, "cycles", {})), test.stage.history
    if not table:
        raise ValueError(f"the stage {test.stage.name} has no complete cycle")
    before = test.before or types.SimpleNamespace(
        domain={"width": extent(history, "x")[0], "height": extent(history, "y")[0]}
    )
    rows = types.SimpleNamespace(
        name=test.stage.name, history=table, snapshots=test.stage.snapshots, provenance=test.stage.provenance
    )
    of_rows = curves_of(Test(rows, before))
    if "shear_strain" in table:
        of_rows["shear_strain"] = Curve(table["shear_strain"] - history["shear_strain"][0], "1")
    whole = len(table["cycle"]) // 2
    found = {"cycle": Curve(table["cycle"][1::2][:whole], "1")}
    for name, curve in of_rows.items():
        if name not in ("time", "inertial_number"):
            found[f"{name}_maximum"], found[f"{name}_minimum"] = Curve(
                curve.values[0 : 2 * whole : 2], curve.unit
            ), Curve(curve.values[1 : 2 * whole : 2], curve.unit)
    own = stage_recipe(test.stage)
    side = own.get("strain_cycles", {}).get("of") or own.get("cycles", {}).get("side")
    for end in (
        ("maximum", "minimum") if side in ("left", "right", "bottom", "top") else ()
    ):  # which axis cycles, not which has shortened in the end
        found[f"axial_strain_{end}"] = found[f"strain_{'x' if side in ('left', 'right') else 'y'}_{end}"]
    low = found["axial_strain_minimum"].values
    found["accumulated_strain"] = Curve(low - low[0], "1")
    return found


def ends_of(stage, cycles):
    """Time of the state before the first cycle, or of the first row, and of the ends of all cycles."""
    before = [snapshot.time for snapshot in stage.snapshots if not snapshot.label.startswith("cycle")]
    return np.array(
        [before[-1] if before else stage.history["time"][0]] + [stage.snapshots[low].time for _, low in cycles.values()]
    )


def steady(values):
    """(mean, standard error) of the steady part of a series (`arenite.steady_state`): neighbours in time are not independent."""
    known = values[np.isfinite(values)]
    found = steady_state(known) if len(known) else {"mean": np.nan, "error": np.nan}
    return found["mean"], found["error"]


def parts_of_ratio(test, found):
    """Shear and normal stress of the sheared sides, or q and p: the two whose ratio is the friction of a test; `found` as
    curves_of gives it."""
    if "mu" not in found:
        return found["q"].values, found["p"].values
    normal = found["sigma_xx" if sides_shear(test) else "sigma_yy"].values
    return found["tau"].values if "tau" in found else np.zeros(len(normal)), normal


def about_ratio_of_means(shear, normal):
    """A series whose mean is |<shear>/<normal>| and whose fluctuations are those that the error of this ratio comes from: a
    mean of ratios is another number, because both stresses fluctuate together."""
    ratio = np.mean(shear) / np.mean(normal)
    return np.sign(ratio) * (ratio + (shear - ratio * normal) / np.mean(normal))


def steady_ratio(shear, normal):
    """(ratio of the means, its standard error) of two stresses, over the part in which their ratio is steady
    (`arenite.steady_state`)."""
    loaded_rows = normal > 0.01 * np.max(normal)
    shear, normal = shear[loaded_rows], normal[loaded_rows]
    if len(shear) == 0:
        return np.nan, np.nan
    first = steady_state(np.abs(shear) / normal)["first"]
    about = about_ratio_of_means(shear[first:], normal[first:])
    return np.mean(about), steady(about)[1]


def rheology(results, stage=None):
    """mu(I) and phi(I) of sheared runs: `inertial_number`, `mu` and `solid_fraction`, each the mean over the steady part of
    a run with its error (`mu_error`, `solid_fraction_error`), in the order of I. mu is q/p unless a wall slides or a cell is
    sheared, and the ratio of the means of the two stresses."""
    rows = []
    for result in results:
        test = find_test(result, stage)
        found = curves_of(test)
        friction, density = steady_ratio(*parts_of_ratio(test, found)), steady(found["solid_fraction"].values)
        rows.append([steady(found["inertial_number"].values)[0], *friction, *density])
    table = np.array(sorted(rows), float).reshape(-1, 5).T
    return {
        name: Curve(values, "1")
        for name, values in zip(["inertial_number", "mu", "mu_error", "solid_fraction", "solid_fraction_error"], table)
    }

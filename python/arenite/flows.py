"""Results of studies of gravity flow and shear: discharge against opening (Beverloo), run-out against aspect ratio, pressure at
the bottom of a silo against its filling (Janssen), solid fraction and friction of the critical state against the grains' friction.

Each returns a dict, {"opening": Curve(values, unit), ...}, with one value per result in the order of the abscissa and errors
("rate_error"); the fits return {"exponent": (value, error), ...}.
"""

import tomllib

import numpy as np

from . import curves
from ._core import free_surface, steady_state
from .curves import Curve


def table(rows, names):
    """{name: Curve} of rows in the order of their first number; `names` of (name, unit)."""
    values = np.array(sorted(rows), float).reshape(-1, len(names)).T
    return {name: Curve(column, unit) for (name, unit), column in zip(names, values)}


def last_numbers(result, part):
    """The statistic of this name of the last stage; {} if there is none."""
    stages = list(result.stages)
    return stages[-1].texture.get(part, {}) if stages else {}


def estimate(number):
    """(value, error) of a stored number, NaN if not known."""
    return [np.nan if number.get(key) is None else number[key] for key in ("value", "error")]


def discharges(results):
    """`opening` (m, the narrowest gap between boundaries) and `rate` (kg/s) with its error, of results whose last stage discharges."""
    found = [last_numbers(result, "discharge") for result in results]
    rows = [[n["opening_m"], *estimate(n["rate_kg_s"])] for n in found if "opening_m" in n]
    return table(rows, [("opening", "m"), ("rate", "kg/s"), ("rate_error", "kg/s")])


def runouts(results):
    """Of results whose last stage is a collapse: `aspect_ratio`, height over width, before; `runout`, displacement of the front over that width,
    with its error; `height` of the deposit over that width; `angle` of the deposit (deg) with its error."""
    rows = []
    for n in (last_numbers(result, "surface") for result in results):
        if "runout_over_width" in n:
            rows.append(
                [
                    n["aspect_ratio_before"],
                    *estimate(n["runout_over_width"]),
                    n["height_over_width"],
                    *estimate(n.get("angle_deg", {})),
                ]
            )
    return table(
        rows,
        [(name, "1") for name in ("aspect_ratio", "runout", "runout_error", "height")]
        + [("angle", "deg"), ("angle_error", "deg")],
    )


def gravity_of(stage):
    """Acceleration of gravity in a stage, m/s^2, as its recipe has it: at the end of its programme, if it has one; 9.81 m/s^2
    unless given."""
    own = curves.stage_recipe(stage)

    def in_si(text):
        return float(str(text).split()[0])

    size = in_si(own.get("gravity_size", "9.81 m/s^2"))
    for programme in own.get("programmes", []):
        if programme["of"] == "gravity_size":
            size = curves.programme_at(programme, curves.seconds(own["duration"]), in_si)
    return size


def silo_state(result):
    """Of a silo whose floor sinks: [height of the filling, force on the floor with its error, weight, wall friction mobilised, ratio
    K = <sigma_xx>/<sigma_yy>, width, depth], means over the second half of the last stage."""
    stage = list(result.stages)[-1]
    history, packing = stage.history, stage.snapshots[-1].packing
    floor, error = late_mean(history["bottom_force"])
    half = slice(len(history["bottom_force"]) // 2, None)
    density = np.array([material.density for material in packing.materials])[packing.material]
    thickness, width = packing.domain["thickness"], packing.domain["width"]
    weight = gravity_of(stage) * np.pi * thickness * np.sum(density * packing.radius**2)
    surface = free_surface(packing)
    sides = np.mean(history["left_force"][half]) + np.mean(history["right_force"][half])
    states = [snapshot.packing for snapshot in stage.snapshots[len(stage.snapshots) // 2 :]]
    sigma = sum(mean_stress(state) for state in states)
    return [
        np.mean(surface["height"]) - surface["bottom"],
        floor,
        error,
        weight,
        (weight - floor) / sides,
        sigma[0] / sigma[1],
        width,
        thickness,
    ]


def block_mean(values, blocks=10):
    """(mean, standard error) of a series, from the scatter of block means: neighbours in time are not independent."""
    means = [np.mean(block) for block in np.array_split(values, blocks)]
    return np.mean(means), np.std(means, ddof=1) / np.sqrt(blocks)


def late_mean(values):
    """block_mean of the second half of a series."""
    return block_mean(values[len(values) // 2 :])


def mean_stress(packing):
    """Sum over contacts of force times branch, along x and y: the mean stress times the area."""
    c = packing.contacts
    branch, fn, ft = c.arm_i + c.arm_j, c.fn, c.ft
    return np.array([np.sum((fn * c.nx - ft * c.ny) * branch * c.nx), np.sum((fn * c.ny + ft * c.nx) * branch * c.ny)])


def silos(results):
    """`height` of the filling (m), mean `pressure` on the floor (Pa) with its error, the pressure of a liquid of the same bulk density
    (`hydrostatic`), `wall_friction` as mobilised, `ratio` K of horizontal and vertical stress, `width` (m), of results whose floor sinks in the
    last stage."""
    rows = []
    for height, force, error, weight, friction, ratio, width, depth in map(silo_state, results):
        rows.append(
            [height, force / (width * depth), error / (width * depth), weight / (width * depth), friction, ratio, width]
        )
    return table(
        rows,
        [
            ("height", "m"),
            ("pressure", "Pa"),
            ("pressure_error", "Pa"),
            ("hydrostatic", "Pa"),
            ("wall_friction", "1"),
            ("ratio", "1"),
            ("width", "m"),
        ],
    )


def friction_of(result):
    """Friction coefficient between grains in the recipe of the last stage."""
    recipe = tomllib.loads(list(result.stages)[-1].provenance["recipe"])
    return float(recipe["stages"][-1].get("friction", recipe["contact"]["friction"]))


def critical_states(results, stage=None):
    """Plateaus of sheared or compressed samples against the grains' `friction`: `mu` (on the sheared plane; q/p without
    shear; a ratio of means) and `solid_fraction`, with errors that allow for correlation; `reached` is 0 if the plateau is
    uncertain (`arenite.steady_state`): the means are then those of the second half."""
    rows = []
    for result in results:
        test = curves.find_test(result, stage)
        found = curves.curves_of(test)
        loaded = np.isfinite(found["mu" if "mu" in found else "q_over_p"].values)
        shear, normal = (values[loaded] for values in curves.parts_of_ratio(test, found))
        solid = found["solid_fraction"].values
        plateaus = [steady_state(np.abs(shear) / normal), steady_state(solid)]
        half = len(shear) // 2
        friction = curves.steady_ratio(shear, normal)
        if not plateaus[0]["reached"] or not np.isfinite(friction[1]):
            friction = block_mean(curves.about_ratio_of_means(shear[half:], normal[half:]))
        density = (plateaus[1]["mean"], plateaus[1]["error"]) if plateaus[1]["reached"] else late_mean(solid)
        rows.append([friction_of(result), *friction, *density, all(plateau["reached"] for plateau in plateaus)])
    return table(
        rows,
        [(name, "1") for name in ("friction", "mu", "mu_error", "solid_fraction", "solid_fraction_error", "reached")],
    )


def fit(model, start, x, y, error, rounds=200):
    """Least squares of y = model(x, parameters) weighted by `error`, by the Levenberg-Marquardt method: (parameters, their standard
    errors), scaled up if the points scatter more than their errors. Unknown errors are set to the largest known one,
    or all equal."""
    known = np.isfinite(error) & (error > 0)
    scale = (
        np.where(known, error, np.max(error[known]))
        if np.any(known)
        else np.full(len(y), np.std(y) if len(y) > 1 else 1.0)
    )
    p, damping = np.array(start, float), 1e-3
    residual = (y - model(x, p)) / scale
    for _ in range(rounds):
        steps = 1e-6 * np.maximum(np.abs(p), 1e-9)
        slope = np.array(
            [(model(x, p + step) - model(x, p - step)) / (2 * np.max(step)) / scale for step in np.diag(steps)]
        ).T
        normal = slope.T @ slope
        trial = p + np.linalg.solve(normal + damping * np.diag(np.diag(normal)), slope.T @ residual)
        new = (y - model(x, trial)) / scale
        better = np.all(np.isfinite(new)) and np.sum(new**2) <= np.sum(residual**2)
        done = better and np.sum(residual**2) - np.sum(new**2) < 1e-12 * np.sum(new**2)
        if better:
            p, residual = trial, new
        damping = damping / 5 if better else damping * 5
        if done or damping > 1e12:
            break
    freedom = max(1, len(y) - len(p))
    spread = max(1.0, np.sum(residual**2) / freedom) if np.any(known) else np.sum(residual**2) / freedom
    return p, np.sqrt(np.diag(np.linalg.inv(normal)) * spread)


def named(names, found):
    return {name: (float(value), float(error)) for name, value, error in zip(names, *found)}


def fit_beverloo(found, exponent=None):
    """W = a (D - w)^n of `discharges`: `factor` a, `lost_width` w (m; k d) and, unless given, `exponent` n. In two dimensions n = 3/2
    (Beverloo, Leniger and van de Velde, Chem. Eng. Sci. 15, 260, 1961) and a = C rho_b sqrt(g) times the out-of-plane length.
    """
    x, y, error = (found[name].values for name in ("opening", "rate", "rate_error"))
    n = 1.5 if exponent is None else exponent
    slope, intercept = np.polyfit(x, y ** (1 / n), 1)
    start = [slope**n, max(-intercept / slope, 0)]

    def model(d, p):
        return p[0] * np.maximum(d - p[1], 1e-9) ** (p[2] if len(p) > 2 else n)

    return named(
        ["factor", "lost_width", "exponent"], fit(model, start + ([n] if exponent is None else []), x, y, error)
    )


def fit_power(x, y, error):
    """y = a x^n: `factor`, `exponent`."""
    n, log_a = np.polyfit(np.log(x), np.log(y), 1)
    return named(["factor", "exponent"], fit(lambda at, p: p[0] * at ** p[1], [np.exp(log_a), n], x, y, error))


def fit_runout(found, low=2.5, high=2.5):
    """Power laws of `runouts` below and above aspect ratios: {"low": ..., "high": ...} as fit_power gives them. Grains on a plane spread by
    about a below 2 to 3 and by a^(2/3) to a^0.7 above (Lube et al., Phys. Rev. E 72, 041301, 2005; Lajeunesse, Monnier and Homsy, Phys. Fluids
    17, 103302, 2005; Staron and Hinch, J. Fluid Mech. 545, 1, 2005). The points have equal weights: the front scatters, not the measurement of its position.
    """
    x, y = found["aspect_ratio"].values, found["runout"].values
    parts = {"low": x <= low, "high": x >= high}
    return {name: fit_power(x[part], y[part], 0.05 * y[part]) for name, part in parts.items() if np.sum(part) > 2}


def fit_janssen(found):
    """p = p_s (1 - exp(-H/l)) of `silos` (Janssen 1895): `saturation` p_s (Pa), `length` l (m); `length_by_stresses`, W/(2 mu_w K) with the wall
    friction and the ratio of stresses measured in the taller half of the fillings, which represent the saturated part.
    """
    x, y, error = (found[name].values for name in ("height", "pressure", "pressure_error"))
    start = [np.max(y), np.max(y) / max(np.max(found["hydrostatic"].values / x), 1e-300)]
    result = named(["saturation", "length"], fit(lambda h, p: p[0] * -np.expm1(-h / p[1]), start, x, y, error))
    upper = slice(len(x) // 2, None)
    lengths = (found["width"].values / (2 * found["wall_friction"].values * found["ratio"].values))[upper]
    result["length_by_stresses"] = (
        float(np.mean(lengths)),
        float(np.std(lengths, ddof=1) / np.sqrt(len(lengths))) if len(lengths) > 1 else np.nan,
    )
    return result

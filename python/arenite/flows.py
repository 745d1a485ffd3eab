"""Results of studies of gravity flow and shear: discharge against opening (Beverloo), run-out against aspect ratio,
pressure at the bottom of a silo against its filling (Janssen), solid fraction and friction of the critical state
against the grains' friction.

Each returns a dict, {"opening": Curve(values, unit), ...}, with one value per result in the order of the abscissa and
errors ("rate_error"); the fits return {"exponent": (value, error), ...}. The numbers are the library's
(`grains/fields`).
"""

import math

from . import _core
from .curves import named_curves, tests_of


def last_stages(results):
    """The last stage of every result that has one, of disks or of spheres."""
    stages = ([*result.stages, *getattr(result, "spheres", [])] for result in results)
    return [list_[-1] for list_ in stages if list_]


def discharges(results):
    """`opening` (m, the narrowest gap between boundaries; in space the diameter, four areas over the rim, of the
    narrowest opening in one) and `rate` (kg/s) with its error, of results whose last stage discharges."""
    return named_curves(_core.discharges(last_stages(results)))


def runouts(results):
    """Of results whose last stage is a collapse: `aspect_ratio`, height over width, before; `runout`, displacement of
    the front over that width, with its error; `height` of the deposit over that width; `angle` of the deposit (deg)
    with its error."""
    return named_curves(_core.runouts(last_stages(results)))


def gravity_of(stage):
    """Acceleration of gravity that a stage was asked for, m/s^2: at the end of its programme, if it has one; NaN where
    it is not known."""
    return _core._gravity_of(stage)


def silos(results):
    """`height` of the filling (m), mean `pressure` on the floor (Pa) with its error, the pressure of a liquid of the
    same bulk density (`hydrostatic`) under the gravity that acted, `wall_friction` as mobilised, `ratio` K of
    horizontal and vertical stress, `width` (m), means over the second half of the last stage of results whose floor
    sinks in it."""
    return named_curves(_core.silos(last_stages(results)))


def friction_of(result):
    """Friction coefficient between grains in the last stage; NaN where it is not known."""
    return last_stages([result])[-1].asked.get("friction", math.nan)


def critical_states(results, stage=None):
    """Plateaus of sheared or compressed samples against the grains' `friction`: `mu` (on the sheared plane; q/p without
    shear; a ratio of means) and `solid_fraction`, with errors that allow for correlation; `reached` is 0 if the plateau
    is uncertain (`arenite.steady_state`): the means are then those of the second half."""
    return named_curves(_core.critical_states(*tests_of(results, stage)))


def values_of(found, *names):
    """Values of curves by name."""
    return (found[name].values for name in names)


def fit_beverloo(found, exponent=None):
    """W = a (D - w)^n of `discharges`: `factor` a, `lost_width` w (m; k d) and, unless given, `exponent` n, which is
    5/2 in space (Beverloo, Leniger and van de Velde, Chem. Eng. Sci. 15, 260, 1961), with a = C rho_b sqrt(g), and 3/2
    in two dimensions, with a = C rho_b sqrt(g) times the out-of-plane length.
    """
    return _core.fit_beverloo(*values_of(found, "opening", "rate", "rate_error"), exponent=exponent)


def fit_power(x, y, error):
    """y = a x^n: `factor`, `exponent`."""
    return _core.fit_power(x, y, error)


def fit_runout(found, low=_core._runout_bend, high=_core._runout_bend):
    """Power laws of `runouts` below and above aspect ratios: {"low": ..., "high": ...} as fit_power gives them. Grains
    on a plane spread by about a below 2 to 3 and by a^(2/3) to a^0.7 above (Lube et al., Phys. Rev. E 72, 041301, 2005;
    Lajeunesse, Monnier and Homsy, Phys. Fluids 17, 103302, 2005; Staron and Hinch, J. Fluid Mech. 545, 1, 2005). The
    points have equal weights: the front scatters, not the measurement of its position.
    """
    return _core.fit_runout(*values_of(found, "aspect_ratio", "runout"), low=low, high=high)


def fit_janssen(found):
    """p = p_s (1 - exp(-H/l)) of `silos` (Janssen 1895): `saturation` p_s (Pa), `length` l (m); `length_by_stresses`,
    W/(2 mu_w K) with the wall friction and the ratio of stresses measured in the taller half of the fillings, which
    represent the saturated part.
    """
    law = _core.fit_janssen(*values_of(found, "height", "pressure", "pressure_error", "hydrostatic"))
    by_stresses = _core.length_by_stresses(*values_of(found, "width", "wall_friction", "ratio"))
    return {**law, "length_by_stresses": by_stresses}

"""Scatter over seeds against told errors: what judge.py runs and writes is judged here."""

import itertools
import math
import statistics
import typing

fewest_grains = 50  # of which errors by blocks can be told: a texture of fewer, as of a small film, is not judged
required_share, largest_ratio = 0.95, 2
most_beyond = 1.25  # over what chance gives: the numbers of one sample depend on each other


def band_of_ratios(seeds, told):
    """Between which ratios 99 % of honest ones lie, for a scatter of `seeds` and a mean square error of `told` degrees
    of freedom: Fisher's F, after E. B. Wilson and M. M. Hilferty (PNAS 17, 684, 1931)."""
    a, b = 2 / (9 * seeds), 2 / (9 * told)

    def bound(sign):
        # The cube root of F is x with ((1 - b) x - (1 - a))^2 = z^2 (a + b x^2).
        z = 2.5758
        square, linear, rest = (1 - b) ** 2 - z * z * b, (1 - a) * (1 - b), (1 - a) ** 2 - z * z * a
        x = (linear + sign * math.sqrt(max(0, linear * linear - square * rest))) / square
        return math.sqrt(max(0, x) ** 3)

    return bound(-1), bound(1)


def beyond_by_chance(freedom):
    """How often two honest values lie more than two errors of their difference apart, each error of so many degrees of
    freedom: Student's t with twice as many."""
    nu, steps = 2 * freedom, 400
    height = math.exp(math.lgamma((nu + 1) / 2) - math.lgamma(nu / 2)) / math.sqrt(nu * math.pi)
    middle = sum((1 + ((k + 0.5) * 2 / steps) ** 2 / nu) ** (-(nu + 1) / 2) for k in range(steps))
    return 1 - 2 * height * middle * 2 / steps


class Told(typing.NamedTuple):
    """A number as a result tells it: an angle with the period after which it is the same again."""

    value: float
    error: float
    low: float | None = None
    high: float | None = None
    period: float | None = None


def of_tensor(name, value, error):
    """{name.01: Told} of its components, each pair of shear components once."""
    parts = {}
    for r, row in enumerate(value):
        for c in range(r, len(row) if isinstance(row, list) else 0):
            if error[r][c] is not None:
                parts[f"{name}.{r}{c}"] = Told(row[c], error[r][c])
    return parts


def flattened(node, name=""):
    """{name: Told} of all numbers of a result that have an error."""
    if not isinstance(node, dict):
        return {}
    if "value" in node:
        value, error = node["value"], node.get("error")
        if isinstance(value, list):
            return of_tensor(name, value, error) if error else {}
        known = isinstance(error, (int, float)) and value is not None
        return {name: Told(value, error, node.get("low_95"), node.get("high_95"), node.get("period"))} if known else {}
    considered = node.get("considered")
    if isinstance(considered, dict) and considered.get("grains", fewest_grains) < fewest_grains:
        return {}
    found = {}
    for own, inner in node.items():
        if own not in ("provenance", "stages", "contact_orientations"):
            found.update(flattened(inner, f"{name}.{own}" if name else own))
    return found


def apart(a, b, turn):
    """How far two values lie apart, two angles around the circle."""
    return math.remainder(a - b, turn) if turn else a - b


def mean_of(values, turn):
    """Their mean, that of directions for angles."""
    if not turn:
        return statistics.fmean(values)
    angle = [2 * math.pi * v / turn for v in values]
    return math.atan2(sum(map(math.sin, angle)), sum(map(math.cos, angle))) * turn / (2 * math.pi)


class Judged:
    """One number over the seeds, each Told: `ratio` of the scatter to the told error, with
    the band of honest ones, `mean`, `told`; `freedom` of an error, as the errors scatter; `covered` seeds whose 95 %
    interval holds the mean (None without intervals); share `beyond` of all pairs of seeds that differ by more than two
    errors, and `chance` of it."""

    def __init__(self, name, seeds):
        self.period = turn = seeds[0].period
        self.name, self.seeds = name, len(seeds)
        self.mean = mean_of([s.value for s in seeds], turn)
        self.scatter = math.sqrt(sum(apart(s.value, self.mean, turn) ** 2 for s in seeds) / (len(seeds) - 1))
        squares = [s.error * s.error for s in seeds]
        mean_square, spread = statistics.fmean(squares), statistics.variance(squares)
        self.told = math.sqrt(mean_square)
        self.ratio = self.scatter / self.told if self.told > 0 else math.inf
        self.freedom = min(max(2 * mean_square**2 / spread, 1), 200) if spread > 0 else 200
        self.low, self.high = band_of_ratios(len(seeds) - 1, len(seeds) * self.freedom)
        intervals = [(s.low, s.high) for s in seeds if s.low is not None]
        self.covered = sum(low <= self.mean <= high for low, high in intervals) if intervals else None
        pairs = list(itertools.combinations(seeds, 2))
        far = sum(abs(apart(a.value, b.value, turn)) > 2 * math.hypot(a.error, b.error) for a, b in pairs)
        self.beyond, self.chance = far / len(pairs), beyond_by_chance(self.freedom)

    @property
    def inside(self):
        return self.low <= self.ratio <= self.high


class Study:
    """What was judged of a study, from the numbers of its runs. `compared`: of all numbers of all pairs of neighbouring
    seeds, the share that `arenite compare` finds beyond their errors."""

    def __init__(self, name, results, compared=None):
        self.name, self.seeds, self.compared = name, len(results), compared
        found = [flattened(result) for result in results]
        names = dict.fromkeys(key for one in found for key in one)
        known = [key for key in names if sum(key in one for one in found) >= max(3, 0.75 * len(found))]
        # What is exact is not judged, and what repeats another number (that of the only material, half of a_c) once.
        judged = [Judged(key, [one[key] for one in found if key in one]) for key in known]
        once = {f"{n.ratio:.9g} {abs(n.mean):.2g}" if n.period else f"{n.ratio:.9g}": n for n in reversed(judged)}
        self.numbers = [n for n in reversed(once.values()) if n.scatter > 1e-12 * abs(n.mean)]
        self.inside = [n for n in self.numbers if n.inside]
        self.worst = max(self.numbers, key=lambda n: n.ratio)
        self.beyond, self.chance = (statistics.fmean(getattr(n, w) for n in self.numbers) for w in ("beyond", "chance"))

    @property
    def share(self):
        return len(self.inside) / len(self.numbers)


def hold(judged):
    """Whether the errors of these studies do, taken together."""
    inside, numbers = sum(len(s.inside) for s in judged), sum(len(s.numbers) for s in judged)
    worst = max(s.worst.ratio for s in judged)
    beyond = max(share / s.chance for s in judged for share in (s.beyond, s.compared or 0))
    return inside >= required_share * numbers and worst <= largest_ratio and beyond <= most_beyond

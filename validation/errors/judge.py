#!/usr/bin/env python3
"""Whether told errors hold: samples that differ in their seed alone scatter by as much as each of them says.

    python3 validation/errors/judge.py                          all studies beside this file
    python3 validation/errors/judge.py --markdown docs/errors.md
    python3 validation/errors/judge.py --small                  two small studies, as the tests run them

Every number that has an error in a result is judged: the standard deviation over the seeds divided by the root mean
square of the told errors. An honest error gives 1, within the band that chance leaves (99 % of Fisher's F, of so many
seeds and of told errors that are themselves known from few blocks). Ends with status 3 where fewer than 95 % of the
numbers lie within the band, one of them is above 2, or seeds differ by more than two errors a quarter more often than
chance has it. Needs Python's standard library and `arenite` alone.
"""

import argparse
import csv
import itertools
import json
import math
import pathlib
import statistics
import subprocess
import sys
import tempfile
import typing

here = pathlib.Path(__file__).resolve().parent
fewest_grains = 50  # of which errors by blocks can be told: a texture of fewer, as of a small film, is not judged
required_share, largest_ratio = 0.95, 2
most_beyond = 1.25  # over what chance gives: the numbers of one sample depend on each other
studies = {
    "isotropic": "static packing",
    "biaxial": "biaxial test",
    "shear-slow": "slow shear",
    "shear-fast": "fast shear",
    "cemented": "cemented sample, pulled",
    "film": "film of a sample",
}
small = {
    "isotropic": ["packing.grains=250", 'container.width="130 mm"'],
    "shear-fast": ["populations.0.count=120", 'container.width="110 mm"', 'stages.1.duration="0.3 s"'],
}
main_numbers = """solid_fraction coordination.all fabric.a_c fabric.a_n force.mean_N force.strong_share force.beta
    force.beta_line force.alpha force.k force.log_likelihood_ratio sigma_norm.P0 sigma_norm.beta sigma_norm.beta_line
    stress.00 stress.01 stress.11 critical_state.mu critical_state.q_over_p critical_state.solid_fraction
    stress.sigma_yy.sets.large.mean_over_sample_mean stress.sigma_yy.sets.large.variance forces.mean_N""".split()


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


def run(arguments):
    done = subprocess.run([str(a) for a in arguments], capture_output=True, text=True)
    if done.returncode != 0:
        said = done.stderr.strip() or done.stdout.strip()
        raise SystemExit(f"{' '.join(str(a) for a in arguments[:3])}: {said}")
    return done.stdout


def results_of(program, name, out, changes, jobs):
    """The numbers of all runs of a study, whose missing runs are made, and the folders of their results."""
    sets = [part for change in changes for part in ("--set", change)]
    run([program, "study", "run", here / f"{name}.toml", "--out", out, "--quiet", "--jobs", jobs, *sets])
    folders = sorted((out / "runs").iterdir())
    camera = here / f"{name}-camera.toml"
    if camera.exists():
        numbers = [filmed(program, folder, camera, seed) for seed, folder in enumerate(folders, 1)]
        return numbers, [folder / "film" / "result" for folder in folders]
    return [json.loads((folder / "numbers.json").read_text(encoding="utf-8")) for folder in folders], folders


def share_compared(program, folders):
    """Of the numbers with errors of neighbouring seeds, those that `arenite compare` finds beyond them."""
    found = {"beyond errors": 0, "within errors": 0}
    with tempfile.TemporaryDirectory() as temporary:
        table = pathlib.Path(temporary) / "numbers.csv"
        for a, b in itertools.pairwise([*folders, folders[0]]):
            run([program, "compare", a, b, "--csv", table, "--out", table.with_suffix(".html")])
            with table.open(encoding="utf-8", newline="") as rows:
                for row in csv.DictReader(rows):
                    if row["verdict"] in found:
                        found[row["verdict"]] += 1
    return found["beyond errors"] / sum(found.values())


def filmed(program, folder, camera, seed):
    """The numbers of the film of a run, made where they are missing."""
    film, numbers = folder / "film", folder / "film.json"
    if not numbers.exists():
        run([program, "camera", folder, "--recipe", camera, "--out", film, "--quiet", "--set", f"seed={seed}"])
        run([program, "film", film / "film.ptw", "--recipe", film / "film.toml", "--out", film / "result", "--quiet"])
        numbers.write_text(run([program, "show", film / "result", "--json"]), encoding="utf-8")
    return json.loads(numbers.read_text(encoding="utf-8"))


def text_of(study):
    lines = [
        f"{study.name}: {study.seeds} seeds, {len(study.numbers)} numbers with an error, {100 * study.share:.1f} % "
        f"within the band, largest {study.worst.ratio:.2f} ({study.worst.name}); {100 * study.beyond:.1f} % of "
        f"comparisons of two seeds differ by more than two errors, {100 * study.compared:.1f} % of those of `arenite "
        f"compare`, {100 * study.chance:.1f} % by chance"
    ]
    for n in sorted((n for n in study.numbers if not n.inside), key=lambda n: -n.ratio):
        lines.append(
            f"  {n.ratio:5.2f}  of {n.low:.2f} to {n.high:.2f}  {n.name:48} {n.mean:.4g}, scatter {n.scatter:.2g}, "
            f"told {n.told:.2g}"
        )
    for n in study.numbers:
        if n.covered is not None:
            lines.append(f"         {n.name:48} {n.covered} of {n.seeds} intervals of 95 % hold the mean")
    return "\n".join(lines)


def table(head, rows):
    return "\n".join(f"| {' | '.join(cells)} |" for cells in [head, ["---"] * len(head), *rows])


def page_of(judged):
    """The tables as a page of the documentation."""
    whole = [
        [
            studies[s.name],
            str(s.seeds),
            str(len(s.numbers)),
            f"{100 * s.share:.1f} %",
            str(sum(n.ratio > n.high for n in s.numbers)),
            f"{s.worst.ratio:.2f} `{s.worst.name}`",
            f"{100 * s.beyond:.1f} %",
            f"{100 * s.compared:.1f} %",
            f"{100 * s.chance:.1f} %",
        ]
        for s in judged
    ]
    each = []
    for name in main_numbers:
        cells = [
            next((f"{n.ratio:.2f}" for n in s.numbers if n.name.removeprefix("texture.") == name), "") for s in judged
        ]
        if any(cells):
            each.append([f"`{name}`", *cells])
    covered = [
        f"`{n.name}`, {studies[s.name]}: {n.covered} of {n.seeds}"
        for s in judged
        for n in s.numbers
        if n.covered is not None
    ]
    head = [
        "sample",
        "seeds",
        "numbers with an error",
        "within the band",
        "told too small",
        "largest ratio",
        "beyond two errors",
        "by `compare`",
        "by chance",
    ]
    text = (here / "page.md").read_text(encoding="utf-8")
    text = text.replace("@STUDIES@", table(head, whole))
    text = text.replace("@NUMBERS@", table(["number", *(studies[s.name] for s in judged)], each))
    return text.replace("@INTERVALS@", "; ".join(covered) + ".")


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("studies", nargs="*", help=f"only these of {', '.join(studies)}")
    parser.add_argument("--program", default="arenite", help="the program to run (default: arenite)")
    parser.add_argument(
        "--out", type=pathlib.Path, help="folder of the runs, which are used again (default: none kept)"
    )
    parser.add_argument("--small", action="store_true", help="two small studies")
    parser.add_argument("--jobs", type=int, default=1, help="concurrent runs")
    parser.add_argument("--markdown", type=pathlib.Path, help="also write the tables as a page")
    asked = parser.parse_args()
    judged = []
    with tempfile.TemporaryDirectory() as temporary:
        out = (asked.out or pathlib.Path(temporary)).resolve()
        for name in asked.studies or (small if asked.small else studies):
            changes = small[name] if asked.small else []
            numbers, folders = results_of(asked.program, name, out / name, changes, asked.jobs)
            judged.append(Study(name, numbers, share_compared(asked.program, folders)))
            print(text_of(judged[-1]), flush=True)
    if asked.markdown:
        asked.markdown.write_text(page_of(judged), encoding="utf-8")
    print("told errors hold" if hold(judged) else "told errors DO NOT HOLD")
    return 0 if hold(judged) else 3


if __name__ == "__main__":
    sys.exit(main())

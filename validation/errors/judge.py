#!/usr/bin/env python3
"""Whether told errors hold: samples that differ in their seed alone scatter by as much as each of them says.

    python3 validation/errors/judge.py                          all studies beside this file, with the table on the terminal
    python3 validation/errors/judge.py --markdown docs/errors.md
    python3 validation/errors/judge.py --small                  two small studies, as the tests run them

Every number that has an error in a result is judged: the standard deviation over the seeds divided by the root mean square of the told errors. An honest
error gives 1, within the band that chance leaves for so many seeds (99 %, chi square). Ends with status 3 where fewer than 95 % of the numbers of a study
lie within its band, one of them is above 2, or more than 10 % of the comparisons of two seeds differ by more than two errors. Needs Python's standard library and `arenite` alone.
"""

import argparse
import json
import math
import pathlib
import re
import statistics
import subprocess
import sys
import tempfile

here = pathlib.Path(__file__).resolve().parent
fewest_grains = 50  # of which errors by blocks can be told: a texture of fewer, as of a small film, is not judged
required_share, largest_ratio, most_beyond = 0.95, 2, 0.1
studies = {
    "isotropic": "static packing", "biaxial": "biaxial test", "shear-slow": "slow shear", "shear-fast": "fast shear", "cemented": "cemented sample, pulled",
    "film": "film of a sample",
}
small = {"isotropic": ["packing.grains=150", 'container.width="105 mm"'], "shear-fast": ["populations.0.count=80", 'container.width="90 mm"', 'stages.1.duration="0.3 s"']}


def chi_band(freedom):
    """Between which ratios 99 % of standard deviations from so many degrees of freedom lie (Wilson and Hilferty, PNAS 17, 684, 1931)."""
    def quantile(z):
        return math.sqrt(max(0, 1 - 2 / (9 * freedom) + z * math.sqrt(2 / (9 * freedom))) ** 3)
    return quantile(-2.5758), quantile(2.5758)


def period(name):
    """Of an angle in degrees; None of other numbers."""
    folds = re.search(r"modes\.(\d+)\.phase_deg$", name)
    if folds:
        return 360 / int(folds[1])
    return 180 if re.search(r"(theta_\w*|direction|axis\w*)_deg$", name) else None


def flattened(node, name=""):
    """{name: (value, error, low_95, high_95)} of all numbers of a result that have an error; tensors by component, each once."""
    if not isinstance(node, dict):
        return {}
    if "value" not in node:
        found = {}
        if isinstance(node.get("considered"), dict) and node["considered"].get("grains", fewest_grains) < fewest_grains:
            return {}
        for own, inner in node.items():
            if own not in ("provenance", "stages", "contact_orientations"):
                found.update(flattened(inner, f"{name}.{own}" if name else own))
        return found
    value, error = node["value"], node.get("error")
    if isinstance(value, list):
        parts = {f"{name}.{r}{c}": (v, error[r][c]) for r, row in enumerate(value) if isinstance(row, list) for c, v in enumerate(row) if c >= r} if error else {}
        return {key: (v, e, None, None) for key, (v, e) in parts.items() if e is not None}
    return {name: (value, error, node.get("low_95"), node.get("high_95"))} if isinstance(error, (int, float)) and value is not None else {}


def deviations(values, turn):
    """About their mean, that of directions for an angle; and the mean."""
    if not turn:
        mean = statistics.fmean(values)
        return [v - mean for v in values], mean
    angle = [2 * math.pi * v / turn for v in values]
    mean = math.atan2(sum(map(math.sin, angle)), sum(map(math.cos, angle))) * turn / (2 * math.pi)
    return [math.remainder(v - mean, turn) for v in values], mean


class Judged:
    """One number over the seeds: `ratio` of the scatter to the told error, `mean`, `told`, `covered` seeds whose 95 % interval holds the mean (None without
    intervals), `pairs` of neighbouring seeds that differ by more than two errors, of so many."""

    def __init__(self, name, seeds):
        values, told = [s[0] for s in seeds], [s[1] for s in seeds]
        turn = period(name)
        off, self.mean = deviations(values, turn)
        self.name, self.seeds = name, len(seeds)
        self.scatter = math.sqrt(sum(d * d for d in off) / (len(off) - 1))
        self.told = math.sqrt(statistics.fmean(e * e for e in told))
        self.ratio = self.scatter / self.told if self.told > 0 else (math.inf if self.scatter > 0 else 1)
        intervals = [(s[2], s[3]) for s in seeds if s[2] is not None]
        self.covered = sum(low <= self.mean <= high for low, high in intervals) if intervals else None
        apart = [abs(math.remainder(a[0] - b[0], turn) if turn else a[0] - b[0]) for a, b in zip(seeds[::2], seeds[1::2])]
        limits = [2 * math.hypot(a[1], b[1]) for a, b in zip(seeds[::2], seeds[1::2])]
        self.beyond, self.pairs = sum(d > limit for d, limit in zip(apart, limits)), len(limits)


class Study:
    """What was judged of a study, from the numbers of its runs."""

    def __init__(self, name, results):
        self.name, self.seeds = name, len(results)
        found = [flattened(result) for result in results]
        known = [key for key in {key: 0 for one in found for key in one} if sum(key in one for one in found) >= max(3, 0.75 * len(found))]
        twins = {key for key in known if key.endswith("modes.2.phase_deg") or key.endswith("modes.2.amplitude")}  # theta_c and half of a_c
        judged = [Judged(key, [one[key] for one in found if key in one]) for key in known if key not in twins]
        self.numbers = [n for n in judged if n.told > 1e-12 * abs(n.mean)]  # what is left is exact
        self.low, self.high = chi_band(len(results) - 1)
        self.inside = [n for n in self.numbers if self.low <= n.ratio <= self.high]
        self.worst = max(self.numbers, key=lambda n: n.ratio)
        pairs = sum(n.pairs for n in self.numbers)
        self.beyond = sum(n.beyond for n in self.numbers) / pairs if pairs else math.nan

    @property
    def holds(self):
        return len(self.inside) >= required_share * len(self.numbers) and self.worst.ratio <= largest_ratio and not self.beyond > most_beyond


def run(arguments):
    done = subprocess.run([str(a) for a in arguments], capture_output=True, text=True)
    if done.returncode != 0:
        raise SystemExit(f"{' '.join(str(a) for a in arguments[:3])}: {done.stderr.strip() or done.stdout.strip()}")
    return done.stdout


def results_of(program, name, out, changes, jobs):
    """The numbers of all runs of a study, whose missing runs are made."""
    sets = [part for change in changes for part in ("--set", change)]
    run([program, "study", "run", here / f"{name}.toml", "--out", out, "--quiet", "--jobs", jobs, *sets])
    folders = sorted((out / "runs").iterdir())
    if (here / f"{name}-camera.toml").exists():
        return [filmed(program, folder, here / f"{name}-camera.toml", seed) for seed, folder in enumerate(folders, 1)]
    return [json.loads((folder / "numbers.json").read_text(encoding="utf-8")) for folder in folders]


def filmed(program, folder, camera, seed):
    """The numbers of the film of a run, made where they are missing."""
    film, numbers = folder / "film", folder / "film.json"
    if not numbers.exists():
        run([program, "camera", folder, "--recipe", camera, "--out", film, "--quiet", "--set", f"seed={seed}"])
        run([program, "film", film / "film.ptw", "--recipe", film / "film.toml", "--out", film / "result", "--quiet"])
        numbers.write_text(run([program, "show", film / "result", "--json"]), encoding="utf-8")
    return json.loads(numbers.read_text(encoding="utf-8"))


def text_of(study):
    lines = [f"{study.name}: {study.seeds} seeds, {len(study.numbers)} numbers with an error, {len(study.inside)} within {study.low:.2f} to {study.high:.2f}, "
             f"largest {study.worst.ratio:.2f} ({study.worst.name}); {100 * study.beyond:.1f} % of pairs of seeds differ by more than two errors: "
             f"{'holds' if study.holds else 'DOES NOT HOLD'}"]
    outside = sorted((n for n in study.numbers if n not in study.inside), key=lambda n: -n.ratio)
    lines += [f"  {n.ratio:5.2f}  {n.name:48} {n.mean:.4g}, scatter {n.scatter:.2g}, told {n.told:.2g}" for n in outside]
    lines += [f"         {n.name:48} {n.covered} of {n.seeds} intervals of 95 % hold the mean" for n in study.numbers if n.covered is not None]
    return "\n".join(lines)


def page_of(judged):
    """The table as a page of the documentation."""
    rows = ["| sample | seeds | numbers with an error | band of chance | within | largest ratio | pairs beyond two errors |", "|---|---|---|---|---|---|---|"]
    rows += [f"| {studies[s.name]} | {s.seeds} | {len(s.numbers)} | {s.low:.2f} to {s.high:.2f} | {100 * len(s.inside) / len(s.numbers):.1f} % | "
             f"{s.worst.ratio:.2f} `{s.worst.name}` | {100 * s.beyond:.1f} % |" for s in judged]
    main = ["solid_fraction", "coordination.all", "fabric.a_c", "fabric.a_n", "force.mean_N", "force.strong_share", "force.beta", "force.beta_line", "force.alpha", "force.k",
            "force.log_likelihood_ratio", "sigma_norm.P0", "sigma_norm.beta", "sigma_norm.beta_line", "stress.00", "stress.01", "stress.11", "critical_state.mu",
            "critical_state.q_over_p", "critical_state.solid_fraction", "pores.mean", "stress.sigma_yy.sets.large.variance", "forces.mean_N"]
    each = [f"| number | {' | '.join(studies[s.name] for s in judged)} |", "|---|" + "---|" * len(judged)]
    for name in main:
        cells = [next((f"{n.ratio:.2f}" for n in s.numbers if n.name == name), "") for s in judged]
        if any(cells):
            each.append(f"| `{name}` | {' | '.join(cells)} |")
    intervals = [f"`{n.name}`, {studies[s.name]}: {n.covered} of {n.seeds}" for s in judged for n in s.numbers if n.covered is not None]
    text = (here / "page.md").read_text(encoding="utf-8")
    for mark, part in (("@STUDIES@", rows), ("@NUMBERS@", each), ("@INTERVALS@", ["; ".join(intervals) + "."])):
        text = text.replace(mark, "\n".join(part))
    return text


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("studies", nargs="*", choices=[*studies, []], help="only these")
    parser.add_argument("--program", default="arenite", help="the program to run (default: arenite)")
    parser.add_argument("--out", type=pathlib.Path, help="folder of the runs, which are kept and used again (default: a temporary one)")
    parser.add_argument("--small", action="store_true", help="two small studies")
    parser.add_argument("--jobs", type=int, default=1, help="concurrent runs")
    parser.add_argument("--markdown", type=pathlib.Path, help="also write the table as a page")
    asked = parser.parse_args()
    judged = []
    with tempfile.TemporaryDirectory() as temporary:
        out = (asked.out or pathlib.Path(temporary)).resolve()
        for name in asked.studies or (small if asked.small else studies):
            judged.append(Study(name, results_of(asked.program, name, out / name, small[name] if asked.small else [], asked.jobs)))
            print(text_of(judged[-1]), flush=True)
    if asked.markdown:
        asked.markdown.write_text(page_of(judged), encoding="utf-8")
    return 0 if all(study.holds for study in judged) else 3


if __name__ == "__main__":
    sys.exit(main())

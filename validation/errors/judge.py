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
import pathlib
import subprocess
import sys
import tempfile

from told_errors import Study, hold

here = pathlib.Path(__file__).resolve().parent
studies = {
    "isotropic": "static packing",
    "biaxial": "biaxial test",
    "shear-slow": "slow shear",
    "shear-fast": "fast shear",
    "cemented": "cemented sample, pulled",
    "film": "film of a sample",
    "spheres": "spheres at rest",
    "spheres-shear": "sheared spheres",
}
small = {
    "isotropic": ["packing.grains=250", 'container.width="130 mm"'],
    "shear-fast": ["populations.0.count=120", 'container.width="110 mm"', 'stages.1.duration="0.3 s"'],
}
main_numbers = """solid_fraction coordination.all fabric.a_c fabric.a_n force.mean_N force.strong_share force.beta
    force.beta_line force.alpha force.k force.log_likelihood_ratio sigma_norm.P0 sigma_norm.beta sigma_norm.beta_line
    stress.00 stress.01 stress.11 critical_state.mu critical_state.q_over_p critical_state.solid_fraction
    stress.sigma_yy.sets.large.mean_over_sample_mean stress.sigma_yy.sets.large.variance forces.mean_N""".split()


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

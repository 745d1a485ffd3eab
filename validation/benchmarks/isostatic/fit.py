#!/usr/bin/env python3
"""Contacts and solid fraction of frictionless spheres as the pressure goes to 0: lines through the runs of a study.

usage: validation/benchmarks/isostatic/fit.py [--study out/study] [--picture FILE]
For each seed z = z0 + a (P d/k)^(1/2), without rattlers, and phi = phi0 + b P d/k, by least squares over its pressures;
means and standard errors are those over seeds. The study is run before, by `arenite study run`.
"""
import argparse
import collections
import math
import pathlib

import numpy as np

import arenite

# C. S. O'Hern, L. E. Silbert, A. J. Liu and S. R. Nagel, Phys. Rev. E 68, 011306 (2003), of equal spheres.
ISOSTATIC, CLOSEST = 6, 0.639


def runs_of(study):
    """By seed and pressure: z without rattlers, solid fraction, share of rattlers."""
    found = collections.defaultdict(dict)
    for file in sorted(study.glob("runs/*/numbers.json")):
        result = arenite.open(file.parent)
        stage, packing = result.spheres[-1], result.spheres[-1].states[-1]
        diameter, stiffness = 2 * packing.radius.mean(), packing.materials[0].stiffness
        pressure = stage.numbers["stress_details"]["pressure_Pa"] * diameter / stiffness
        z = stage.numbers["coordination"]
        numbers = z["without_rattlers"], stage.numbers["solid_fraction"], z["rattlers"]
        found[arenite.Recipe(result.path + "/recipe.toml").seed][pressure] = [number["value"] for number in numbers]
    return found


def said(values, places):
    values = np.asarray(values)
    return f"{values.mean():.{places}f} ± {values.std(ddof=1) / math.sqrt(len(values)):.{places}f}"


def lines_of(runs, power, column):
    """Value at 0 and slope of each seed."""
    lines = [
        np.polyfit([p**power for p in seed], [row[column] for row in seed.values()], 1) for seed in runs.values()
    ]
    return np.array(lines)[:, ::-1]


def draw(file, runs, z, phi):
    import matplotlib

    matplotlib.use("Agg")
    import matplotlib.pyplot as plt

    fig, panels = plt.subplots(1, 2, figsize=(7, 3.2), constrained_layout=True)
    for axes, power, column, lines in ((panels[0], 0.5, 0, z), (panels[1], 1, 1, phi)):
        most = max(p for seed in runs.values() for p in seed) ** power
        for start, slope in lines:
            axes.plot([0, most], [start, start + slope * most], color="#8db4e2", lw=1)
        for seed in runs.values():
            at = sorted(seed)
            axes.plot([p**power for p in at], [seed[p][column] for p in at], "o", ms=4, mfc="none", color="#c8551b")
    panels[0].axhline(ISOSTATIC, color="#7a7a7a", ls=":")
    panels[1].axhline(CLOSEST, color="#7a7a7a", ls=":")
    panels[0].set(xlabel="$(P d/k)^{1/2}$", ylabel="z without rattlers")
    panels[1].set(xlabel="$P d/k$", ylabel="solid fraction")
    fig.savefig(file, dpi=150, metadata={"Software": None})


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", 1)[0])
    parser.add_argument("--study", type=pathlib.Path, default=pathlib.Path("out/study"))
    parser.add_argument("--picture")
    arguments = parser.parse_args()
    runs = runs_of(arguments.study)
    for at in zip(*(sorted(seed) for seed in runs.values())):
        z, phi, loose = zip(*(seed[p] for seed, p in zip(runs.values(), at)))
        print(f"P d/k {np.mean(at):8.2e}: z {said(z, 3)}, phi {said(phi, 4)}, rattlers {said(loose, 4)}")
    z, phi = lines_of(runs, 0.5, 0), lines_of(runs, 1, 1)
    print(f"z0 {said(z[:, 0], 3)}, a {said(z[:, 1], 2)}, phi0 {said(phi[:, 0], 4)}, b {said(phi[:, 1], 2)}")
    print(f"z - z0 = {said(z[:, 1] / np.sqrt(phi[:, 1]), 2)} times (phi - phi0)^(1/2)")
    if arguments.picture:
        draw(arguments.picture, runs, z, phi)


if __name__ == "__main__":
    main()

#!/usr/bin/env python3
"""Whether forces that a film shows are those that were filmed: made and told errors against the simulated states.

    python3 validation/errors/judge.py film --out out/errors
    python3 validation/errors/film_truth.py out/errors/film

Prints a row of a Markdown table for every film of the study and one for all. Needs NumPy and Arenite's module.
"""

import math
import pathlib
import sys

import numpy as np

import arenite


def changes_of(folder):
    """{pair of grains: change of the normal force from the low to the high state, N} and the high state."""
    run = arenite.open(folder)
    low, high = (next(s.packing for s in run.stages if s.name == name) for name in ("low", "high"))
    forces = [
        {frozenset(map(int, pair)): fn for *pair, fn in zip(c.i, c.j, c.fn) if pair[1] >= 0}
        for c in (low.contacts, high.contacts)
    ]
    return {pair: forces[1].get(pair, 0) - forces[0].get(pair, 0) for pair in forces[0].keys() | forces[1].keys()}, high


def filmed_as(film, state):
    """Which grain of the state every grain of the film is: the nearest, once both lie over each other."""
    seen, there = np.c_[film.packing.x, film.packing.y], np.c_[state.x, state.y]
    shift = np.zeros(2)
    for _ in range(5):
        near = np.argmin(((seen[:, None] - there[None] - shift) ** 2).sum(2), axis=1)
        shift = np.median(seen - there[near], axis=0)
    return near


def compare(folder):
    """Errors made and told, N, and true changes, N, of the contacts between grains that the film shows."""
    film = arenite.open(folder / "film" / "result").films[0]
    change, state = changes_of(folder)
    grain, c = filmed_as(film, state), film.packing.contacts
    rows = []
    for i, j, fn, told in zip(c.i, c.j, c.fn, film.fn_error):
        if j >= 0:
            true = change.get(frozenset((int(grain[i]), int(grain[j]))), 0)
            rows.append((fn - true, told, true))
    return np.array(rows)


def row(name, rows):
    made, told, true = rows.T
    size = math.sqrt((true**2).sum()) / 100
    within = [np.mean(np.abs(made) < times * told) for times in (1, 2)]
    errors = [f"{math.sqrt((e**2).sum()) / size:.2f}" for e in (made, told)]
    print(f"| {name} | {len(rows)} | {errors[0]} / {errors[1]} | {within[0]:.2f} | {within[1]:.2f} |")


def main():
    folders = sorted(path.parent for path in pathlib.Path(sys.argv[1]).glob("runs/*/film"))
    print("| film | contacts | normal forces, made / told, % | within one | within two |\n|---|---|---|---|---|")
    films = [compare(folder) for folder in folders]
    for number, rows in enumerate(films, 1):
        row(number, rows)
    row("all", np.concatenate(films))


if __name__ == "__main__":
    main()

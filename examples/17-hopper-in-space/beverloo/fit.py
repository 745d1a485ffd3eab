#!/usr/bin/env python3
"""Beverloo's law through the runs of study.toml: its exponent, and with 5/2 its constants C and k.

usage: examples/17-hopper-in-space/beverloo/fit.py [out/study]
The bulk density is that of all spheres before the gate opens, walls among it: their mass over twice their mean height
above the floor. `arenite figures out/study` draws the law.
"""
import math
import pathlib
import sys

import numpy as np

import arenite
from arenite import flows

EXPONENT, GRAVITY = 2.5, 9.81
GLASS_BEADS = 1.4  # k


def bulk_density(result):
    """kg/m^3, and the mean diameter, m."""
    filled = result.spheres[-2].states[-1]
    floor = next(boundary for boundary in filled.domain["boundaries"] if boundary["name"] == "floor")
    height = 2 * (filled.position[:, 1].mean() - np.mean(np.asarray(floor["points"])[:, 1]))
    mass = filled.materials[0].density * 4 / 3 * math.pi * (filled.radius**3).sum()
    return mass / (filled.domain["size"][0] * filled.domain["size"][2] * height), 2 * filled.radius.mean()


def main():
    study = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else "out/study")
    results = [arenite.open(file.parent) for file in sorted(study.glob("runs/*/numbers.json"))]
    found = flows.discharges(results)
    for opening, rate, error in zip(*flows.values_of(found, "opening", "rate", "rate_error")):
        print(f"D {1e3 * opening:5.1f} mm: {rate:.4f} ± {error:.4f} kg/s")
    free, fixed = flows.fit_beverloo(found), flows.fit_beverloo(found, exponent=EXPONENT)
    density, diameter = np.mean([bulk_density(result) for result in results], axis=0)
    print(
        "exponent {:.2f} ± {:.2f} with k d = {:.2f} ± {:.2f} mm".format(
            *free["exponent"], *(1e3 * value for value in free["lost_width"])
        )
    )
    given = np.asarray(found["opening"].values) - GLASS_BEADS * diameter
    power = flows.fit_power(given, *flows.values_of(found, "rate", "rate_error"))
    print("with k = {}: exponent {:.2f} ± {:.2f}".format(GLASS_BEADS, *power["exponent"]))
    scale = density * math.sqrt(GRAVITY)
    print(f"exponent 5/2, bulk density {density:.0f} kg/m^3:")
    print("  C = {:.3f} ± {:.3f}".format(*(value / scale for value in fixed["factor"])))
    print("  k = {:.2f} ± {:.2f}".format(*(value / diameter for value in fixed["lost_width"])))


if __name__ == "__main__":
    main()

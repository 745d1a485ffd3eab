"""Modulus, Poisson's ratio and strength of the rock: python measure.py out/recipe out/tension"""

import sys

import arenite
import numpy as np


def width(packing):
    return np.max(packing.x + packing.radius) - np.min(packing.x - packing.radius)


def measure(path):
    stage = arenite.open(path).stages[-1]
    history, first = stage.history, stage.snapshots[0].packing
    height = history["top_position"][0]
    strain = 1 - history["top_position"] / height
    stress = history["top_force"] / (width(first) * first.domain["thickness"])
    sign = np.sign(strain[-1])  # of compression
    strain, stress = sign * strain, sign * stress
    peak = np.argmax(stress)
    tenth, half = (np.argmax(stress > share * stress[peak]) for share in (0.1, 0.5))
    modulus = (stress[half] - stress[tenth]) / (strain[half] - strain[tenth])
    # The grains of the middle half, from the first state to the last one before half of the strength.
    then = [f.packing for f in stage.snapshots if f.time < history["time"][half]][-1]
    middle = np.abs(first.y - 0.5 * height) < 0.25 * height
    along, across = (np.polyfit(a[middle], (b - a)[middle], 1)[0] for a, b in ((first.y, then.y), (first.x, then.x)))
    poisson = -across / along
    broken = [int(history[f"broken_in_{kind}"][peak]) for kind in ("tension", "bending", "shear")]
    print(
        f"{stage.name}: strength {stress[peak] / 1e6:.0f} MPa at {100 * strain[peak]:.2f} %, E {modulus / 1e9:.1f} "
        f"GPa, nu {poisson:.2f}"
    )
    print(
        f"  as of plane strain: E {modulus * (1 - (poisson / (1 + poisson)) ** 2) / 1e9:.1f} GPa, nu "
        f"{poisson / (1 + poisson):.2f}"
    )
    print(
        f"  broken at the peak in tension, bending, shear: {broken}; first bond at "
        f"{stress[np.argmax(history['bonds'] < history['bonds'][0])] / 1e6:.0f} MPa"
    )


for path in sys.argv[1:]:
    measure(path)

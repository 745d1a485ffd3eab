#!/usr/bin/env python3
"""A steel ball thrown into a bed of spheres, by Arenite and, into the same bed, by YADE.

usage: bench/peers/penetration.py [--program build/arenite] [--out out/penetration] [--beds 1] [--small] [--yade both]
                                  [--picture FILE]
The recipe is validation/benchmarks/penetration.toml; --small is a smaller ball over
2500 spheres, --beds so many of
different seeds. What a folder has already is not computed again. YADE runs twice, with the restitution of Arenite's
boundaries, which is that of the spheres, and with that of steel which the comparison asks for. Needs Debian's yade.
"""
import argparse
import csv
import json
import math
import pathlib
import subprocess

import numpy as np

import arenite

HERE = pathlib.Path(__file__).resolve().parent
RECIPE = HERE.parents[1] / "validation" / "benchmarks" / "penetration.toml"
SMALL = {
    "variables.D": '"10 mm"',
    "variables.fall": '"118 mm"',
    "container.width": '"30 mm"',
    "container.depth": '"30 mm"',
    "packing.area.top": '"22 mm"',
    "populations.0.count": "2500",
    "boundaries.0.ball.x": '"15 mm"',
    "boundaries.0.ball.z": '"15 mm"',
    "stages.0.duration": '"30 ms"',
    "stages.1.duration": '"10 ms"',
}
FROM, SPEED, GRAVITY = 0.15, 5.0, 9.81  # where the ball begins, above the floor, and how
RUNS = {"YADE": 0.5, "YADE, restitution of steel": 0.4}
GRAIN_RESTITUTION = 0.5


def thrown(arguments, folder, seed):
    """The stages of the bed and of the ball."""
    changes = {"seed": str(seed), **(SMALL if arguments.small else {})}
    sets = [part for key, value in changes.items() for part in ("--set", f"{key}={value}")]
    subprocess.run([arguments.program, "run", RECIPE, "--quiet", "--out", folder, *sets], check=True)
    return arenite.open(folder).spheres[1:]


def case_of(bed, height, radius, duration):
    """All that YADE is told."""
    domain, glass = bed.domain, bed.materials[0]
    sides = (("left", "right"), ("bottom", "top"), ("back", "front"))
    box = [[domain[low]["position"], domain[high]["position"]] for low, high in sides]
    place = [0.5 * sum(box[0]), height, 0.5 * sum(box[2])]
    return {
        "bed": np.column_stack((bed.position, bed.radius)).tolist(),
        "box": box,
        "glass": {"E": glass.youngs_modulus, "density": glass.density},
        "restitution": GRAIN_RESTITUTION,
        "ball": {"place": place, "radius": radius, "speed": math.sqrt(SPEED**2 + 2 * GRAVITY * (FROM - height))},
        "time_step": 1e-6,
        "every": 1e-4,
        "duration": duration,
    }


def by_yade(folder, name, case):
    """Times and heights of the ball in YADE."""
    table = folder / (name.replace(", ", "-").replace(" ", "-") + ".csv")
    if not table.exists():
        told, made = table.with_suffix(".json"), table.with_suffix(".part")
        told.write_text(json.dumps(case), encoding="utf-8")
        command = ["yade", "-n", "-x", "-j1", HERE / "yade_penetration.py", told, made]
        subprocess.run(command, check=True, stdout=subprocess.DEVNULL)
        made.rename(table)
    with table.open(encoding="utf-8", newline="") as rows:
        return np.array([[float(row["time"]), float(row["height"])] for row in csv.DictReader(rows)]).T


def numbers_of(time, height):
    """Vertical displacement every two milliseconds, and how far down the ball comes where it turns, in mm."""
    down = 1e3 * (FROM - height)
    numbers = {f"after {ms:2} ms": np.interp(1e-3 * ms, time, down, right=np.nan) for ms in range(2, 16, 2)}
    lowest = int(np.argmax(down))
    return numbers | {"at most": down[lowest] if lowest + 1 < len(down) else np.nan}


def curves_of(arguments, seed):
    radius = 0.005 if arguments.small else 0.01
    folder = arguments.out / (("small-" if arguments.small else "") + f"bed-{seed}")
    settled, flight = thrown(arguments, folder, seed)
    bed, history = settled.states[-1], flight.history
    start = settled.history["time"][-1]
    height = history["ball_y"]
    top = settled.history["ball_y"][-1]  # where the ball waits
    curves = {"Arenite": np.array([history["time"] - start, height])}
    for name, restitution in RUNS.items():
        if arguments.yade == "both" or name.endswith(arguments.yade):
            case = case_of(bed, top, radius, history["time"][-1] - start)
            curves[name] = by_yade(folder, name, {**case, "restitution_of_steel": restitution})
    surface = np.sort(bed.position[:, 1] + bed.radius)[-len(bed) // 50 :].mean()
    box = bed.domain["size"]
    solid = 2 * bed.position[:, 1].mean() * box[0] * box[2]
    print(
        f"bed {seed}: {len(bed)} spheres, surface at {1e3 * surface:.1f} mm, mean height "
        f"{1e3 * bed.position[:, 1].mean():.2f} mm, solid fraction "
        f"{(4 / 3 * math.pi * bed.radius**3).sum() / solid:.3f} of twice that"
    )
    return curves


def draw(file, beds):
    import matplotlib

    matplotlib.use("Agg")
    import matplotlib.pyplot as plt

    fig, axes = plt.subplots(figsize=(6, 3.4), constrained_layout=True)
    styles = dict(zip(["Arenite", *RUNS], [("#8db4e2", "-", 4), ("#7a7a7a", ":", 1.5), ("#c8551b", "--", 1.5)]))
    for n, curves in enumerate(beds):
        for name, (time, height) in curves.items():
            colour, line, width = styles[name]
            label = name if n == 0 else None
            axes.plot(1e3 * time, -1e3 * (FROM - height), color=colour, ls=line, lw=width, label=label)
    axes.set_xlabel("time, ms")
    axes.set_ylabel("vertical displacement, mm")
    axes.legend(frameon=False)
    fig.savefig(file, dpi=150, metadata={"Software": None})


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", 1)[0])
    parser.add_argument("--program", default="build/arenite")
    parser.add_argument("--out", type=pathlib.Path, default=pathlib.Path("out/penetration"))
    parser.add_argument("--beds", type=int, default=1)
    parser.add_argument("--small", action="store_true")
    parser.add_argument("--yade", choices=["both", "steel", "none"], default="both")
    parser.add_argument("--picture")
    arguments = parser.parse_args()
    beds = [curves_of(arguments, seed) for seed in range(1, arguments.beds + 1)]
    for name in beds[0]:
        rows = [numbers_of(*curves[name]) for curves in beds]
        print(name, ", ".join(f"{key} {np.mean([row[key] for row in rows]):.3f}" for key in rows[0]))
        if name != "Arenite":
            ours = [numbers_of(*curves["Arenite"]) for curves in beds]
            apart = {key: [row[key] - own[key] for row, own in zip(rows, ours)] for key in rows[0]}
            print("  less ours", ", ".join(f"{key} {np.round(values, 3)}" for key, values in apart.items()))
    if arguments.picture:
        draw(arguments.picture, beds)


if __name__ == "__main__":
    main()

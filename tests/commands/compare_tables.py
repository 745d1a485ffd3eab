"""Reads exported text formats with a few lines of its own and compares them with the stage file read by h5py."""
import csv
import os
import re
import sys

import h5py
import numpy as np

stage_file, folder, kind = sys.argv[1:4]


def dump_frames(path):
    """Frames of a LAMMPS dump: {item: its lines}, with the words after ITEM: NAME as a list under NAME + ' header'."""
    frames, current = [], None
    for line in open(path):
        line = line.rstrip("\n")
        if line.startswith("ITEM: "):
            name = re.match(r"ITEM: ((?:NUMBER OF \w+)|(?:BOX BOUNDS)|\w+)", line).group(1)
            if name == "TIME":
                frames.append({})
            if frames:
                current = frames[-1].setdefault(name, [])
                frames[-1][name + " header"] = line[len("ITEM: ") + len(name) :].split()
        elif frames:
            current.append(line.split())
    return frames


def columns(frame, item):
    rows = np.array(frame[item], dtype=float)
    return {name: rows[:, k] for k, name in enumerate(frame[item + " header"])}


def check_lammps(file):
    grains, contacts = (dump_frames(os.path.join(folder, name)) for name in ("grains.dump", "contacts.dump"))
    assert len(grains) == len(contacts) == len(file["frames"])
    for g, c, frame in zip(grains, contacts, file["frames"].values()):
        assert float(g["TIME"][0][0]) == frame.attrs["time [s]"] and int(g["TIMESTEP"][0][0]) == frame.attrs["step"]
        assert g["BOX BOUNDS header"] == ["ff", "ff", "pp"]
        side = frame["domain"]
        assert [float(v) for v in g["BOX BOUNDS"][0]] == [
            side["left"].attrs["position [m]"],
            side["right"].attrs["position [m]"],
        ]
        atoms = columns(g, "ATOMS")
        np.testing.assert_array_equal(atoms["id"], file["grains/id"][:] + 1)
        np.testing.assert_array_equal(atoms["type"], file["grains/material"][:] + 1)
        for name in ("x", "y", "vx", "vy"):
            np.testing.assert_array_equal(atoms[name], frame["grains"][name])
        np.testing.assert_array_equal(atoms["radius"], file["grains/radius"])
        pairs = frame["contacts/j"][:] >= 0
        local = columns(c, "ENTRIES")
        assert int(c["NUMBER OF ENTRIES"][0][0]) == pairs.sum()
        np.testing.assert_array_equal(local["fn"], frame["contacts/fn"][:][pairs])
        np.testing.assert_array_equal(local["patom1"], file["grains/id"][:][frame["contacts/i"][:][pairs]] + 1)
        nx, ny = local["nx"], local["ny"]  # towards the first grain, on which both forces act
        np.testing.assert_array_equal(local["fx"], local["fn"] * nx)
        np.testing.assert_array_equal(local["fy"], local["fn"] * ny)
        np.testing.assert_array_equal(local["p1"], -local["ft"] * ny)
        np.testing.assert_array_equal(local["p2"], local["ft"] * nx)


def check_extxyz(file):
    lines = open(os.path.join(folder, "grains.extxyz")).read().splitlines()
    n = len(file["grains/id"])
    assert len(lines) == len(file["frames"]) * (n + 2)
    for k, frame in enumerate(file["frames"].values()):
        block = lines[k * (n + 2) : (k + 1) * (n + 2)]
        assert int(block[0]) == n
        keys = dict((m.group(1), m.group(2).strip('"')) for m in re.finditer(r'(\w+)=("[^"]*"|\S+)', block[1]))
        assert float(keys["Time"]) == frame.attrs["time [s]"]
        lattice = [float(v) for v in keys["Lattice"].split()]
        wall = frame["domain"]
        assert lattice[0] == wall["right"].attrs["position [m]"] - wall["left"].attrs["position [m]"]
        properties = keys["Properties"].split(":")
        widths = [int(v) for v in properties[2::3]]
        rows = [line.split() for line in block[2:]]
        assert all(len(row) == sum(widths) for row in rows)
        assert {row[0] for row in rows} == {"X"}
        assert keys["Materials"] == "1:POM 2:HDPE"
        material = sum(widths[: properties[::3].index("material")])
        np.testing.assert_array_equal([int(row[material]) for row in rows], file["grains/material"][:] + 1)
        np.testing.assert_array_equal([float(row[1]) for row in rows], frame["grains/x"])
        np.testing.assert_array_equal([float(row[4]) for row in rows], file["grains/radius"])


def check_csv(file):
    states = list(csv.DictReader(open(os.path.join(folder, "states.csv"))))
    frames = list(file["frames"].values())
    assert [int(row["state"]) for row in states] == list(range(len(frames)))
    for row, frame in zip(states, frames):
        assert float(row["time [s]"]) == frame.attrs["time [s]"] and int(row["step"]) == frame.attrs["step"]
        assert float(row["x_high [m]"]) > float(row["x_low [m]"]) and float(row["thickness [m]"]) > 0
    for k, frame in enumerate(file["frames"].values()):
        grains = list(csv.DictReader(open(os.path.join(folder, f"grains_{k:04d}.csv"))))
        np.testing.assert_array_equal([float(row["x [m]"]) for row in grains], frame["grains/x"])
        np.testing.assert_array_equal([float(row["radius [m]"]) for row in grains], file["grains/radius"])
        assert grains[1]["material"] == "HDPE"
        contacts = list(csv.DictReader(open(os.path.join(folder, f"contacts_{k:04d}.csv"))))
        assert len(contacts) == len(frame["contacts/i"])
        np.testing.assert_array_equal([float(row["fn [N]"]) for row in contacts], frame["contacts/fn"])
        place = {row["id"]: row for row in grains}
        for row in contacts:  # n from i to j, as `measure` takes it
            if row["j"] in place:
                assert (float(place[row["j"]]["x [m]"]) - float(place[row["i"]]["x [m]"])) * float(row["nx"]) > 0
            else:
                assert row["j"] == "bottom" and float(row["ny"]) == -1


with h5py.File(stage_file) as stage:
    {"lammps": check_lammps, "extxyz": check_extxyz, "csv": check_csv}[kind](stage)
print("checked")

"""ASE reads the extended XYZ files of an export, and they follow the written rules of the format; arguments: files."""
import re
import sys

import numpy as np
from ase.io import read

number = re.compile(r"[+-]?(?:\d+\.?\d*|\.\d+)(?:[dDeE][+-]?\d+)?")
kinds = {"R": number, "I": re.compile(r"[+-]?\d+"), "S": re.compile(r"\S+"), "L": re.compile(r"[TF]")}


def states_by_the_rules(path):
    """Columns of every state by name, with its keys; all characters are ASCII, all cells of the kind that is
    announced."""
    lines = open(path, encoding="ascii").read().splitlines()
    while lines:
        count = int(lines[0])
        keys = {k: v.strip('"') for k, v in re.findall(r'(\w+)=("[^"\\]*"|[^\s=",{}\[\]\\]+)(?=\s|$)', lines[1])}
        assert " ".join(f"{k}" for k in keys) == " ".join(re.findall(r"(\w+)=", re.sub(r'"[^"]*"', '""', lines[1])))
        properties = keys["Properties"].split(":")
        names, of_kind, widths = properties[::3], properties[1::3], [int(w) for w in properties[2::3]]
        assert len(set(names)) == len(names)
        rows = [line.split() for line in lines[2 : 2 + count]]
        columns, at = {}, 0
        for name, kind, width in zip(names, of_kind, widths):
            columns[name] = [row[at : at + width] for row in rows]
            assert all(kinds[kind].fullmatch(cell) for row in columns[name] for cell in row), name
            at += width
        assert all(len(row) == at for row in rows)
        yield keys, columns
        lines = lines[2 + count :]


for path in sys.argv[1:]:
    states, images = list(states_by_the_rules(path)), read(path, index=":", format="extxyz")
    assert len(states) == len(images) > 0
    for (keys, columns), atoms in zip(states, images):
        assert set(atoms.get_chemical_symbols()) == {"X"}
        np.testing.assert_array_equal(atoms.positions, np.array(columns["pos"], float))
        for name in ("radius", "angle", "omega"):
            np.testing.assert_array_equal(atoms.arrays[name], np.array(columns[name], float)[:, 0])
        np.testing.assert_array_equal(atoms.arrays["material"], np.array(columns["material"], int)[:, 0])
        np.testing.assert_array_equal(atoms.cell.array.flatten(), np.array(keys["Lattice"].split(), float))
        assert list(atoms.pbc) == [p == "T" for p in keys["pbc"].split()]
        assert atoms.info["Time"] == float(keys["Time"]) and atoms.info["Step"] == int(keys["Step"])
    print(f"read {len(images)} states")

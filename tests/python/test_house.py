"""The order of the rooms: who may include whom, and where a unit test lives."""

import pathlib
import re

ROOT = pathlib.Path(__file__).resolve().parents[2]
SOURCES = ROOT / "src"

# From the ground up. A room includes its own files and those of floors below; the rooms of one floor know each other only from left to right.
FLOORS = [
    ["core"],
    ["geometry", "statistics"],
    ["elasticity", "model", "radiometry"],
    [("io",), ("packing", "dem", "texture"), ("cement", "raster", "peridynamics", "stress"), ("imaging", "camera", "thermography", "inference", "identify")],
    ["study"],
    ["ledger"],
    ["report"],
]


def allowed():
    below, may = set(), {}
    for floor in FLOORS:
        rooms = [room if isinstance(room, tuple) else (room,) for room in floor]
        for wing in rooms:
            for place, room in enumerate(wing):
                may[room] = below | set(wing[:place])
        below |= {room for wing in rooms for room in wing}
    return may


def included_by(file):
    for line in file.read_text().splitlines():
        found = re.match(r'#include "([a-z_0-9]+)/', line)
        if found:
            yield found.group(1)


def files():
    return sorted(p for p in SOURCES.rglob("*") if p.suffix in (".cpp", ".hpp", ".inc"))


def test_every_room_has_its_floor():
    assert {p.name for p in SOURCES.iterdir() if p.is_dir()} == set(allowed())


def test_arrows_of_inclusion_point_down():
    may = allowed()
    wrong = []
    for file in files():
        room = file.relative_to(SOURCES).parts[0]
        wrong += [f"{file.relative_to(ROOT)} includes {other}" for other in included_by(file) if other != room and other in may and other not in may[room]]
    assert not wrong, "\n".join(wrong)


def test_unit_tests_mirror_sources():
    """x_test.cpp is of src/.../x, and x_theme_test.cpp is of a theme of it."""
    stems = {}
    for file in files():
        stems.setdefault(file.relative_to(SOURCES).parts[0], set()).add(file.stem)
    tests = ROOT / "tests" / "unit"
    stray = []
    for test in tests.rglob("*_test.cpp"):
        words = test.stem.split("_")[:-1]
        own = {"_".join(words[:n]) for n in range(1, len(words) + 1)}
        if not own & stems.get(test.relative_to(tests).parts[0], set()):
            stray.append(str(test.relative_to(ROOT)))
    assert not stray, "\n".join(sorted(stray))

"""The order of the rooms: who may include whom, and where a unit test lives."""

import pathlib
import re
import subprocess

from sources import ROOT, SOURCES, code_of, files

# From the ground up. A room includes its own files and those of floors below; the rooms of one floor do not know each
# other.
FLOORS = [
    ["core"],
    ["geometry", "statistics"],
    ["model"],
    ["io", "grains", "solid", "thermal"],
    ["recipe"],
    ["workflow"],
    ["campaign"],
    ["report"],
]
# The chambers of a room, from left to right: one includes itself and those before it.
CHAMBERS = {
    "grains": ["packing", "dem", "lammps", "texture", "fields"],
    "solid": ["cement", "grid", "statics", "peridynamics", "elements", "stress"],
    "thermal": ["radiometry", "optics", "camera", "imaging", "thermography", "inference", "identify"],
}


def place_of(path):
    """("thermal", "camera") of thermal/camera/scene.hpp, ("core", None) of core/units.hpp."""
    parts = pathlib.PurePath(path).parts
    return parts[0], parts[1] if parts[0] in CHAMBERS else None


def is_allowed(includer, included):
    (room, chamber), (other, other_chamber) = place_of(includer), place_of(included)
    if room != other:
        floor = {name: level for level, names in enumerate(FLOORS) for name in names}
        return floor[other] < floor[room]
    return chamber is None or CHAMBERS[room].index(other_chamber) <= CHAMBERS[room].index(chamber)


def included_by(file):
    for line in file.read_text().splitlines():
        found = re.match(r'#include "([a-z_0-9]+/[^"]+)"', line)
        if found and found.group(1) != "core/version.hpp":
            yield found.group(1)


def test_every_room_has_its_floor():
    assert {p.name for p in SOURCES.iterdir() if p.is_dir()} == {room for floor in FLOORS for room in floor}
    for room, chambers in CHAMBERS.items():
        assert {p.name for p in (SOURCES / room).iterdir()} == set(chambers)


def test_arrows_of_inclusion_point_down():
    wrong = [
        f"{file.relative_to(ROOT)} includes {other}"
        for file in files()
        for other in included_by(file)
        if not is_allowed(file.relative_to(SOURCES), other)
    ]
    assert not wrong, "\n".join(wrong)


# Headers that take long to compile, and how many sources of the library and the program include each at most.
HEAVY = {
    "CLI/": 2,
    "Eigen/": 5,
    "boost/": 2,
    "httplib.h": 1,
    "nlohmann/": 1,
    "toml++/": 1,
    "fmt/format.h": 0,
    "fmt/ranges.h": 0,
}


def test_heavy_headers_are_in_few_sources():
    counts = dict.fromkeys(HEAVY, 0)
    for file in [*files(), *(p for room in ("app", "validation") for p in (ROOT / room).rglob("*.?pp"))]:
        included = re.findall(r"^#include <([^>]+)>", file.read_text(), flags=re.M)
        for header in HEAVY:
            counts[header] += any(name.startswith(header) for name in included)
    assert all(counts[header] <= most for header, most in HEAVY.items()), counts


def test_only_the_ground_asks_for_the_dimension():
    """What depends on the dimension stands in core and geometry, and in the loops of kernels; else it is a part of a
    sample, or an overload by type."""
    loops = re.compile(r"kernels/")
    asking = [
        str(file.relative_to(SOURCES))
        for file in files()
        if file.relative_to(SOURCES).parts[0] not in ("core", "geometry")
        and not loops.search(str(file.relative_to(SOURCES)))
        and re.search(r"if constexpr \(D\b", file.read_text())
    ]
    assert not asking, "\n".join(asking)


def test_folders_and_files_stay_small():
    """At most twelve rooms, forty files in a folder, three folders deep."""
    assert len(list(SOURCES.iterdir())) <= 12
    counts = {}
    for file in files():
        counts[file.parent] = counts.get(file.parent, 0) + 1
        assert len(file.relative_to(SOURCES).parts) <= 4, file
    crowded = [f"{folder.relative_to(ROOT)}: {count} files" for folder, count in sorted(counts.items()) if count > 40]
    assert not crowded, "\n".join(crowded)


# Who may touch a recipe's text in Python and on the page: to show it, or to show what differs between two.
SHOWN_RECIPES = ["_compare_page.py", "provenance.js"]


def test_python_and_the_page_read_no_recipes_and_no_quantities():
    """What a stage was asked for is numbers of its result, and curves are the library's (grains/fields)."""
    signs = (
        r"tomllib|from_text\(|\.recipe\b|get\(.recipe.|\b9\.8\d|"
        r"\"(mm|kN|kPa|mm/s|m/s\^2)\":|(Text|str)\([^)]*\)\.split\(\)\[0\]"
    )
    read = [
        f"{file.relative_to(ROOT)}: {found.group(0)}"
        for room, ending in (("python/arenite", "*.py"), ("web/src", "*.js"))
        for file in sorted((ROOT / room).rglob(ending))
        if file.name not in SHOWN_RECIPES
        for found in re.finditer(signs, file.read_text())
    ]
    assert not read, "\n".join(read)


def test_unit_tests_mirror_sources():
    """In the same folder x_test.cpp is of src/.../x, and x_theme_test.cpp is of a theme of it."""
    stems = {}
    for file in files() + sorted((ROOT / "validation").rglob("*.?pp")):
        home = SOURCES if SOURCES in file.parents else ROOT
        stems.setdefault(file.relative_to(home).parent, set()).add(file.stem)
    tests = ROOT / "tests" / "unit"
    stray = []
    for test in tests.rglob("*_test.cpp"):
        words = test.stem.split("_")[:-1]
        own = {"_".join(words[:n]) for n in range(1, len(words) + 1)}
        if not own & stems.get(test.relative_to(tests).parent, set()):
            stray.append(str(test.relative_to(ROOT)))
    assert not stray, "\n".join(sorted(stray))


def test_hops_of_the_architecture_are_true():
    """Each file of a chain names what it calls of the next, which has it, too."""
    chains, chain = [], []
    for line in (ROOT / "ARCHITECTURE.md").read_text().splitlines():
        hop = re.match(r"(\d+)\. `([a-z_0-9/.]+)`(?: -> `([A-Za-z_:]+)`)?", line)
        if hop and hop.group(1) == "0":
            chain = []
            chains.append(chain)
        if hop and chains:
            assert int(hop.group(1)) == len(chain), line
            chain.append((ROOT / hop.group(2), (hop.group(3) or "").split("::")[-1]))
    assert len(chains) == 3
    for chain in chains:
        assert len(chain) - 1 <= 7, [str(file.relative_to(ROOT)) for file, _ in chain]
        assert chain[0][0] == ROOT / "app" / "main.cpp"
        for (file, call), (following, _) in zip(chain, chain[1:]):
            assert re.search(rf"\b{call}\b", code_of(file)), f"{file} does not call {call}"
            homes = [f for f in (following, following.with_suffix(".cpp")) if f.exists()]
            assert any(defines(f, call) for f in homes), f"{following} does not define {call}"


def defines(file, name):
    """Whether a class of this name, or a function of this name with its body, stands in a file."""
    code = code_of(file)
    return re.search(rf"\b(class|struct) {name}\b[^;]*?{{", code) or re.search(
        rf"\b{name}\([^;{{}}]*(\{{[^;]*?\}}[^;{{}}]*)?\)[^;{{}}()]*(\([^()]*\))?[^;{{}}]*{{", code
    )


# What people write and read: by ending, by name, and scripts without an ending. Markdown has tables.
ENDINGS = ".cff .cmake .cpp .css .dict .hpp .html .in .inc .js .json .mjs .py .sh .supp .toml".split()
NAMES = ("CMakeLists.txt", "Containerfile", "Makefile", "packages.txt")
NOT_WRITTEN = ("tests/data/", "tests/fuzz/corpus/", "web/package-lock.json")


def is_written(file):
    if file.suffix in ENDINGS or file.name in NAMES:
        return True
    if file.suffix:
        return False
    return file.name.startswith(".") or file.read_bytes().startswith(b"#!")


def written_sources():
    listed = subprocess.run(["git", "ls-files"], cwd=ROOT, capture_output=True, text=True)
    rooms = ".ci app bench cluster cmake docs examples python scripts src tests validation web/src web/test".split()
    files = [ROOT / name for name in listed.stdout.splitlines()] or [
        *ROOT.iterdir(),
        *(ROOT / "web").iterdir(),
        *(p for room in rooms for p in (ROOT / room).rglob("*")),
    ]
    return [p for p in files if p.is_file() and not str(p.relative_to(ROOT)).startswith(NOT_WRITTEN) and is_written(p)]


def test_lines_end_before_column_121():
    sources = written_sources()
    assert len(sources) > 2000
    wide = [
        f"{file.relative_to(ROOT)}:{number}"
        for file in sources
        for number, line in enumerate(file.read_text(encoding="utf-8").splitlines(), 1)
        if len(line) > 120
    ]
    assert not wide, "\n".join(wide)


def test_files_have_at_most_300_lines():
    code = [p for p in written_sources() if p.suffix in (".cpp", ".hpp", ".py", ".js", ".mjs", ".css")]
    assert len(code) > 1500
    lengths = {p.relative_to(ROOT): len(p.read_text(encoding="utf-8").splitlines()) for p in code}
    assert max(lengths.values()) <= 300, [str(file) for file, lines in lengths.items() if lines > 300]


def test_sources_are_formatted():
    rooms = ["app", "bench", "cluster", "python", "src", "tests", "validation"]
    sources = [str(p) for room in rooms for p in sorted((ROOT / room).rglob("*.?pp"))]
    assert len(sources) > 500
    outcome = subprocess.run(
        ["clang-format-14", "--dry-run", "-Werror", *sources], cwd=ROOT, capture_output=True, text=True
    )
    assert outcome.returncode == 0, "run clang-format-14 -i on these:\n" + "\n".join(
        sorted({line.split(":")[0] for line in outcome.stderr.splitlines() if ": error:" in line})
    )

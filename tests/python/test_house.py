"""The order of the rooms: who may include whom, and where a unit test lives."""

import pathlib
import re
import subprocess

ROOT = pathlib.Path(__file__).resolve().parents[2]
SOURCES = ROOT / "src"

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
    "grains": ["packing", "dem", "texture", "fields"],
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


def files():
    return sorted(p for p in SOURCES.rglob("*") if p.suffix in (".cpp", ".hpp", ".inc"))


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
    loops = re.compile(r"kernels/|grains/dem/integrators/[a-z_0-9]+\.hpp$")
    asking = [
        str(file.relative_to(SOURCES))
        for file in files()
        if file.relative_to(SOURCES).parts[0] not in ("core", "geometry")
        and not loops.search(str(file.relative_to(SOURCES)))
        and re.search(r"if constexpr \(D\b", file.read_text())
    ]
    assert not asking, "\n".join(asking)


def test_folders_and_files_stay_small():
    """At most twelve rooms, forty files in a folder, three folders deep, 300 lines in a file."""
    assert len(list(SOURCES.iterdir())) <= 12
    counts = {}
    for file in files():
        counts[file.parent] = counts.get(file.parent, 0) + 1
        assert len(file.relative_to(SOURCES).parts) <= 4, file
    crowded = [f"{folder.relative_to(ROOT)}: {count} files" for folder, count in sorted(counts.items()) if count > 40]
    assert not crowded, "\n".join(crowded)
    lengths = {file.relative_to(ROOT): len(file.read_text().splitlines()) for file in files()}
    assert max(lengths.values()) <= 300, [str(file) for file, lines in lengths.items() if lines > 300]


# Members of visible lists, by the header in which their list stands or which it fronts: they have none of their own.
LISTS = {
    "grains/dem/kernels/make_kernel.hpp": "avx2 avx512 portable",
    "grains/dem/parameters.hpp": "keys",
    "grains/fields/stage_numbers.hpp": "cohesion_numbers energy_numbers flow_numbers load_numbers",
    "grains/texture/texture.hpp": "coordination distribution fabric gap_coordination local_order long_axes measure "
    "quality solid_fraction stress",
    "io/export/export.hpp": "csv extxyz fields lammps netcdf vtk",
    "io/film/formats.hpp": "hcc hdf5 npy ptw raw series sfmov text tiff",
    "io/image/image.hpp": "hdf5 jpeg png",
    "io/results/results.hpp": "field film numbers stage",
    "io/sample/formats.hpp": "csv lammps mercury yade",
    "recipe/recipe.hpp": "film_keys keys keys_boundaries keys_boundary_shapes keys_exchange keys_loading "
    "keys_map keys_membranes keys_stages",
    "report/figures/drawing.hpp": "distributions failure film_forces run_figures",
    "solid/elements/kernels/kernels.hpp": "avx2 avx512 portable",
    "solid/peridynamics/kernels/kernels.hpp": "avx2 avx512 portable",
    "thermal/thermography/kernels/kernels.hpp": "avx2 avx512 portable",
}


def members_of_lists():
    for header, stems in LISTS.items():
        for stem in stems.split():
            yield SOURCES / pathlib.Path(header).parent / f"{stem}.cpp"


def test_a_source_has_a_header_of_its_name():
    """Unless it is a member of a list."""
    members = set(members_of_lists())
    alone = {file for file in files() if file.suffix == ".cpp" and not file.with_suffix(".hpp").exists()}
    assert all((SOURCES / header).exists() for header in LISTS)
    assert not members - alone, f"no members, or with headers of their own: {sorted(members - alone)}"
    assert not alone - members, f"give these a header of their name: {sorted(alone - members)}"


def statements(file):
    """Code without what stands in braces but those of namespaces; "@" stands for a body."""
    code = re.sub(r'"(\\.|[^"\\])*"', '""', re.sub(r"^#.*", "", code_of(file), flags=re.M))
    code = re.sub(r"\bnamespace\b[^{;]*\{", "", code)
    while (fewer := re.sub(r"\{[^{}]*\}", "@", code)) != code:
        code = fewer
    return code


def functions(file, end):
    """Free functions that a file declares (end ";") or defines ("@"); no templates."""
    head = r"(?:^|[;@}])\s*(?!template|using|extern|friend|return)[\w:][\w:<>,&*\[\] ]*[ &*](\w+)"
    arguments = r"\((?:[^();]|\([^()]*\))*\)\s*(?:noexcept)?\s*"
    return set(re.findall(rf"{head}{arguments}(?={end})", statements(file)))


def test_headers_are_the_faces_of_their_sources():
    """What a header declares is defined in the source of its name, or in a member of its list."""
    listed = set(members_of_lists())
    sources = {file: functions(file, "@") for file in files() if file.suffix == ".cpp" and file not in listed}
    drawers, found = [], 0
    for header in files():
        own = header.with_suffix(".cpp")
        if header.suffix != ".hpp" or own not in sources:
            continue
        declared = functions(header, ";")
        found += len(declared & sources[own])
        for name in declared - sources[own]:
            others = [file.name for file, names in sources.items() if name in names and file.parent == header.parent]
            if others:
                drawers.append(f"{header.relative_to(SOURCES)} declares {name}, which is in {', '.join(others)}")
    assert not drawers, "\n".join(sorted(drawers))
    assert found > 500  # or the search has gone blind


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
        if hop and hop.group(1) == "1":
            chain = []
            chains.append(chain)
        if hop:
            chain.append((ROOT / hop.group(2), (hop.group(3) or "").split("::")[-1]))
    assert len(chains) == 3
    for chain in chains:
        assert len(chain) - 1 <= 7, [str(file.relative_to(ROOT)) for file, _ in chain]
        assert chain[0][0] == ROOT / "app" / "main.cpp"
        for (file, call), (following, _) in zip(chain, chain[1:]):
            assert re.search(rf"\b{call}\b", code_of(file)), f"{file} does not call {call}"
            homes = [f for f in (following, following.with_suffix(".cpp")) if f.exists()]
            assert any(defines(f, call) for f in homes), f"{following} does not define {call}"


def code_of(file):
    """A source without comments and includes."""
    return re.sub(r"//.*|^#include.*", "", file.read_text(), flags=re.M)


def defines(file, name):
    """Whether a class of this name, or a function of this name with its body, stands in a file."""
    code = code_of(file)
    return re.search(rf"\b(class|struct) {name}\b[^;]*?{{", code) or re.search(
        rf"\b{name}\([^;{{}}]*(\{{[^;]*?\}}[^;{{}}]*)?\)[^;{{}}()]*(\([^()]*\))?[^;{{}}]*{{", code
    )


# Where lines are still to be wrapped.
WIDE = ("tests/python/test_parameters.py",)


def test_lines_end_before_column_121():
    """Of C++ another test says so; Markdown has tables."""
    listed = subprocess.run(["git", "ls-files", "*.py", "*.js", "*.mjs"], cwd=ROOT, capture_output=True, text=True)
    sources = listed.stdout.split() or [
        str(p.relative_to(ROOT))
        for room in ("bench", "docs", "examples", "python", "scripts", "tests", "validation", "web/src", "web/test")
        for p in (ROOT / room).rglob("*")
        if p.suffix in (".py", ".js", ".mjs")
    ]
    assert len(sources) > 150
    wide = [
        f"{name}:{number}"
        for name in sources
        if (ROOT / name).exists() and not name.startswith(WIDE)
        for number, line in enumerate((ROOT / name).read_text().splitlines(), 1)
        if len(line) > 120
    ]
    assert not wide, "\n".join(wide)


def test_sources_are_formatted():
    rooms = ["app", "bench", "python", "src", "tests", "validation"]
    sources = [str(p) for room in rooms for p in sorted((ROOT / room).rglob("*.?pp"))]
    assert len(sources) > 500
    wide = [name for name in sources if any(len(line) > 120 for line in pathlib.Path(name).read_text().splitlines())]
    assert not wide, wide
    outcome = subprocess.run(
        ["clang-format-14", "--dry-run", "-Werror", *sources], cwd=ROOT, capture_output=True, text=True
    )
    assert outcome.returncode == 0, "run clang-format-14 -i on these:\n" + "\n".join(
        sorted({line.split(":")[0] for line in outcome.stderr.splitlines() if ": error:" in line})
    )

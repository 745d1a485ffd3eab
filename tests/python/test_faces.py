"""What headers are: the faces of their sources, which include what they name."""

import pathlib
import re

from sources import ROOT, SOURCES, code_of, files

# Members of visible lists, by the header in which their list stands or which it fronts: they have none of their own.
LISTS = {
    "grains/dem/kernels/make_kernel.hpp": "avx2 avx512 portable",
    "grains/fields/stage_numbers.hpp": "cohesion_numbers energy_numbers flow_numbers load_numbers",
    "grains/texture/fabric.hpp": "fabric_of_disks fabric_of_spheres",
    "grains/texture/view.hpp": "coordination local_order long_axes quality sample_stress",
    "io/export/export.hpp": "csv extxyz fields lammps netcdf npy vtk",
    "io/film/formats.hpp": "hcc hdf5 npy ptw raw series sfmov text tiff",
    "io/image/image.hpp": "hdf5 jpeg png",
    "io/results/results.hpp": "field film numbers stage voxels",
    "io/sample/formats.hpp": "csv extxyz lammps lammps_data lbpm mercury vtk yade",
    "io/volume/volume.hpp": "meta_image nifti npy npz nrrd",
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


def test_headers_define_functions_that_several_sources_may_include():
    """A plain function that a header defines is defined twice as soon as two units include it."""
    folders = [SOURCES, *(ROOT / name for name in ("tests", "bench"))]
    headers = [header for folder in folders for header in folder.rglob("*.hpp")]
    plain = re.compile(r"^(?!inline|constexpr|template|ARENITE_INLINE)\w.*\b(\w+)\([^;]*$")
    found = []
    for header in headers:
        lines = header.read_text().splitlines()
        found += [
            f"{header.relative_to(ROOT)}: {line}"
            for before, line in zip(["", *lines], lines)
            if (head := plain.match(line)) and head[1] in functions(header, "@") and not before.startswith("template")
        ]
    assert len(headers) > 500 and not found, "\n".join(found)


# Names of the standard library by the header that has them.
STANDARD = {
    "algorithm": "all_of any_of none_of sort stable_sort partial_sort nth_element find find_if find_if_not count "
    "count_if copy copy_n copy_if fill fill_n transform reverse rotate shuffle unique remove "
    "remove_if min max minmax clamp min_element max_element minmax_element lower_bound upper_bound "
    "equal_range binary_search equal lexicographical_compare is_sorted for_each replace replace_if "
    "generate partition merge includes mismatch search adjacent_find set_difference set_intersection "
    "push_heap pop_heap make_heap swap_ranges starts_with",
    "array": "array to_array",
    "atomic": "atomic",
    "chrono": "chrono",
    "cmath": "sqrt cbrt cos sin tan acos asin atan atan2 exp expm1 log log1p log10 log2 pow hypot floor ceil "
    "round lround llround trunc fabs fmod fmin fmax remainder isfinite isnan isinf erf erfc tgamma "
    "lgamma ldexp frexp copysign nextafter nan cyl_bessel_i",
    "complex": "complex",
    "deque": "deque",
    "filesystem": "filesystem",
    "fstream": "ifstream ofstream fstream",
    "functional": "function invoke plus minus multiplies greater less equal_to ref cref bind_front",
    "iterator": "back_inserter inserter next prev distance advance make_move_iterator istreambuf_iterator",
    "limits": "numeric_limits",
    "map": "map multimap",
    "memory": "unique_ptr shared_ptr weak_ptr make_unique make_shared",
    "mutex": "mutex lock_guard unique_lock scoped_lock call_once once_flag",
    "numbers": "numbers",
    "numeric": "accumulate iota inner_product partial_sum reduce midpoint adjacent_difference gcd lcm",
    "optional": "optional nullopt",
    "set": "set multiset",
    "span": "span",
    "sstream": "ostringstream istringstream stringstream",
    "string": "string to_string stod stoi stoll stoull getline",
    "string_view": "string_view",
    "thread": "thread jthread this_thread",
    "tuple": "tuple tie make_tuple apply",
    "type_traits": "is_same_v is_base_of_v conditional_t decay_t remove_cvref_t enable_if_t is_integral_v "
    "is_floating_point_v underlying_type_t",
    "unordered_map": "unordered_map",
    "unordered_set": "unordered_set",
    "utility": "move forward pair make_pair swap exchange index_sequence declval in_place cmp_less",
    "variant": "variant visit get_if holds_alternative monostate",
    "vector": "vector",
    "cstdint": "int8_t uint8_t int16_t uint16_t int32_t uint32_t int64_t uint64_t",
}


def test_files_include_the_standard_headers_that_they_use():
    """By themselves, or with the header of their name."""

    def included(file):
        return set(re.findall(r"^#include <([^>]+)>", file.read_text(), flags=re.M)) if file.exists() else set()

    missing = []
    for file in files():
        code = re.sub(r'"(?:\\.|[^"\\\n])*"', '""', code_of(file))
        has = included(file) | included(file.with_suffix(".hpp"))
        missing += [
            f"{file.relative_to(SOURCES)}: <{header}> for {found.group(0)}"
            for header, names in STANDARD.items()
            if header not in has and (found := re.search(rf"\bstd::(?:ranges::)?(?:{names.replace(' ', '|')})\b", code))
        ]
    assert not missing, "\n".join(missing)

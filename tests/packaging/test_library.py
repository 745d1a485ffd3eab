"""An installed library: its headers stand alone, and a program links it by CMake and by pkg-config."""
import concurrent.futures
import os
import re

import pytest
from conftest import root, run

example = root / "examples/52-library"


@pytest.fixture(scope="module")
def installed(build, tmp_path_factory):
    folder = tmp_path_factory.mktemp("installed")
    run("cmake", "--install", build, "--component", "development", "--prefix", folder)
    return folder


@pytest.fixture(scope="module")
def flags(installed):
    (folder,) = installed.glob("lib*/**/pkgconfig")
    return run(
        "pkg-config", "--cflags", "--libs", "arenite", env={**os.environ, "PKG_CONFIG_PATH": str(folder)}
    ).split()


def others(home):
    """Headers that those of the library name in angle brackets."""
    return {name for h in home.rglob("*.hpp") for name in re.findall(r"^#include <(.*)>", h.read_text(), re.M)}


def compiler(flags, *more):
    includes = [f for f in flags if f.startswith("-I")]
    run("g++", "-std=c++20", "-Wall", "-Wextra", "-Wpedantic", "-Werror", *includes, *more)


def compiles(headers, flags, source, standard=None):
    source.write_text("".join(f"#include <arenite/{header}>\n" for header in headers))
    beforehand = ["-include", standard, "-Winvalid-pch"] if standard else []
    compiler(flags, "-fsyntax-only", *beforehand, source)


def test_every_public_header_compiles_alone_and_those_behind_it_in_any_order(installed, flags, tmp_path):
    home = installed / "include/arenite"
    headers = sorted(str(h.relative_to(home)) for h in home.rglob("*.hpp"))
    public = re.findall(r'^#include "(.*)"', (home / "arenite.hpp").read_text(), re.M)
    assert {"core/error.hpp", "core/version.hpp"} <= set(headers) and set(public) < set(headers)
    # Those of C++, whose parts each header names (tests/python/test_faces.py), are compiled once.
    standard = tmp_path / "standard.hpp"
    standard.write_text("".join(f"#include <{name}>\n" for name in sorted(others(home))))
    compiler(flags, "-x", "c++-header", standard, "-o", f"{standard}.gch")
    jobs = [([header], standard) for header in public] + [(g, None) for g in (headers, headers[::-1], ["arenite.hpp"])]
    with concurrent.futures.ThreadPoolExecutor(2) as pool:
        list(pool.map(lambda at: compiles(jobs[at][0], flags, tmp_path / f"{at}.cpp", jobs[at][1]), range(len(jobs))))


def test_headers_need_no_other_librarys(installed):
    for name in others(installed):
        assert re.fullmatch(r"[a-z_]+|sys/mman\.h", name), f"a header includes <{name}>"


def test_no_path_of_the_machine_that_built_it_is_in_its_package_files(installed):
    files = [*installed.rglob("*.cmake"), *installed.rglob("*.pc")]
    assert len(files) == 3
    for file in files:
        paths = re.findall(r"""(?:^|[\s"';=]|-[LI])(/\w[^\s"';]*)""", file.read_text(), re.M)
        assert not paths, f"{file.name} names {paths}"


def holds(said):
    assert re.search(r"matrix saturation 0\.\d+, modulus \d+\.\d+ GPa", said) and "sigma_yy, matrix: mean" in said
    return said


def test_an_example_links_it(installed, flags, tmp_path):
    run("cmake", "-S", example, "-B", tmp_path / "build", f"-DCMAKE_PREFIX_PATH={installed}")
    run("cmake", "--build", tmp_path / "build")
    by_cmake = holds(run(tmp_path / "build/cemented", cwd=tmp_path))
    run("g++", "-std=c++20", example / "cemented.cpp", *flags, "-o", tmp_path / "cemented")
    assert holds(run(tmp_path / "cemented", cwd=tmp_path)) == by_cmake


def test_another_version_is_refused(installed, tmp_path):
    (tmp_path / "CMakeLists.txt").write_text(
        "cmake_minimum_required(VERSION 3.25)\nproject(other LANGUAGES NONE)\nfind_package(Arenite 9 REQUIRED)\n"
    )
    said = run("cmake", "-S", tmp_path, "-B", tmp_path / "build", f"-DCMAKE_PREFIX_PATH={installed}", ok=False)
    assert 'compatible with requested version "9"' in " ".join(said.split())

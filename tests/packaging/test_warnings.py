"""Warnings are errors in CI, and not on a user's compiler."""
import json
import os

from conftest import root, run


def commands_of(folder, *flags):
    run("cmake", "-S", root, "-B", folder, "-G", "Ninja", "-DARENITE_TESTS=OFF", *flags)
    return [entry["command"] for entry in json.loads((folder / "compile_commands.json").read_text())]


def test_warnings_are_errors_where_that_is_asked_for(tmp_path):
    assert not [c for c in commands_of(tmp_path) if "-Werror" in c]
    assert all("-Werror" in c for c in commands_of(tmp_path, "-DARENITE_WERROR=ON"))


def test_ci_asks_for_it(tmp_path):
    fake = tmp_path / "make"
    fake.write_text('#!/bin/sh\nexec /usr/bin/make -n "$@"\n')
    fake.chmod(0o755)
    said = run(
        root / ".ci/run",
        env={**os.environ, "PATH": f"{tmp_path}:{os.environ['PATH']}", "CMAKE_FLAGS": "-DARENITE_BENCH=ON"},
    )
    (configure,) = [line for line in said.splitlines() if line.startswith(("cmake -S", "@cmake -S"))]
    assert "-DARENITE_WERROR=ON" in configure and "-DARENITE_BENCH=ON" in configure

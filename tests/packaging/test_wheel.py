"""pip makes a wheel of module and program that works in a virtual environment, without a network. The build is not made
a second time."""
import os
import shutil
import sys
import zipfile

import pytest
from conftest import root, run

# What the wheel is made of besides the sources that CMake compiles.
parts = ["pyproject.toml", "setup.py", "CMakeLists.txt", "README.md", "LICENSE", "python/arenite", "cmake/wheel"]
clean = {name: value for name, value in os.environ.items() if not name.startswith(("PYTHON", "PIP_", "VIRTUAL_ENV"))}


@pytest.fixture(scope="module")
def source(tmp_path_factory):
    folder = tmp_path_factory.mktemp("source")
    for name in parts:
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        copy = shutil.copytree if (root / name).is_dir() else shutil.copy
        copy(root / name, folder / name)
    return folder


@pytest.fixture(scope="module")
def environment(tmp_path_factory, source, build):
    """A virtual environment that sees the system's NumPy and has the wheel."""
    folder = tmp_path_factory.mktemp("environment")
    run(sys.executable, "-m", "venv", "--system-site-packages", folder)
    run(
        folder / "bin/pip",
        "install",
        "--no-index",
        "--no-build-isolation",
        "--no-cache-dir",
        source,
        env={**clean, "ARENITE_BUILD": str(build)},
    )
    return folder


def test_wheel_holds_module_figures_types_and_program(tmp_path, source, build):
    run(
        sys.executable,
        "-m",
        "pip",
        "wheel",
        "--no-index",
        "--no-deps",
        "--no-build-isolation",
        "--wheel-dir",
        tmp_path,
        source,
        env={**clean, "ARENITE_BUILD": str(build)},
    )
    (wheel,) = tmp_path.glob("arenite-*.whl")
    names = zipfile.ZipFile(wheel).namelist()
    for file in (root / "python/arenite").rglob("*"):
        if file.suffix in (".py", ".pyi", ".typed"):
            assert str(file.relative_to(root / "python")) in names
    assert [name for name in names if name.startswith("arenite/_core.cpython-") and name.endswith(".so")]
    assert [name for name in names if name.endswith("/bin/arenite")]


def test_module_works_in_a_virtual_environment(environment, tmp_path):
    said = run(
        environment / "bin/python",
        "-c",
        "import arenite, numpy; print(arenite.__file__); "
        "print(len(arenite.pack(arenite.Recipe.template('composite'))), arenite.__version__)",
        cwd=tmp_path,
        env=clean,
    ).splitlines()
    assert said[0].startswith(str(environment))
    count, version = said[1].split()
    assert int(count) > 100 and f"arenite-{version}.dist-info" in [
        f.name for f in environment.glob("lib/python3*/site-packages/*")
    ]


def test_program_works_and_draws_by_the_module_beside_it(environment, tmp_path):
    pytest.importorskip("matplotlib")
    program = environment / "bin/arenite"
    assert "0." in run(program, "--version", env=clean)
    make = "import arenite as a; p = a.Packing([1, 3], [1, 1], [1, 1], width=4, height=2); a.save(p, 'two')"
    run(environment / "bin/python", "-c", make, cwd=tmp_path, env=clean)
    shown = run(program, "figures", tmp_path / "two", "--only", "packing", env=clean)
    assert shown.strip().endswith(".pdf") and os.path.exists(shown.strip().splitlines()[-1])


def test_a_build_of_another_python_is_refused_in_a_sentence(source, tmp_path):
    said = run(
        sys.executable, "setup.py", "bdist_wheel", cwd=source, env={**clean, "ARENITE_BUILD": str(tmp_path)}, ok=False
    )
    assert "there is no arenite; `make build` makes it for /usr/bin/python3" in said.splitlines()[-1]

import os
import pathlib
import re
import shutil
import subprocess
import sys

import arenite
import numpy as np
import pytest
import stubs

package = pathlib.Path(arenite.__file__).parent


def test_the_stub_says_what_the_module_takes_and_gives():
    """Names, parameters, defaults and types, member by member; tests/python/stubs.py writes it anew."""
    assert (package / "_core.pyi").read_text() == stubs.stub(arenite._core, arenite._html.pictures)


def test_the_stub_is_python():
    compile((package / "_core.pyi").read_text(), "_core.pyi", "exec")


def test_the_package_shows_nothing_of_its_own_imports():
    assert not {"sys", "importlib", "os"} & set(dir(arenite))


def test_without_its_compiled_part_it_says_what_builds_it(tmp_path):
    shutil.copytree(package, tmp_path / "arenite", ignore=shutil.ignore_patterns("_core*.so", "__pycache__"))
    found = subprocess.run(
        [sys.executable, "-c", "import arenite"],
        env={"PYTHONPATH": str(tmp_path)},
        cwd=tmp_path,
        capture_output=True,
        text=True,
    )
    assert found.returncode == 1
    assert "`make build` in the source folder builds it" in found.stderr.splitlines()[-1]


def test_a_packing_has_its_velocities_and_its_contacts_theirs():
    recipe = arenite.Recipe.template(
        "composite",
        {
            "populations.0.count": 20,
            "populations.1.count": 20,
            "container.width": "90 mm",
            "packing.solid_fraction": 0.7,
            "stages.0.equilibrium.max_steps": 2000,
        },
    )
    state = arenite.load_stage(arenite.pack(recipe), recipe, "prepare").packing
    for name in ("vx", "vy", "omega"):
        assert getattr(state, name).shape == state.x.shape
    assert np.hypot(state.vx, state.vy).max() > 0
    assert (
        state.contacts.sliding_velocity.shape == state.contacts.fn.shape
        and np.isfinite(state.contacts.sliding_velocity).all()
    )


def described(docstring):
    """What a docstring says behind its signature."""
    return re.sub(r"^\w+\(.*\) -> .*\n?", "", docstring or "").strip()


def test_everything_has_a_docstring():
    functions, classes = stubs.described(arenite._core)
    silent = [name for name, thing in functions.items() if not described(thing.__doc__)]
    for name, members in classes.items():
        silent += [name] * (not vars(arenite)[name].__doc__)
        silent += [
            f"{name}.{member}"
            for member, thing in members.items()
            if not described((thing.__func__ if isinstance(thing, staticmethod) else thing).__doc__)
        ]
    assert not silent


def test_notebooks_show_results(result):
    for part in [result, result.stages[-1], result.stages[-1].packing, *result.fields, result.fields[0].map]:
        text = part._repr_html_()
        assert "<table>" in text and "data:image/png;base64," in text


def test_notebooks_show_numbers_without_matplotlib(result, monkeypatch):
    monkeypatch.setitem(sys.modules, "matplotlib.figure", None)
    text = result.stages[-1].packing._repr_html_()
    assert "<table>" in text and "<img" not in text


def test_numbers_say_their_unit_and_what_they_are(result):
    assert result.meanings["texture.force.mean_N"] == ("N", "Mean normal force of the set")
    assert result.meanings["modulus_Pa"][0] == "Pa"
    assert arenite.open(result.path).meanings == result.meanings


def test_results_open_again(result):
    again = arenite.open(result.path)
    assert [s.name for s in again.stages] == ["packing", "compact", "rest"] and len(again.fields) == 2
    assert again.numbers == result.numbers and again.title
    with pytest.raises(ValueError):
        arenite.open("/nowhere/at/all")


def test_identification_reads_the_thesis_tables(examples):
    tables = sorted((examples / "data").rglob("separation-force.csv"))
    if not tables:
        pytest.skip("the table is not among the examples")
    found = arenite.identify_adhesion(str(tables[0]), stiffness=27.35e6, radii=(6.2e-3, 6.2e-3))
    assert [round(g["surface_energy"]["value"] / 1e6, 3) for g in found["groups"]] == [0.268, 0.511, 0.745, 1.061]


def test_a_study_becomes_a_table(tmp_path):
    recipe = arenite.Recipe.template(
        "cemented", {"bidisperse.box_area": 40, "bidisperse.size_ratio": 1.25, "grid.nodes": 64, "grid.crop": "6 mm"}
    )
    file = tmp_path / "recipe.toml"
    file.write_text(recipe.toml() + "\n[sweep.grid]\n\"cement.width\" = [0.2, 0.8]\n")
    done = arenite.run_study(str(file), str(tmp_path / "out"))
    assert done == {"done": 2, "not_done": 0, "left": 0}
    table = arenite.study_table(str(file), str(tmp_path / "out"))
    assert list(table["cement.width"]) == [0.2, 0.8] and table["status"] == ["done", "done"]
    saturation = next(v for k, v in table.items() if k.endswith("saturation") or k.endswith("S_m"))
    assert saturation[1] > saturation[0]


def test_a_table_has_the_names_of_the_programs(tmp_path):
    recipe = arenite.Recipe.template(
        "cemented", {"bidisperse.box_area": 40, "bidisperse.size_ratio": 1.25, "grid.nodes": 64, "grid.crop": "6 mm"}
    )
    file, out = tmp_path / "recipe.toml", tmp_path / "out"
    file.write_text(recipe.toml() + '\n[sweep.grid]\n"cement.gap" = ["50 um", "80 um"]\n"cement.kind" = ["bridges"]\n')
    arenite.run_study(file, out)
    for by, names in [([], []), (["cement.gap"], ["--by", "cement.gap"])]:
        written = subprocess.run(
            [os.environ["ARENITE"], "study", "collect", str(file), "--out", str(out), *names],
            capture_output=True,
            text=True,
            check=True,
        ).stdout
        csv = pathlib.Path(written.splitlines()[0]).read_text()
        table = arenite.study_table(file, out, by=by)
        assert list(table) == list(dict.fromkeys(name.split(" [")[0] for name in csv.splitlines()[0].split(",")))
        np.testing.assert_allclose(table["cement.gap"], [50e-6, 80e-6], rtol=1e-15)  # SI, as all numbers of Python

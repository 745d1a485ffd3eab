"""What arguments may be, and in which sentence they are refused."""

import json
import pathlib
import subprocess
import sys

import arenite
import numpy as np
import pytest


def grains(n=6, radius=1e-3, **options):
    x, y = np.meshgrid((2 * np.arange(n) + 1) * radius, (2 * np.arange(n) + 1) * radius)
    return arenite.Packing(
        x.ravel(), y.ravel(), np.full(n * n, radius), width=2 * n * radius, height=2 * n * radius, **options
    )


@pytest.mark.parametrize("sigma", [[-1.0, -2.0], [], [[-1.0] * 36]], ids=["too few", "none", "two dimensions"])
def test_measured_stresses_are_one_a_grain(sigma):
    with pytest.raises(ValueError, match="sigma_hyd"):
        arenite.measure(grains(), sigma_hyd=sigma)


@pytest.mark.parametrize(
    "change, sentence",
    [
        (dict(radius=[-1e-3]), "radius"),
        (dict(radius=[np.nan]), "finite"),
        (dict(x=[np.inf]), "finite"),
        (dict(width=0), "width"),
        (dict(periodic="z"), "periodic"),
        (dict(x=[5.0]), "outside the container"),
        (dict(material=[1]), "whole numbers from 0 to 0"),
        (dict(material=[0.5]), "whole numbers"),
        (dict(x=["a"]), "x: give numbers"),
        (dict(x=[[1e-3]]), "one dimension"),
        (dict(width="3 kg"), "width.*length"),
        (dict(width=[1]), "width.*type list"),
        (dict(thickness=np.nan), "thickness"),
    ],
)
def test_packings_that_cannot_be_are_refused(change, sentence):
    given = {"x": [1e-3], "y": [1e-3], "radius": [1e-3], "width": 2e-3, "height": 2e-3, **change}
    with pytest.raises(ValueError, match=sentence):
        arenite.Packing(**given)


@pytest.mark.parametrize(
    "phase", [[[0, 1.7]], [[0, 258]], [[0, -1]], [[0, np.nan]], [0, 1], np.zeros((0, 4)), [["a", "b"]]]
)
def test_phases_are_0_1_or_2(phase):
    with pytest.raises(ValueError, match="phase"):
        arenite.PhaseMap(phase, dx=1e-3)


@pytest.mark.parametrize(
    "options, sentence",
    [
        (dict(dx=0), "spacing"),
        (dict(dx=np.nan), "finite"),
        (dict(dx="1 kg"), "length"),
        (dict(dx=1, grain=[[0, 0.5]]), "whole"),
        (dict(dx=1, grain=[[0, 2**31 - 1]]), "whole numbers from -1 to 1"),
        (dict(dx=1, grain=[[0], [0]]), "shape"),
        (dict(dx=1, grain=[[-1, -1]]), "label"),
    ],
)
def test_maps_that_cannot_be_are_refused(options, sentence):
    with pytest.raises(ValueError, match=sentence):
        arenite.PhaseMap([[2, 2]], **options)


def test_pictures_of_a_signal_and_its_error_have_one_shape():
    packing = arenite.propose_contacts(grains(), position_error=1e-9)
    with pytest.raises(ValueError, match="the same shape"):
        arenite.infer_forces(packing, np.zeros((40, 60)), np.ones((60, 40)), pixel=1e-3, first=(0, 0), factor=[15e-9])
    with pytest.raises(ValueError, match="walls has \"botom\""):
        arenite.infer_forces(
            packing,
            np.zeros((40, 60)),
            np.ones((40, 60)),
            pixel="1 mm",
            first=(0, 0),
            factor=["0.015 K/MPa"],
            walls={"botom": 1.0},
        )


@pytest.mark.parametrize(
    "options",
    [dict(radii=[-1.0]), dict(radii=[np.nan]), dict(smallest=-1.0), dict(smallest=np.nan), dict(contrast="x")],
)
def test_circles_have_radii(options):
    with pytest.raises(ValueError, match="radii|smallest|contrast"):
        arenite.find_grains(np.eye(20), **options)


def test_a_negative_count_of_frames_is_refused(examples):
    film = next((examples.parent / "tests" / "data").rglob("*.ptw"))
    with pytest.raises(ValueError, match="count is -1"):
        arenite.read_film(film, count=-1)


def test_files_are_paths_or_text(recipe, tmp_path):
    file = tmp_path / "recipe.toml"
    file.write_text(recipe.toml())
    assert arenite.Recipe(file) == arenite.Recipe(str(file))
    with pytest.raises(ValueError):
        arenite.open(tmp_path / "nothing")
    with pytest.raises(ValueError, match="nothing"):
        arenite.lock_in(tmp_path / "nothing.ptw", 3.0)
    with pytest.raises(ValueError, match="a film is a file"):
        arenite.lock_in(3, 3.0)


def test_changes_take_numbers_of_numpy_and_paths(recipe):
    assert recipe.changed({"seed": np.int64(7)}).seed == 7
    assert recipe.changed({"cement.width": np.float32(0.5)}) == recipe.changed({"cement.width": 0.5})
    assert recipe.changed({"title": pathlib.Path("a/b")}).title == "a/b"
    with pytest.raises(ValueError, match="seed is of type set"):
        recipe.changed({"seed": {1}})


def test_quantities_are_numbers_or_text_with_a_unit():
    phase = np.ones((16, 16), np.uint8)
    map = arenite.PhaseMap(phase, dx="1 mm")
    assert np.array_equal(
        arenite.load(map, strain="1e-4", matrix=1e9).sigma_yy, arenite.load(map, strain=1e-4, matrix="1 GPa").sigma_yy
    )
    with pytest.raises(ValueError, match="strain.*number without unit"):
        arenite.load(map, strain="1 mm")
    with pytest.raises(ValueError, match="gap.*unit"):
        arenite.cement(grains(), gap="0.1")
    t = np.arange(200) / 50
    film = (100 + 5 * np.cos(2 * np.pi * 3 * t)[:, None, None] + np.zeros((1, 4, 4))).astype(np.float32)
    assert (
        arenite.lock_in(film, "3 Hz", frame_rate="50 Hz").frequency == arenite.lock_in(film, 3, frame_rate=50).frequency
    )


def test_a_stage_is_a_name_or_a_number(recipe):
    packing = arenite.pack(recipe)
    with pytest.raises(ValueError, match="stage is of type float"):
        arenite.load_stage(packing, recipe, 1.0)
    with pytest.raises(ValueError, match="counted from 0"):
        arenite.load_stage(packing, recipe, np.int64(9))
    with pytest.raises(ValueError, match="there are compact, rest"):
        arenite.load_stage(packing, recipe, "nowhere")


def test_contacts_have_no_names_that_are_slips_and_no_forces_that_nobody_gave():
    with pytest.raises(ValueError, match='no arrays of the name "Fn"; there are i, j, fn'):
        grains(contacts={"i": [0], "j": [1], "Fn": [5.0]})
    told = arenite.measure(grains(contacts={"i": [0, 6], "j": [1, 7]}))
    assert any("forces of the contacts are not known" in note for note in told["notes"])
    assert "rattlers" not in told["coordination"] and "stress" not in told
    known = arenite.measure(grains(contacts={"i": [0, 6], "j": [1, 7], "fn": [5.0, 0.0]}))
    assert "rattlers" in known["coordination"] and "stress" in known


def test_sentences_name_arguments_not_options(recipe, tmp_path):
    with pytest.raises(ValueError) as refused:
        recipe.changed({"nowhere": 1})
    assert "--" not in str(refused.value)
    file = tmp_path / "recipe.toml"
    file.write_text(recipe.toml() + "\n[sweep.grid]\n\"cement.width\" = [0.2, 0.8]\n")
    (tmp_path / "out").mkdir()
    with pytest.raises(ValueError, match=r"^by seed"):
        arenite.study_table(file, tmp_path / "out", by=["seed"])


def test_a_study_that_cannot_be_read_leaves_no_folder(tmp_path):
    with pytest.raises(ValueError):
        arenite.run_study(tmp_path / "nothing.toml", tmp_path / "out")
    assert not (tmp_path / "out").exists()
    with pytest.raises(ValueError, match="no such folder"):
        arenite.study_table(tmp_path / "nothing.toml", tmp_path / "out")


def test_figures_that_cannot_be_made_say_why_in_one_sentence(result, tmp_path):
    (tmp_path / "file").write_text("")
    options = {"result": result.path, "only": ["coordination"], "out": str(tmp_path / "file" / "below")}
    run = [sys.executable, "-m", "arenite.figures", json.dumps(options)]
    home = str(pathlib.Path(arenite.__file__).parents[1])
    refused = subprocess.run(run, capture_output=True, text=True, env={"PYTHONPATH": home})
    assert refused.returncode == 2 and refused.stderr.count("\n") == 1 and "--out" in refused.stderr
    (tmp_path / "matplotlib.py").write_text("")  # hides nothing: a finder that knows no Matplotlib does
    hide = (
        "import sys, importlib.util as u; f = u.find_spec; "
        "u.find_spec = lambda n, *a: None if n == 'matplotlib' else f(n, *a)"
    )
    (tmp_path / "sitecustomize.py").write_text(hide)
    (tmp_path / "matplotlib.py").unlink()
    lacking = subprocess.run(run, capture_output=True, text=True, env={"PYTHONPATH": f"{tmp_path}:{home}"})
    assert lacking.returncode == 2 and lacking.stderr.count("\n") == 1 and "Matplotlib" in lacking.stderr

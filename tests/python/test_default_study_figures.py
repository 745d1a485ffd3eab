"""What the page of a study shows without figures.toml, and that print shows the same."""

import os
import subprocess

import arenite
import arenite.figures as figures
import numpy as np
import pytest

sweep = """
[sweep.grid]
"variables.I" = [0.1, 0.3]
"contact.friction" = [0.1, 0.3, 0.5]
"""


@pytest.fixture(scope="module")
def study(tmp_path_factory):
    folder = tmp_path_factory.mktemp("study")
    recipe = subprocess.run([os.environ["ARENITE"], "init", "shear"], capture_output=True, text=True, check=True).stdout
    recipe = recipe.replace("24*d", "8*d").replace("count = 500", "count = 60").split("# [sweep.grid]")[0]
    (folder / "shear.toml").write_text(recipe + sweep)
    subprocess.run(
        [os.environ["ARENITE"], "study", "run", "shear.toml", "--out", "out", "--quiet"],
        cwd=folder,
        check=True,
        capture_output=True,
    )
    return folder / "out"


def test_sheared_runs_show_their_rheology_first_with_a_curve_for_each_value_of_another_key(study):
    shown = {figure["id"]: figure for figure in figures.study_document(study)["figures"]}
    assert list(shown)[:2] == ["critical-state", "rheology"]
    rheology = shown["rheology"]["drawing"]
    assert [entry["name"] for entry in rheology["key"]] == [f"contact friction = {mu}" for mu in (0.1, 0.3, 0.5)]
    of_mu = rheology["panels"][0]["series"]
    assert [len(series["x"]) for series in of_mu] == [2, 2, 2]
    assert len({series["colour"] for series in of_mu}) == 3
    assert [len(series["x"]) for series in shown["critical-state"]["drawing"]["panels"][0]["series"]] == [3, 3]
    every = [arenite.open(str(run)) for run in sorted((study / "runs").iterdir())]
    expected = arenite.curves.rheology(every)
    assert np.sort([y for series in of_mu for y in series["y"]]) == pytest.approx(np.sort(expected["mu"].values))


def test_print_shows_each_figure_of_the_page_once(study, tmp_path):
    paths = figures.save_all(study, tmp_path)
    names = [path.stem for path in paths]
    assert len(names) == len(set(names)) == len(figures.study_document(study)["figures"])
    assert {"rheology", "critical-state", "peak-mu"} <= set(names)

"""The page that Python writes of a folder is the one that the program wrote there."""
import os
import subprocess

import arenite


def program(*words, folder):
    subprocess.run([os.environ["ARENITE"], *words, "--quiet"], cwd=folder, check=True, capture_output=True)


def check_page(folder):
    arenite.page(str(folder), str(folder / "again.html"))
    assert (folder / "again.html").read_bytes() == (folder / "report.html").read_bytes()


def test_of_a_run_and_of_a_load(recipe, tmp_path):
    (tmp_path / "recipe.toml").write_text(recipe.toml())
    program("run", "recipe.toml", "--out", "out", folder=tmp_path)
    check_page(tmp_path / "out")
    (sample,) = (tmp_path / "out").glob("*cement*.h5")
    program("load", str(sample), "--out", "loaded", folder=tmp_path)
    check_page(tmp_path / "loaded")

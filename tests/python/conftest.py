import os
import pathlib
import sys

import pytest

sys.path.insert(0, os.environ["ARENITE_PYTHONPATH"])
root = pathlib.Path(__file__).resolve().parents[2]
small = {"bidisperse.box_area": 80, "bidisperse.size_ratio": 1.67, "grid.nodes": 128, "grid.crop": "9 mm"}


@pytest.fixture(scope="session")
def examples():
    return root / "examples"


@pytest.fixture(scope="session")
def recipe():
    import arenite

    return arenite.Recipe.template("cemented", small)


@pytest.fixture(scope="session")
def result(recipe, tmp_path_factory):
    """A packing of some hundred disks, compacted, cemented and pulled."""
    import arenite

    return arenite.run(recipe, str(tmp_path_factory.mktemp("run")))

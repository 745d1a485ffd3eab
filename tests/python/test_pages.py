"""The page that Python writes of a folder is the one that the program wrote there."""
import base64
import json
import os
import re
import subprocess
import zlib

import arenite
import numpy as np
import pytest
from arenite import _core, curves


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


def test_its_figures_are_those_of_print(result, tmp_path):
    arenite.page(result, str(tmp_path / "page.html"))
    heads = _core._figure_heads()
    del heads["runs"]
    assert content_of(tmp_path / "page.html")["figures"] == heads


sliding = """seed = 1
[container]
width = "60 mm"
thickness = "10 mm"
periodic_x = true
[packing]
solid_fraction = 0.75
[materials.A]
density = "2500 kg/m^3"
stiffness = "0.1 kN/mm"
[[populations]]
material = "A"
count = 40
size = { law = "uniform", min = "8 mm", max = "12 mm" }
[contact]
friction = 0.3
[[stages]]
name = "shear"
top = { pressure = "10 kPa" }
slide = { top = "1 m/s" }
rough = { top = true, bottom = true }
duration = "40 ms"

[[stages.programmes]]
of = "slide.top"
repeat = true
table = [["0 s", "1 m/s"], ["10 ms", "3 m/s"], ["10 ms", "0.2 m/s"], ["20 ms", "1 m/s"]]
"""


def content_of(page):
    """What a page says, with the numbers of its block in place."""
    text = page.read_text()

    def packed(name):
        return zlib.decompress(base64.b64decode(re.search(rf'id="{name}"[^>]*>([^<]*)<', text).group(1)))

    block = np.frombuffer(packed("numbers"), np.uint8)

    def placed(node):
        if isinstance(node, list):
            return [placed(item) for item in node]
        if not isinstance(node, dict):
            return node
        if "as" not in node:
            return {name: placed(item) for name, item in node.items()}
        form = np.dtype(f"<{node['as']}")
        ranks = block[node["at"] : node["at"] + node["n"] * form.itemsize].reshape(form.itemsize, node["n"])
        return np.ascontiguousarray(ranks.T).view(form).ravel()

    return placed(json.loads(packed("document")))


def test_curves_of_a_programmed_slide_are_those_of_python(tmp_path):
    result = arenite.run(arenite.Recipe.from_text(sliding), str(tmp_path / "run"))
    arenite.page(result, str(tmp_path / "page.html"))
    (shown,) = content_of(tmp_path / "page.html")["stages"][-1]["figures"]["test-curves"]
    found = curves.along(result)
    ratio, volume = shown["panels"]
    assert ratio["x"]["brief"] == "shear strain" and "unit" not in ratio["x"] and ratio["y"]["brief"] == "μ"
    (line,), (below,) = ratio["series"], volume["series"]
    assert len(line["x"]) > 15 and line["x"] == pytest.approx(found["shear_strain"].values, rel=1e-5)
    expected = np.abs(found["mu"].values)
    expected[~(expected < 2)] = np.nan
    assert np.array(line["y"], float) == pytest.approx(expected, rel=1e-5, nan_ok=True)
    assert below["y"] == pytest.approx(100 * found["volumetric_strain"].values, rel=1e-5, abs=1e-5)
    # The way by the table: 20 mm in the first 10 ms and 6 in the next, over some 60 mm of height. Trapezia of the
    # speeds at the rows would not see the jump.
    history = result.stages[-1].history
    begin, way = history["time"][-1] - 0.04, history["top_slid"]
    assert way[-1] == pytest.approx(0.052, rel=1e-6)
    late = history["time"] - begin > 0.03
    expected = 0.046 + 0.2 * (history["time"] - begin - 0.03) + 40 * (history["time"] - begin - 0.03) ** 2
    assert way[late] == pytest.approx(expected[late], rel=1e-6)

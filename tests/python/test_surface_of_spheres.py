"""The free surface of spheres that collapsed, against a computation of its own."""

import numpy as np
import pytest

import arenite
from arenite import _core, flows

RECIPE = """
seed = 3
dimension = 3
[materials.acrylic]
density = "1190 kg/m^3"
stiffness = "2 kN/m"
[[populations]]
material = "acrylic"
count = 150
size = { law = "uniform", min = "4 mm", max = "6 mm" }
[packing]
method = "random"
area = { right = "30 mm" }
[container]
width = "250 mm"
height = "120 mm"
depth = "20 mm"
periodic_z = true
[contact]
friction = 0.5
rolling = "elastic_plastic"
rolling_friction = 0.1
[[boundaries]]
name = "gate"
corners = [["30 mm", "0 mm", "0 mm"], ["30 mm", "120 mm", "0 mm"],
           ["30 mm", "120 mm", "20 mm"], ["30 mm", "0 mm", "20 mm"]]
[[stages]]
name = "fill"
gravity = true
drag = "5 1/s"
equilibrium = { unbalanced = 1e-2, kinetic = 1e-3 }
[[stages]]
name = "collapse"
gravity = true
open = { right = true, top = true }
boundaries = [{ name = "gate", absent = true }]
duration = "0.3 s"
snapshots = 4
"""


def hanging_together(position, radius):
    """The largest set of spheres whose surfaces are within a tenth of the mean diameter; sides are no neighbours."""
    apart = np.linalg.norm(position[:, None] - position[None], axis=2) - radius[:, None] - radius[None]
    near = apart <= 0.2 * radius.mean()
    label = np.arange(len(radius))
    while True:
        lower = np.where(near, label[None], len(radius)).min(axis=1)
        if (lower == label).all():
            break
        label = lower
    return label == np.bincount(label).argmax()


def test_fronts_heights_and_runout_are_those_of_the_spheres(tmp_path):
    (tmp_path / "recipe.toml").write_text(RECIPE)
    result = arenite.run(arenite.Recipe(tmp_path / "recipe.toml"), tmp_path / "out")
    before, after = (stage.states[-1] for stage in result.spheres[1:])
    fronts = []
    for state in (before, after):
        found = arenite.free_surface(state)
        one = hanging_together(state.position, state.radius)
        assert found["grains"] == one.sum()
        x, y, z = state.position[one].T
        r = state.radius[one]
        assert found["right"] == pytest.approx((x + r).max()) and found["top"] == pytest.approx((y + r).max())
        d = 2 * state.radius.mean()
        rows = (z - r).min() + d * (np.arange(int(((z + r).max() - (z - r).min()) / d)) + 0.5)
        for place, height in zip(found["place"], found["height"]):
            up = r**2 - (x - place) ** 2 - (z - rows[:, None]) ** 2
            rims = np.where(up >= 0, y + np.sqrt(np.maximum(up, 0)), -np.inf).max(axis=1)
            assert height == pytest.approx(rims[np.isfinite(rims)].mean(), abs=1e-7)
        fronts.append((found["left"], found["right"]))
    told = result.spheres[-1].numbers["surface"]
    (left, right), (_, now) = fronts
    assert told["runout_m"]["value"] == pytest.approx(now - right) and told["runout_m"]["value"] > 0.02
    assert told["runout_over_width"]["value"] == pytest.approx((now - right) / (right - left))
    curve = flows.runouts([result])
    assert curve["runout"].values == [told["runout_over_width"]["value"]] and curve["runout_error"].values[0] > 0
    way, profile = _core._figures_of_part(result.spheres[-1])["collapse"][0]["panels"]
    assert way["series"][0]["name"] == "right front" and len(way["series"][0]["y"]) == 4
    assert way["series"][0]["y"][-1] == pytest.approx(1e3 * (now - fronts_at_begin(result)), abs=1e-3)
    assert [series.get("name", "") for series in profile["series"]] == ["before", "", "", "", "in the end"]
    assert profile["series"][-1]["y"] == pytest.approx(1e3 * (np.asarray(found["height"]) - lowest(result)), abs=1e-2)


def fronts_at_begin(result):
    return arenite.free_surface(result.spheres[-1].states[0])["right"]


def lowest(result):
    return arenite.free_surface(result.spheres[-1].states[0])["bottom"]

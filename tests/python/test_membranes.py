"""A biaxial test between membranes, as Python and pictures see it."""

import arenite
import numpy as np
import pytest

between_membranes = """
seed = 3
container = { width = "60 mm", height = "90 mm", thickness = "60 mm" }
packing = { method = "random" }
materials.POM = { density = "1410 kg/m^3", stiffness = "1 kN/mm" }
populations = [{ material = "POM", count = 80, size = { law = "uniform", min = "6 mm", max = "9 mm" } }]
contact = { restitution = 0.3, friction = 0.3, wall_friction = 0 }

[[stages]]
name = "shear"
left = { membrane = "20 kPa" }
right = { membrane = "20 kPa" }
top = { velocity = "400 mm/s" }
duration = "60 ms"
"""


@pytest.fixture(scope="module")
def stage():
    recipe = arenite.Recipe.from_text(between_membranes)
    return arenite.load_stage(arenite.pack(recipe), recipe)


def enclosed_area(left, right):
    """By the shoelace formula, around both membranes and the platens between their ends."""
    x, y = np.vstack([left[::-1], right]).T
    return 0.5 * abs(np.dot(x, np.roll(y, -1)) - np.dot(y, np.roll(x, -1)))


def test_the_box_has_the_area_that_platens_and_membranes_enclose(stage):
    domain = stage.packing.domain
    left, right = domain["boundaries"]
    assert (left["name"], right["name"]) == ("left_membrane", "right_membrane")
    area = enclosed_area(left["points"], right["points"])
    assert domain["width"] * domain["height"] == pytest.approx(area, rel=1e-12)
    assert np.all(left["points"][[0, -1], 1] == [domain["bottom"]["position"], domain["top"]["position"]])
    inside = stage.packing.x - stage.packing.radius
    assert np.min(inside) > np.min(left["points"][:, 0]) - 0.01 * np.max(stage.packing.radius)


def test_stresses_on_the_sides_follow_from_all_forces_on_the_grains(stage):
    history = stage.history
    curves = arenite.curves_along(stage)
    height = history["top_position"] - history["bottom_position"]
    assert np.allclose(curves["sigma_xx"][0], history["mean_force_x"] / height / 0.06, rtol=1e-12)


def test_pictures_show_how_far_membranes_bulge(stage):
    pytest.importorskip("matplotlib")
    from arenite.figures.packings import boundaries_of, extent_of

    left, right, bottom, top = extent_of(stage.packing)
    lines = boundaries_of(stage.packing)
    assert len(lines) == 2 and left <= np.min(lines[0][:, 0]) and right >= np.max(lines[1][:, 0])
    assert left < stage.packing.domain["left"]["position"] or right > stage.packing.domain["right"]["position"]

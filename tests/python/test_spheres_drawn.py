"""Pictures of spheres, and films of their stored states."""

import types

import numpy as np
import pytest

import arenite
from arenite import _compare_page, animate, compare, curves, flows
from arenite.figures import motion, moving, spheres
from arenite.figures.shots import shots_of
from test_spheres import RECIPE

PIL = pytest.importorskip("PIL.Image")


@pytest.fixture(scope="module")
def pressed(tmp_path_factory):
    """A hundred spheres, then pressed along y, with the states on the way."""
    folder = tmp_path_factory.mktemp("pressed")
    stage = "[[stages]]\nname = 'axial'\ntop = { velocity = '20 mm/s' }\nduration = '0.02 s'\nsnapshots = 2\n"
    sides = "".join(f"{side} = {{ pressure = '10 kPa' }}\n" for side in ("right", "front"))
    (folder / "recipe.toml").write_text(RECIPE + stage + sides)
    return arenite.run(arenite.Recipe(folder / "recipe.toml"), folder / "out")


def some_spheres(*places):
    """Spheres as (right, up, towards the viewer, radius) of the picture."""
    places = np.array(places, float)
    position = places[:, :3] @ spheres.frame()
    return types.SimpleNamespace(position=position, radius=places[:, 3])


def test_the_viewers_directions_are_those_of_a_rotation_with_y_upwards():
    right, up, towards = spheres.frame()
    assert np.allclose(spheres.frame() @ spheres.frame().T, np.eye(3))
    assert np.allclose(np.cross(right, up), towards)
    assert right[1] == 0 and up[1] > 0 and towards[2] > 0 and towards[0] > 0


@pytest.mark.parametrize("across", [30, 300])  # pixels: spheres drawn together, and each on its own
def test_the_nearest_sphere_is_seen_and_each_covers_its_disk(across):
    raster = spheres.Raster((-3, 3, -2, 2), across, some_spheres((0, 0, 0, 1), (0.5, 0, 2, 0.5), (0, 0, -4, 0.9)))
    row, column = raster.rows // 2, lambda x: int((x + 3) / 6 * across)
    assert raster.nearest[row, column(0.5)] == 1 and raster.nearest[row, column(-0.5)] == 0
    assert raster.nearest[row, column(-1.2)] == -1 and not (raster.nearest == 2).any()
    area = np.count_nonzero(raster.nearest >= 0) * raster.pixel**2
    rim = 2 * np.pi * raster.pixel**1.5  # what a raster misses of a disk of radius 1 goes with the pixels of its rim
    assert area == pytest.approx(np.pi, abs=rim)
    blue = raster.image(np.array([[1.0, 0, 0], [0, 0, 1.0], [0, 1.0, 0]]))[row, column(0.5)]
    assert blue[2] > 0.5 and blue[0] == blue[1] == 0


def test_numbers_of_spheres_are_those_of_their_contacts(pressed):
    shot = shots_of(pressed, "axial")[-1]
    packing = shot.packing
    touching = np.bincount(packing.contact_i, minlength=120) + np.bincount(packing.contact_j, minlength=120)
    assert np.array_equal(arenite.grain_values(packing, "coordination"), touching)
    assert np.allclose(arenite.grain_values(packing, "speed"), np.linalg.norm(packing.velocity, axis=1))
    # The pressures of all, by their volumes, are that of the cell.
    volume = 4 / 3 * np.pi * packing.radius**3
    mean = (arenite.grain_values(packing, "pressure") * volume).sum() / np.prod(packing.domain["size"])
    stress = np.array(pressed.spheres[-1].numbers["stress"]["value"])
    assert mean == pytest.approx(-np.trace(stress) / 3, rel=1e-9)
    assert (arenite.grain_values(packing, "deviator") >= 0).all()
    with pytest.raises(ValueError, match="no rotation"):
        arenite.grain_values(packing, "rotation")


def test_displacements_of_spheres_go_on_across_periodic_sides(pressed):
    shots = shots_of(pressed, "axial")
    ways = arenite.displacements([shot.packing for shot in shots])
    assert not ways[0].any() and ways[-1].shape == (120, 3)
    step = shots[-1].packing.position - shots[0].packing.position
    cells = (ways[-1] - step) / np.array(shots[-1].packing.domain["size"])
    assert np.allclose(cells, np.round(cells), atol=1e-9)
    drawn = motion.displacements(shots)[-1]
    assert drawn == pytest.approx(np.linalg.norm(ways[-1], axis=1)) and drawn.max() < 5e-3


@pytest.mark.parametrize("by", [by for by in animate.colourings if by != "rotation"])
def test_every_colouring_of_spheres_is_drawn(pressed, by):
    shots = shots_of(pressed, "axial")
    pictures = moving.Pictures(shots, by, chains=by == "material", size=(160, 160))
    first, last = (pictures.image(k).copy() for k in (0, len(shots) - 1))
    assert np.any(first != last)
    assert np.any(last[..., :3].min(axis=-1) < 128)


def test_a_film_of_spheres_has_a_picture_a_state_and_a_curve_beside(pressed, tmp_path):
    path = animate.save(pressed, tmp_path / "a.gif", by="pressure", size=(240, 160), curve="test", stage="axial")
    assert PIL.open(path).n_frames == 2
    both = animate.save(pressed, tmp_path / "b.gif", curve=("time", "top_force"), size=(240, 160))
    assert PIL.open(both).n_frames == len(shots_of(pressed)) > 3
    # Of a whole run the curve of the test stands beside the stage that is one.
    whole = animate.save(pressed, tmp_path / "d.gif", curve="test", size=(240, 160))
    assert PIL.open(whole).n_frames > 3
    with pytest.raises(ValueError, match=r"no stage \(compress\) is compressed along one axis or sheared"):
        animate.save(arenite.Result(spheres=pressed.spheres[:2]), tmp_path / "e.gif", curve="test")
    with pytest.raises(ValueError, match="no beauty to draw; there are time, axial_strain"):
        animate.save(pressed, tmp_path / "c.gif", curve=("time", "beauty"), stage="axial")
    with pytest.raises(ValueError, match="no rotation"):
        animate.save(pressed, tmp_path / "c.gif", by="rotation")


def test_a_tests_curves_are_those_of_its_sides_in_python_and_in_a_table(pressed, tmp_path):
    found = curves.along(pressed, "axial")
    history = pressed.spheres[-1].history
    height = history["top_position"] - history["bottom_position"]
    before = pressed.spheres[-2].snapshots[-1].packing.domain
    at_first = before["top"]["position"] - before["bottom"]["position"]
    assert np.allclose(found["axial_strain"].values, 1 - height / at_first, atol=1e-12) and height[0] < at_first
    assert np.allclose(found["time"].values, history["time"] - history["time"][0])
    assert found["q"].unit == "Pa" and "mean of the two others" in found["q"].meaning
    arenite.export(pressed, tmp_path, "csv")
    table = np.genfromtxt(tmp_path / "axial_curves.csv", delimiter=",", names=True, deletechars="")
    assert np.array_equal(table["q_over_p"], found["q_over_p"].values, equal_nan=True)
    with pytest.raises(ValueError, match="neither compressed along one axis nor sheared"):
        curves.along(pressed, "compress")


def test_fabric_of_spheres_along_a_test_is_that_of_their_states(pressed):
    found = curves.of_states(pressed, "axial")
    stage = pressed.spheres[-1]
    numbers = [state.packing.measure() for state in stage.snapshots]
    assert np.allclose(found["z"].values, [one["coordination"]["all"]["value"] for one in numbers])
    assert found["z"].values[-1] == stage.numbers["coordination"]["all"]["value"]
    assert found["z_error"].values[-1] == stage.numbers["coordination"]["all"]["error"]
    assert np.allclose(found["q_over_p"].values, found["q"].values / found["p"].values)
    along = curves.along(pressed, "axial")
    assert found["axial_strain"].values[-1] == along["axial_strain"].values[-1] > 0.01
    with pytest.raises(ValueError, match="neither compressed along one axis nor sheared"):
        curves.of_states(pressed, "compress")


def test_tests_of_spheres_are_points_of_one_curve(pressed):
    along, found = curves.along(pressed, "axial"), curves.rheology([pressed, pressed], "axial")
    d, density, history = 4e-3, 2500, pressed.spheres[-1].history
    before = pressed.spheres[-2].snapshots[-1].packing.domain
    pairs = [("left", "right"), ("back", "front")]
    sides = [history[f"{b}_position"] - history[f"{a}_position"] for a, b in pairs]
    at_first = [before[b]["position"] - before[a]["position"] for a, b in pairs]
    across = np.mean([1 - side / first for side, first in zip(sides, at_first)], axis=0)
    rate = np.gradient(along["axial_strain"].values - across, along["time"].values)
    inertial = np.abs(rate) * d * np.sqrt(density / along["p"].values)
    assert np.allclose(along["inertial_number"].values[1:-1], inertial[1:-1], rtol=1e-6)
    assert found["inertial_number"].values[0] == found["inertial_number"].values[1] > 0
    assert 0 < found["mu"].values[0] < 2 and found["mu"].values[0] <= np.nanmax(along["q_over_p"].values)
    states = flows.critical_states([pressed], "axial")
    told = pressed.spheres[-1].numbers
    if "critical_state" in told:  # as `show` has it
        assert states["mu"].values[0] == told["critical_state"]["q_over_p"]["value"]
    assert states["reached"].values[0] == ("critical_state" in told)
    assert states["friction"].values == [pressed.spheres[-1].asked["friction"]]
    with pytest.raises(ValueError, match="no silo of disks"):
        flows.silos([pressed])


def test_a_comparison_of_spheres_has_their_figures(pressed):
    shown = {one["id"]: one["drawing"] for one in _compare_page.figures(compare.pairs_of(pressed, pressed))}
    assert {"test-curves", "forces"} <= set(shown), list(shown)
    ratio = shown["test-curves"]["panels"][0]
    assert {series["name"] for series in ratio["series"]} == {"A", "B"} and ratio["y"]["brief"] == "q/p"

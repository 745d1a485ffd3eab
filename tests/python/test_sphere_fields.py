"""Coarse-grained fields of spheres: those on the page are those that are exported, and print draws them too."""

import numpy as np
import pytest
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOXML import vtkXMLImageDataReader

import arenite
from arenite import _core, figures
from arenite.figures import samples, slices
from test_pages import content_of
from test_spheres import RECIPE

STAGE = """
[[stages]]
name = "axial"
top = { velocity = "0.1 m/s" }
right = { pressure = "10 kPa" }
front = { pressure = "10 kPa" }
duration = "0.02 s"
snapshots = 3
"""


@pytest.fixture(scope="module")
def pressed(tmp_path_factory):
    """Some spheres in a periodic cell, and the same while they are pressed along y."""
    folder = tmp_path_factory.mktemp("fields")
    (folder / "recipe.toml").write_text(RECIPE + STAGE)
    result = arenite.run(arenite.Recipe(folder / "recipe.toml"), folder / "out")
    arenite.page(result, folder / "page.html")
    return folder, result, content_of(folder / "page.html")["spheres"]


def decoded(coded, width):
    """Codes of a field, each less the median of its neighbours to the left and below and their plane; and how far the
    values may be from those that were coded."""
    residual = coded["residual"].astype(np.int64)
    off = (residual >> 1) ^ -(residual & 1)
    code = np.zeros(len(off), np.int64)
    for k in range(len(off)):
        x = k % width
        left, below = code[k - 1] if x else None, code[k - width] if k >= width else None
        if left is None or below is None:
            guess = next((one for one in (left, below) if one is not None), 0)
        else:
            guess = sorted((left, below, left + below - code[k - width - 1]))[1]
        code[k] = guess + off[k]
    place = np.sinh(code / coded["levels"])
    assert coded["law"] == "sinh"
    return coded["centre"] + coded["width"] * place, 0.5 / coded["levels"] * coded["width"] * np.hypot(1, place)


def exported(file):
    """{name: values} of an image, and its lowest corner, spacing and numbers of points, by VTK itself."""
    reader = vtkXMLImageDataReader()
    reader.SetFileName(str(file))
    reader.Update()
    image = reader.GetOutput()
    points = image.GetPointData()
    arrays = {points.GetArrayName(k): vtk_to_numpy(points.GetArray(k)) for k in range(points.GetNumberOfArrays())}
    return arrays, np.array(image.GetOrigin()), np.array(image.GetSpacing()), image.GetDimensions()


def test_the_pages_fields_of_a_state_are_those_that_are_exported(pressed, tmp_path):
    _, result, stages = pressed
    for stage, shown in zip(result.spheres, stages, strict=True):
        if stage.name == "packing":
            continue
        arenite.export(arenite.Result(spheres=[stage]), tmp_path / stage.name, "fields")
        last = sorted((tmp_path / stage.name).glob("fields_*.vti"))[-1]
        arrays, origin, spacing, cells = exported(last)
        fields = shown["states"][-1]["fields"]
        low, high = (np.array(fields[end]) for end in ("low", "high"))
        assert fields["cells"] == list(cells) and max(cells) > 6
        assert np.allclose(origin, low + 0.5 * spacing) and np.allclose(high - low, spacing * cells)
        assert fields["width"] == pytest.approx(4e-3)  # a diameter
        xx, yy, zz, xy, yz, xz = arrays["stress"].T
        deviator = np.sqrt(0.5 * ((xx - yy) ** 2 + (yy - zz) ** 2 + (zz - xx) ** 2) + 3 * (xy**2 + yz**2 + xz**2))
        expected = {
            "solid_fraction": arrays["solid_fraction"],
            "density": arrays["density"],
            "pressure": -(xx + yy + zz) / 3,
            "deviator": deviator,
            "shear": xy,
            "shear_yz": yz,
            "shear_xz": xz,
            "vx": arrays["velocity"][:, 0],
            "vy": arrays["velocity"][:, 1],
            "vz": arrays["velocity"][:, 2],
            "kinetic": arrays["kinetic_pressure"],
        }
        assert set(fields["layers"]) == set(expected)
        for name, values in expected.items():
            found, step = decoded(fields["layers"][name], cells[0])
            rounding = 1e-6 * np.abs(values).max()
            assert (np.abs(found - values) <= 1.001 * step + rounding).all(), name
            assert np.ptp(values) > 20 * np.median(step), f"{name} is more than its steps"


def test_density_by_volume_is_the_mass_in_every_state(pressed):
    _, result, stages = pressed
    mass = 120 * 2500 * 4 / 3 * np.pi * 2e-3**3
    states = stages[-1]["states"]
    assert len(states) == 3 and all("fields" in state for state in states)
    for state in states:
        fields = state["fields"]
        assert fields["cells"] == states[-1]["fields"]["cells"]
        density, step = decoded(fields["layers"]["density"], fields["cells"][0])
        volume = np.prod(np.subtract(fields["high"], fields["low"])) / np.prod(fields["cells"])
        # On points a seventh of the kernel's radius apart the sum of the smooth function is its integral to 1e-4;
        # rounding to steps is as often up as down, and five deviations of its mean are none.
        rounding = 5 * np.sqrt((step**2).sum() / 3) * volume
        assert density.sum() * volume == pytest.approx(mass, abs=1e-4 * mass + rounding)
        assert rounding < 2e-3 * mass


def test_the_page_says_of_fields_in_space_what_it_says_of_those_of_the_plane(pressed):
    plane, space = _core._coarse_layers(), pressed[2][-1]["layers"]
    assert space == _core._coarse_layers_in_space()
    assert set(plane) < set(space)
    for name in set(plane) - {"speed", "shear"}:
        assert space[name] == plane[name]
    assert space["speed"][:3] == plane["speed"][:3] and space["shear"][1:3] == plane["shear"][1:3]
    assert len({words for words, *_ in space.values()}) == len(space), "a list of names tells them apart"


def test_print_draws_slices_of_the_fields_of_the_last_state(pressed):
    _, result, _ = pressed
    stage = result.spheres[-1]
    (figure,) = [
        figure for figure, part in figures.figures_of(result) if figure.name == "coarse-fields" and part is stage
    ]
    canvas = figures.catalogue.Canvas(figsize=(6, 6))
    figure.draw(canvas, stage)
    pictures = [axes.images[0] for axes in canvas.axes if axes.images]
    fields = _core._layers_of_state(stage, stage.snapshots[-1])
    whole = arenite.coarse_grained(stage.snapshots[-1].packing, "4 mm", "2 mm", tilt_rate=0)
    assert np.allclose(fields["solid_fraction"], whole["solid_fraction"]) and fields["speed"].ndim == 3
    assert len(pictures) == 4 * len(slices.planes["y"])
    for picture, (normal, right, _) in zip(pictures, slices.planes["y"]):
        middle = fields["solid_fraction"].shape[slices.place_in_array[normal]] // 2
        cut = np.take(fields["solid_fraction"], middle, axis=slices.place_in_array[normal])
        assert np.allclose(picture.get_array(), cut.T if right == "z" else cut)
    labels = [axes.get_ylabel() for axes in canvas.axes]
    assert any("Shear stress xy" in words for words in labels) and any("Velocity" in words for words in labels)
    still = result.spheres[0]  # spheres just placed, of which two fields are drawn
    assert samples.slices_height(still) < 0.6 * samples.slices_height(stage)

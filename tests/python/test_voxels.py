"""Samples in space from arrays and files."""

import pathlib
import struct

import numpy as np
import pytest

import arenite
from arenite import _core, compare, figures
from arenite.figures import catalogue, drawing, saving, slices, volumes


def layers():
    z, y, x = np.mgrid[0:10, 0:12, 0:14]
    return np.where(z < 5, 1, 2), np.where(z < 5, -1, 0)


def test_layers_in_series_have_the_harmonic_modulus():
    phase, grain = layers()
    sample = arenite.VoxelMap(phase, grain, dx="10 um")
    assert (sample.width, sample.height, sample.depth) == (14, 12, 10)
    assert np.array_equal(sample.phase, phase) and np.array_equal(sample.grain, grain)
    result = arenite.load_voxels(
        sample, method="elements", matrix="1 GPa", interface="1 GPa", particle="4 GPa", matrix_poisson=0, tolerance=1e-8
    )
    assert result.converged, result.outcome
    assert result.numbers["modulus_Pa"] == pytest.approx(1e9 / (0.5 + 0.5 / 4), rel=1e-6)
    assert result.sigma_zz.shape == (10, 12, 14)
    assert np.allclose(result.sigma_zz, 1.6e5, rtol=1e-5)
    assert np.all(np.diff(result.u_z, axis=0) > 0)
    assert result.convergence["residual"][0] > 1e-8 >= result.convergence["residual"][-1]
    assert len(result.convergence["iteration"]) == result.numbers["load"]["iterations"] + 1


def test_the_effective_stiffness_is_symmetric_and_between_its_bounds():
    rng = np.random.default_rng(1)
    sample = arenite.VoxelMap(rng.integers(1, 3, (12, 12, 12)), dx=1e-5)
    result = arenite.load_voxels(sample, method="elements", particle="20 GPa", effective_stiffness=True)
    assert result.converged
    effective = result.numbers["effective_stiffness"]
    stiffness = np.array(effective["stiffness_Pa"])
    assert np.allclose(stiffness, stiffness.T, atol=1e-4 * stiffness[0, 0])
    bounds, mean = effective["bounds_Pa"], effective["isotropic_mean_Pa"]
    for modulus in ("bulk", "shear"):
        assert (
            bounds["hashin_shtrikman_lower"][modulus] < mean[modulus] < bounds["hashin_shtrikman_upper"][modulus]
        ), modulus


def test_files_are_read_as_arrays_are_given(tmp_path):
    phase, _ = layers()
    np.savez_compressed(tmp_path / "sample.npz", im=phase.astype(np.uint8), other=np.arange(3))
    read = arenite.read_voxel_map(tmp_path / "sample.npz", dx="5 um", phases={1: "matrix", 2: "particle"})
    assert np.array_equal(read.phase, phase) and read.dx == 5e-6
    assert read.grain.max() == 0


def test_what_is_of_the_plane_is_refused():
    sample = arenite.VoxelMap(np.ones((4, 4, 4), int), dx=1)
    with pytest.raises(ValueError, match="dynamic solvers"):
        arenite.load_voxels(sample, method="relaxation")
    with pytest.raises(ValueError, match="shape"):
        arenite.VoxelMap(np.ones((4, 4, 4), int), np.zeros((4, 4, 5), int), dx=1)


def test_results_are_kept_and_opened_again(tmp_path):
    phase, grain = layers()
    result = arenite.load_voxels(arenite.VoxelMap(phase, grain, dx="10 um"), method="elements", matrix_poisson=0)
    files = arenite.save(result, tmp_path / "kept")
    (kept,) = arenite.open(tmp_path / "kept").voxels
    assert len(files) == 1 and kept.converged
    assert np.array_equal(kept.sigma_zz, result.sigma_zz) and np.array_equal(kept.map.phase, phase)
    assert arenite.open(files[0]).numbers["modulus_Pa"] == result.numbers["modulus_Pa"]
    arenite.page(result, tmp_path / "page.html")
    assert (tmp_path / "page.html").stat().st_size > 100_000
    (image,) = arenite.export(result, tmp_path / "vtk")
    assert str(image).endswith(".vti")
    exported = map(pathlib.Path, arenite.export(result, tmp_path / "npy", "npy"))
    arrays = {file.stem.split("_", 1)[1]: np.load(file) for file in exported}
    assert np.array_equal(arrays["phase"], phase) and np.array_equal(arrays["grain"], grain)
    assert np.array_equal(arrays["sigma_zz"], result.sigma_zz) and np.array_equal(arrays["ux"], result.u_x)


def test_touching_grains_of_a_file_are_parted_by_watershed(tmp_path):
    z, y, x = np.mgrid[0:20, 0:20, 0:40]
    balls = sum((x - a) ** 2 + (y - 9.5) ** 2 + (z - 9.5) ** 2 < 81 for a in (9.5, 24.5, 39.5)) > 0
    np.save(tmp_path / "balls.npy", balls.astype(np.uint8))

    def read(**options):
        return arenite.read_voxel_map(tmp_path / "balls.npy", dx="1 um", **options).grain

    assert read().max() == 0
    grain = read(labels="watershed")
    assert grain.max() == 2 and np.array_equal(grain >= 0, balls)
    for a, b in ((0, 17), (18, 32), (33, 40)):
        assert len(np.unique(grain[:, :, a:b][balls[:, :, a:b]])) == 1
    assert read(labels="watershed", smoothing=8).max() == 0


def sheared(loading="tension", dx="10 um", **options):
    rng = np.random.default_rng(3)
    sample = arenite.VoxelMap(rng.integers(0, 3, (14, 12, 16)).clip(1), dx=dx)
    return arenite.load_voxels(sample, loading, method="elements", particle="5 GPa", **options)


def test_slices_of_phases_and_stresses_are_printed(tmp_path):
    result = sheared()
    arenite.save(result, tmp_path / "kept")
    saved = {path.stem: path for path in catalogue.save_all(tmp_path / "kept", tmp_path, "svg")}
    assert {"tension-phases", "tension-stress", "tension-displacement", "tension-stress-pdf"} <= set(saved)
    text = saved["tension-stress"].read_text()
    # A slice across each axis with its place, in its own directions.
    for name in ("z = 75 µm: x", "y = 65 µm: x", "x = 85 µm: y"):
        assert name in text, name


def test_pictures_show_the_middle_of_the_voxels_over_their_mean():
    result, canvas = sheared("shear"), saving.Canvas()
    assert _core._quantities_drawn(result) == ["sigma_xz", "sigma_hyd", "sigma_mises"]
    volumes.draw_component(canvas, result, "sigma_xz", slices.rows_of(canvas, volumes.box_of(result.map), 1)[0])
    across_z, across_y, across_x = (axes.images[0] for axes in canvas.axes[:3])
    mean = result.numbers["stress"]["sigma_xz"]["sample_mean_Pa"]["value"]
    assert _core._voxel_mean(result, "sigma_xz") == mean
    shown = result.sigma_xz.astype(float) / mean
    assert np.allclose(across_z.get_array(), shown[7]) and np.allclose(across_y.get_array(), shown[:, 6])
    assert np.allclose(across_x.get_array(), shown[:, :, 8])
    assert len({picture.get_clim() for picture in (across_z, across_y, across_x)}) == 1
    values = _core._voxel_values(result, "sigma_mises")
    xx, yy, zz = (getattr(result, f"sigma_{name}").astype(float) for name in ("xx", "yy", "zz"))
    shears = sum(getattr(result, f"sigma_{name}").astype(float) ** 2 for name in ("yz", "xz", "xy"))
    assert np.allclose(values**2, ((xx - yy) ** 2 + (yy - zz) ** 2 + (zz - xx) ** 2) / 2 + 3 * shears)


def test_print_draws_what_the_page_shows_and_compares_it(tmp_path):
    phase, grain = layers()
    paths = []
    for name, stiffness in (("soft", "2 GPa"), ("stiff", "4 GPa")):
        sample = arenite.VoxelMap(phase, grain, dx="10 um")
        paths.append(tmp_path / name)
        arenite.save(arenite.load_voxels(sample, method="elements", particle=stiffness), paths[-1])
    drawn = figures.save_all(paths[0], tmp_path / "drawn", formats="svg")
    (volume,) = arenite.open(paths[0]).voxels
    names = {path.stem.removeprefix(f"{volume.name}-") for path in drawn}
    described = {head["name"] for head in drawing.heads()["voxels"] if drawing.describe(volume).get(head["id"])}
    assert {"phases", "stress"} <= names and described
    assert all(any(name.startswith(one) for name in names) for one in described), (names, described)
    modulus = next(row for row in compare.rows(*paths) if row.name == "modulus_Pa")
    assert modulus.part == volume.name and 0 < modulus.a < modulus.b
    compare.save_page(*paths, tmp_path / "cmp.html")
    assert "stress" in (tmp_path / "cmp.html").read_text()


def test_a_sample_in_space_breaks_and_python_has_its_cracks():
    phase = np.ones((20, 6, 10), np.uint8)
    phase[9:11, :, :6] = 0
    result = arenite.load_voxels(arenite.VoxelMap(phase, dx="1 mm"), failure=True)
    curve, cracks, damage = result.curve, result.cracks, result.damage
    assert result.converged and result.curve_units["work"] == "J"
    assert result.numbers["strength_Pa"] == pytest.approx(curve["stress"].max())
    assert len(cracks["x"]) == curve["broken"][-1] == sum(result.numbers["failure"]["broken"].values())
    assert damage.shape == phase.shape and 0 < damage.max() <= 1 and not damage[phase == 0].any()
    assert abs(np.average(cracks["z"]) - 0.010) < 0.002
    steps = np.stack([cracks[name] for name in ("along_x", "along_y", "along_z")])
    assert set((steps**2).sum(axis=0)) <= {1, 2, 3, 4}
    balance = curve["work"] - curve["elastic"] - curve["released"]
    assert np.abs(balance).max() < 1e-4 * curve["work"].max()


def pages_of_bits(planes):
    """A TIFF of one bit per pixel, a page a plane, as programs store pictures of two values."""
    file, link = bytearray(b"II*\0\0\0\0\0"), 4
    for plane in planes:
        rows = np.packbits(plane.astype(bool), axis=1).tobytes()
        place = len(file)
        file += rows
        struct.pack_into("<I", file, link, len(file))
        height, width = plane.shape
        fields = [(256, width), (257, height), (258, 1), (259, 1), (262, 1), (277, 1), (278, height)]
        entries = [(tag, 3, value) for tag, value in fields[:5]] + [(273, 4, place)]
        entries += [(tag, 3, value) for tag, value in fields[5:]] + [(279, 4, len(rows))]
        file += struct.pack("<H", len(entries))
        for tag, kind, value in entries:
            file += struct.pack("<HHII", tag, kind, 1, value)
        link = len(file)
        file += bytes(4)
    return bytes(file)


def test_a_stack_of_one_bit_per_pixel_is_read(tmp_path):
    solid = np.random.default_rng(1).random((5, 7, 11)) < 0.6
    (tmp_path / "scan.tif").write_bytes(pages_of_bits(solid))
    found = arenite.read_voxel_map(tmp_path / "scan.tif", phases={0: "void", 1: "matrix"}, dx="1 um")
    assert np.array_equal(found.phase, solid)

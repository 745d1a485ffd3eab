"""What files of other programs state of lengths, of voxels and of spheres: used, refused or told."""

import json
import warnings

import h5py
import numpy as np
import pytest
from PIL import Image, TiffImagePlugin

import arenite

PHASE = (np.indices((4, 5, 6)).sum(axis=0) % 2 + 1).astype(np.uint8)
PHASES = {1: "matrix", 2: "particle"}


def read(path, **more):
    """The voxel map, and what was told of its file."""
    with warnings.catch_warnings(record=True) as told:
        warnings.simplefilter("always")
        found = arenite.read_voxel_map(path, phases=PHASES, labels="none", **more)
    assert np.array_equal(found.phase, PHASE)
    return found, " ".join(str(w.message) for w in told)


def hdf5(path, values=PHASE, **attributes):
    with h5py.File(path, "w") as file:
        file["exported_data"] = values
        file["exported_data"].attrs.update(attributes)
    return path


@pytest.mark.parametrize(
    "name, size, side",
    [("element_size_um", [2.5] * 3, 2.5e-6), ("voxel_size_nm", [40.0] * 3, 40e-9), ("spacing_mm", 0.254, 254e-6)],
)
def test_an_attribute_of_hdf5_with_its_unit_is_the_side_of_a_voxel(tmp_path, name, size, side):
    found, told = read(hdf5(tmp_path / "a.h5", **{name: size}))
    assert found.has_length and found.dx == pytest.approx(side) and name in told


def test_what_hdf5_states_beside_cubes_and_units_is_refused_or_told(tmp_path):
    long = hdf5(tmp_path / "long.h5", element_size_um=[5.0, 2.5, 2.5])
    with pytest.raises(ValueError, match="pixels of 2.5 um and pictures 5 um apart, so that its voxels are no cubes"):
        read(long)
    assert read(long, dx="3 um")[0].dx == pytest.approx(3e-6)
    with pytest.raises(ValueError, match="no squares"):
        read(hdf5(tmp_path / "wide.h5", element_size_um=[2.5, 2.5, 5.0]))
    found, told = read(hdf5(tmp_path / "bare.h5", spacing=[2.5] * 3))
    assert not found.has_length and "spacing without a known unit" in told
    found, told = read(hdf5(tmp_path / "none.h5"))
    assert not found.has_length and "spacing" not in told


def test_a_recipe_that_gives_the_side_of_voxels_takes_what_states_no_cubes(tmp_path):
    hdf5(tmp_path / "long.h5", element_size_um=[5.0, 2.5, 2.5])
    text = """
    map = { file = "long.h5", dimension = 3, phases = "1=matrix,2=particle", labels = "none", SIDE }
    [[loads]]
    name = "pull"
    method = "elements"
    """
    (tmp_path / "given.toml").write_text(text.replace("SIDE", 'dx = "3 um"'))
    pulled = arenite.run(arenite.Recipe(tmp_path / "given.toml"), tmp_path / "out").voxels[-1]
    assert pulled.numbers["map"]["dx_m"] == pytest.approx(3e-6)
    (tmp_path / "stated.toml").write_text(text.replace(", SIDE", ""))
    with pytest.raises(ValueError, match="no cubes"):
        arenite.run(arenite.Recipe(tmp_path / "stated.toml"), tmp_path / "other")


def test_a_side_that_is_given_counts_and_another_in_the_file_is_told(tmp_path):
    path = hdf5(tmp_path / "a.h5", element_size_um=[2.5] * 3)
    found, told = read(path, dx="4 um")
    assert found.dx == pytest.approx(4e-6) and "states voxels of 2.5 um" in told and "given, 4 um, is used" in told
    assert "states" not in read(path, dx="2.5 um")[1]


def test_axes_of_ilastik_are_known_by_their_tags(tmp_path):
    tags = json.dumps({"axes": [{"key": key, "typeFlags": 2, "resolution": 0, "description": ""} for key in "xyz"]})
    found, told = read(hdf5(tmp_path / "a.h5", PHASE.T, axistags=tags, element_size_um=[2.0] * 3))
    assert found.dx == pytest.approx(2e-6) and "turned" in told


@pytest.mark.parametrize("unit", ["um", "micron", "micrometer"])
def test_coordinates_of_xarray_are_the_sides_of_voxels(tmp_path, unit):
    xarray = pytest.importorskip("xarray")
    places = {axis: (axis, 7 + 1.5 * np.arange(n)[::-1], {"units": unit}) for axis, n in zip("zyx", PHASE.shape)}
    data = xarray.DataArray(PHASE, dims=list("zyx"), coords=places, name="phase")
    data.to_netcdf(tmp_path / "even.nc", engine="h5netcdf")
    found, told = read(tmp_path / "even.nc")
    assert found.dx == pytest.approx(1.5e-6) and "coordinates" in told
    bent = data.assign_coords(z=("z", [0.0, 1, 2, 4], {"units": unit}))
    bent.to_netcdf(tmp_path / "uneven.nc", engine="h5netcdf")
    assert not read(tmp_path / "uneven.nc")[0].has_length


def test_a_stack_of_tiff_that_states_all_three_sides_needs_no_other(tmp_path):
    def stack(description, **more):
        info = TiffImagePlugin.ImageFileDirectory_v2()
        info[270] = description
        first, *others = [Image.fromarray(layer) for layer in PHASE]
        first.save(tmp_path / "a.tif", save_all=True, append_images=others, tiffinfo=info, **more)
        return tmp_path / "a.tif"

    ome = (
        "<OME><Pixels PhysicalSizeX='{0}' PhysicalSizeY='{0}' PhysicalSizeZ='{1}' SizeC='1' SizeZ='4' SizeT='1'"
        " DimensionOrder='XYZCT'/></OME>"
    ).replace("'", '"')
    found, told = read(stack(ome.format(0.5, 0.5)))
    assert found.dx == pytest.approx(0.5e-6) and "taken as the side of a voxel" in told
    with pytest.raises(ValueError, match="no cubes"):
        read(stack(ome.format(0.5, 2)))
    assert "states voxels of 0.5 um" in read(stack(ome.format(0.5, 0.5)), dx="1 um")[1]
    found, told = read(stack("ImageJ=1.53t\nimages=4\nslices=4\nunit=um\nspacing=0.5\n", resolution=2.0))
    assert found.dx == pytest.approx(0.5e-6)
    found, told = read(stack("a scan", resolution=2540.0, resolution_unit="cm"))
    assert not found.has_length and "states pixels of 3.937" in told  # a pixel alone makes no cube


def test_slices_whose_numbers_rise_by_two_are_told(tmp_path):
    for step in (1, 2):
        folder = tmp_path / f"by{step}"
        folder.mkdir()
        for k, layer in enumerate(PHASE):
            Image.fromarray(layer).save(folder / f"slice_{step * k:03}.tif")
        assert ("rise by 2" in read(folder)[1]) == (step == 2)


def test_units_in_the_headers_of_images_are_those_of_their_voxels(tmp_path):
    def meta(name, *lines, numbers=PHASE.tobytes()):
        size = " ".join(map(str, PHASE.shape[::-1]))
        head = ["ObjectType = Image", "NDims = 3", f"DimSize = {size}", "ElementType = MET_UCHAR", *lines]
        (tmp_path / name).write_bytes("\n".join([*head, "ElementDataFile = LOCAL\n"]).encode() + numbers)
        return tmp_path / name

    found, told = read(meta("um.mha", "ElementSpacing = 2 2 2", "DistanceUnits = um"))
    assert found.dx == pytest.approx(2e-6) and "ITK" not in told
    found, told = read(meta("mm.mha", "ElementSpacing = 2 2 2"))
    assert found.dx == pytest.approx(2e-3) and "taken in mm, as ITK does" in told
    with pytest.raises(ValueError, match="numbers as text .BinaryData = False."):
        read(meta("text.mha", "BinaryData = False", numbers=b"1 2 1"))

    size = " ".join(map(str, PHASE.shape[::-1]))
    for field, more in (("spacings: 2 2 2", "units"), ("spacings: 2 2 2", "space units")):
        head = ["NRRD0004", "type: uint8", "dimension: 3", f"sizes: {size}", "encoding: raw", field]
        head.append(f'{more}: "um" "um" "um"')
        (tmp_path / "a.nrrd").write_bytes("\n".join(head).encode() + b"\n\n" + PHASE.tobytes())
        assert read(tmp_path / "a.nrrd")[0].dx == pytest.approx(2e-6)


@pytest.mark.parametrize("kind, ending", [("vtkMetaImageWriter", "mha"), ("vtkNIFTIImageWriter", "nii")])
def test_spacings_that_vtk_writes_are_sides_where_they_have_a_unit(tmp_path, kind, ending):
    vtk = pytest.importorskip("vtk")
    numpy_support = pytest.importorskip("vtk.util.numpy_support")

    def written(name, spacing):
        image = vtk.vtkImageData()
        image.SetDimensions(*PHASE.shape[::-1])
        image.SetSpacing(*spacing)
        image.GetPointData().SetScalars(numpy_support.numpy_to_vtk(PHASE.ravel(), deep=True))
        writer = getattr(vtk, kind)()
        writer.SetInputData(image)
        writer.SetFileName(str(tmp_path / f"{name}.{ending}"))
        writer.Write()
        return tmp_path / f"{name}.{ending}"

    even = written("even", (0.02, 0.02, 0.02))
    found, told = read(even)
    given, told_of_given = read(even, dx="30 um")
    assert given.dx == pytest.approx(30e-6)
    if ending == "nii":  # VTK writes no unit into it
        assert not found.has_length and "0.02 without a unit" in told and "0.02" not in told_of_given
    else:
        assert found.dx == pytest.approx(20e-6) and "in mm, as ITK does" in told
        assert "states voxels of 20 um" in told_of_given and "as ITK does" not in told_of_given
    with pytest.raises(ValueError, match="no cubes"):
        read(written("long", (0.02, 0.02, 0.03)))


def test_what_lies_beside_a_volume_of_numpy_is_told(tmp_path):
    np.savez(tmp_path / "a.npz", phase=PHASE, voxel_size=np.array(2.5e-6))
    found, told = read(tmp_path / "a.npz")
    assert not found.has_length and "beside its volume it holds voxel_size, which is left aside" in told


def test_a_picture_of_hdf5_tells_the_side_of_its_pixels(tmp_path):
    def told(**more):
        with pytest.warns(arenite.FileWarning) as found:
            arenite.read_phase_map(tmp_path / "a.h5", phases=PHASES, labels="none", **more)
        return " ".join(str(w.message) for w in found)

    hdf5(tmp_path / "a.h5", PHASE[0], element_size_um=[9.0, 2.5, 2.5])
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        arenite.read_phase_map(tmp_path / "a.h5", phases=PHASES, labels="none", dx="2.5 um")
    assert "states pixels of 2.5 um" in told(dx="5 um")


BALLS = np.indices((2, 2, 3)).reshape(3, -1).T * 1.0


def spheres(path, **more):
    with warnings.catch_warnings(record=True) as told:
        warnings.simplefilter("always")
        return arenite.read_packing(path, dimension="3", **more), " ".join(str(w.message) for w in told)


@pytest.mark.parametrize("comment", ["# units: mm, N", "% Unit = mm", '# length unit: "mm"', "# a title\n# units: mm"])
def test_a_unit_in_a_comment_above_a_table_is_that_of_its_lengths(tmp_path, comment):
    rows = "".join(f"{x},{y},{z},0.5\n" for x, y, z in BALLS)
    (tmp_path / "a.csv").write_text(comment + "\nx,y,z,radius\n" + rows)
    packing, told = spheres(tmp_path / "a.csv")
    assert np.allclose(packing.radius, 0.5e-3) and "assumed" not in told
    (tmp_path / "b.csv").write_text(comment + "\nx [um],y [um],z [um],radius [um]\n" + rows)
    assert np.allclose(spheres(tmp_path / "a.csv", length_unit="um")[0].radius, 0.5e-6)
    assert np.allclose(spheres(tmp_path / "b.csv")[0].radius, 0.5e-6)  # what a column says is of that column


def test_a_unit_that_is_none_of_length_leaves_metres_and_says_so(tmp_path):
    rows = "".join(f"{x},{y},{z},0.5\n" for x, y, z in BALLS)
    (tmp_path / "a.csv").write_text("# units: lj\nx,y,z,radius\n" + rows)
    packing, told = spheres(tmp_path / "a.csv")
    assert np.allclose(packing.radius, 0.5) and "m was assumed" in told


def test_a_unit_that_ase_writes_beside_the_cell_is_that_of_lengths(tmp_path):
    ase = pytest.importorskip("ase.io")
    atoms = pytest.importorskip("ase").Atoms("X12", positions=BALLS, cell=[2, 2, 3], pbc=True)
    atoms.arrays["radius"] = np.full(12, 0.5)
    atoms.info["units"] = "mm"
    ase.write(tmp_path / "a.xyz", atoms, format="extxyz")
    packing, told = spheres(tmp_path / "a.xyz")
    assert np.allclose(packing.radius, 0.5e-3) and np.allclose(packing.domain["size"], [2e-3, 2e-3, 3e-3])
    assert "assumed" not in told
    assert np.allclose(spheres(tmp_path / "a.xyz", length_unit="um")[0].radius, 0.5e-6)

"""Reads an exported loading with VTK itself and compares it with the stage file read by h5py."""
import math
import os
import sys
import xml.etree.ElementTree as ElementTree

import h5py
import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkCompositeDataSet
from vtkmodules.vtkIOXML import vtkXMLMultiBlockDataReader, vtkXMLPolyDataReader

stage_file, folder = sys.argv[1:3]


def read(name):
    reader = vtkXMLPolyDataReader()
    reader.SetFileName(os.path.join(folder, name))
    reader.Update()
    assert reader.GetErrorCode() == 0, name
    return reader.GetOutput()


def check_blocks(name):
    """The state as ParaView opens it: three blocks by name."""
    reader = vtkXMLMultiBlockDataReader()
    reader.SetFileName(os.path.join(folder, name))
    reader.Update()
    blocks = reader.GetOutput()
    assert reader.GetErrorCode() == 0 and blocks.GetNumberOfBlocks() == 3
    for k, part in enumerate(("grains", "contacts", "walls")):
        assert blocks.GetMetaData(k).Get(vtkCompositeDataSet.NAME()) == part
        assert blocks.GetBlock(k).GetNumberOfPoints() > 0


def arrays(attributes):
    return {
        attributes.GetArrayName(k): vtk_to_numpy(attributes.GetArray(k)) for k in range(attributes.GetNumberOfArrays())
    }


def same(a, b):
    np.testing.assert_array_equal(np.asarray(a), np.asarray(b))


def check_grains(data, frame, sample, time, first):
    fields = arrays(data.GetPointData())
    points = vtk_to_numpy(data.GetPoints().GetData())
    same(points[:, 0], frame["grains/x"])
    same(points[:, 1], frame["grains/y"])
    same(points[:, 2], np.zeros(len(points)))
    for name in ("id", "radius", "material", "zone"):
        same(fields[name], sample[name])
    same(fields["velocity"], np.column_stack([frame["grains/vx"], frame["grains/vy"], np.zeros(len(points))]))
    same(fields["angle"], frame["grains/angle"])
    same(fields["omega"], frame["grains/omega"])
    assert data.GetNumberOfVerts() == len(points)
    assert {"stress", "contacts", "rattler", "sigma_norm", "sigma_hyd", "sigma_xx", "sigma_yy", "psi6"} <= set(fields)
    np.testing.assert_allclose(fields["sigma_hyd"], (fields["sigma_xx"] + fields["sigma_yy"]) / 2, rtol=1e-12)
    assert vtk_to_numpy(data.GetFieldData().GetArray("TimeValue"))[0] == time
    stress = fields["stress"].reshape(-1, 3, 3)
    for k, name in ((0, "sigma_xx"), (1, "sigma_xy"), (3, "sigma_yx"), (4, "sigma_yy")):
        same(stress.reshape(-1, 9)[:, k], fields[name])
    same(stress[:, 2], np.zeros((len(points), 3)))
    if first is None:
        assert "displacement" not in fields
    else:
        np.testing.assert_allclose(fields["displacement"], points - first, atol=1e-15)
    return points


def check_contacts(data, frame, sample):
    fields = arrays(data.GetCellData())
    contacts = frame["contacts"]
    n = len(contacts["i"])
    assert data.GetNumberOfLines() == n and data.GetNumberOfPoints() == 2 * n
    for name in ("fn", "ft", "nx", "ny", "arm_i", "overlap", "sliding_velocity", "glued"):
        same(fields[name], contacts[name])
    i, j = contacts["i"][:], contacts["j"][:]
    pairs = j >= 0
    nx, ny, fn, ft = (contacts[name][:] for name in ("nx", "ny", "fn", "ft"))
    np.testing.assert_allclose(
        fields["force"], np.column_stack([fn * nx - ft * ny, fn * ny + ft * nx, 0 * fn]), rtol=1e-14, atol=1e-12
    )
    same(fields["i"], sample["id"][:][i])
    same(fields["j"], np.where(pairs, sample["id"][:][np.maximum(j, 0)], j))
    mean = contacts["fn"][:][pairs & (contacts["fn"][:] > 0)].mean()
    same(fields["strong"], contacts["fn"][:] > mean)
    assert 0 < fields["strong"].sum() < n
    material = sample["material"][:]
    same(fields["type"], [-1 if b < 0 else material[a] + material[b] for a, b in zip(i, j)])  # two materials: 0, 1, 2
    ends = vtk_to_numpy(data.GetPoints().GetData()).reshape(n, 2, 3)
    x, y = frame["grains/x"][:], frame["grains/y"][:]
    same(ends[:, 0, 0], x[i])
    same(ends[:, 0, 1], y[i])
    np.testing.assert_allclose(ends[pairs, 1, 0], x[j[pairs]], rtol=1e-14)
    np.testing.assert_allclose(ends[~pairs, 1, 1], y[i[~pairs]] - contacts["arm_i"][:][~pairs], atol=1e-17)
    same(vtk_to_numpy(data.GetPointData().GetArray("fn")).reshape(n, 2)[:, 1], contacts["fn"])


def check_walls(data, frame):
    fields = arrays(data.GetCellData())
    walls = [frame["domain"][side].attrs for side in ("left", "right", "bottom", "top")]
    assert data.GetNumberOfLines() == 4
    same(fields["force"], [w["force [N]"] for w in walls])
    same(fields["shear_force"], [w["shear_force [N]"] for w in walls])
    same(fields["present"], [w["present"] for w in walls])
    assert data.GetBounds()[:4] == tuple(w["position [m]"] for w in walls)


with h5py.File(stage_file) as file:
    times = [frame.attrs["time [s]"] for frame in file["frames"].values()]
    listed = [
        (float(d.get("timestep")), d.get("file"))
        for d in ElementTree.parse(os.path.join(folder, "loading.pvd")).iter("DataSet")
    ]
    assert [t for t, _ in listed] == times, listed
    for _, name in listed:
        check_blocks(name)
    first = None
    for name in ("grains", "contacts", "walls"):
        alone = [
            (float(d.get("timestep")), d.get("file"))
            for d in ElementTree.parse(os.path.join(folder, name + ".pvd")).iter("DataSet")
        ]
        assert alone == [(t, f"{name}_{k:04}.vtp") for k, t in enumerate(times)]
        for (time, path), frame in zip(alone, file["frames"].values()):
            assert math.isclose(time, frame.attrs["time [s]"], rel_tol=0, abs_tol=0)
            data = read(path)
            if name == "grains":
                points = check_grains(data, frame, file["grains"], time, first)
                first = points if first is None else first
            elif name == "contacts":
                check_contacts(data, frame, file["grains"])
            else:
                check_walls(data, frame)
print("checked", len(times), "states")

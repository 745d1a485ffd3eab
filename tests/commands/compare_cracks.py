"""Reads exported cracks with VTK itself and compares them with the field file read by h5py."""
import sys

import h5py
import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader

field_file, exported = sys.argv[1:3]
reader = vtkXMLPolyDataReader()
reader.SetFileName(exported)
reader.Update()
assert reader.GetErrorCode() == 0
data = reader.GetOutput()
points = data.GetPointData()
arrays = {points.GetArrayName(k): vtk_to_numpy(points.GetArray(k)) for k in range(points.GetNumberOfArrays())}
with h5py.File(field_file) as file:
    cracks = file["cracks"]
    assert data.GetNumberOfPoints() == data.GetNumberOfVerts() == len(cracks["x"]) > 0
    places = vtk_to_numpy(data.GetPoints().GetData())
    np.testing.assert_allclose(places[:, 0], cracks["x"], rtol=1e-6)
    np.testing.assert_allclose(places[:, 1], cracks["y"], rtol=1e-6)
    for name in ("type", "strain"):
        np.testing.assert_array_equal(arrays[name], cracks[name][:])
    np.testing.assert_array_equal(arrays["order"], np.arange(len(cracks["x"])))

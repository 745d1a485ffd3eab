"""Reads an exported field with VTK itself and compares it with the field file read by h5py."""
import sys

import h5py
import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOXML import vtkXMLImageDataReader

field_file, image = sys.argv[1:3]
reader = vtkXMLImageDataReader()
reader.SetFileName(image)
reader.Update()
assert reader.GetErrorCode() == 0
data = reader.GetOutput()
points = data.GetPointData()
arrays = {points.GetArrayName(k): vtk_to_numpy(points.GetArray(k)) for k in range(points.GetNumberOfArrays())}
with h5py.File(field_file) as file:
    dx = file["map"].attrs["dx [m]"]
    height, width = file["map/phase"].shape
    assert data.GetDimensions() == (width, height, 1)
    np.testing.assert_allclose(data.GetSpacing(), 3 * [dx])
    np.testing.assert_allclose(data.GetOrigin(), [dx / 2, dx / 2, 0])
    np.testing.assert_array_equal(arrays["phase"], file["map/phase"][:].ravel())
    np.testing.assert_array_equal(arrays["grain"], file["map/grain"][:].ravel())
    for name in ("sigma_xx", "sigma_yy", "sigma_xy"):
        np.testing.assert_array_equal(arrays[name], file["field"][name][:].ravel())
    for k, name in ((0, "sigma_xx"), (1, "sigma_yy"), (3, "sigma_xy")):  # VTK's order: xx, yy, zz, xy, yz, xz
        np.testing.assert_array_equal(arrays["stress"][:, k], arrays[name])
    np.testing.assert_array_equal(arrays["displacement"][:, 0], file["field/ux"][:].ravel())
    np.testing.assert_array_equal(arrays["displacement"][:, 1], file["field/uy"][:].ravel())
assert np.abs(arrays["sigma_yy"]).max() > 0

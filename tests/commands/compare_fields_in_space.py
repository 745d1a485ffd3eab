"""Reads coarse-grained fields of spheres with VTK itself and holds their sums over the periodic cell against the grains
and contacts of the stage file read by h5py."""

import glob
import sys

import h5py
import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOXML import vtkXMLImageDataReader

result, folder = sys.argv[1:3]
reader = vtkXMLImageDataReader()
reader.SetFileName(folder + "/fields_0001.vti")
reader.Update()
assert reader.GetErrorCode() == 0
image = reader.GetOutput()
points = image.GetPointData()
arrays = {points.GetArrayName(k): vtk_to_numpy(points.GetArray(k)) for k in range(points.GetNumberOfArrays())}
dimensions, spacing = np.array(image.GetDimensions()), np.array(image.GetSpacing())
with h5py.File(sorted(glob.glob(result + "/02-*.h5"))[0]) as file:
    state = file["frames/0000"]
    radius = file["grains/radius"][:]
    contacts = {name: values[:] for name, values in state["contacts"].items()}
assert set(arrays) == {"solid_fraction", "density", "kinetic_pressure", "velocity", "stress"}
assert (dimensions > 4).all() and (spacing <= radius.mean()).all()
assert arrays["velocity"].shape == (dimensions.prod(), 3) and arrays["stress"].shape == (dimensions.prod(), 6)
# On points a seventh of the kernel's radius apart the sum of the smooth function is its integral to 4e-5.
cell = spacing.prod()
np.testing.assert_allclose(arrays["solid_fraction"].sum() * cell, (4 / 3 * np.pi * radius**3).sum(), rtol=1e-4)
density = arrays["density"].sum() / arrays["solid_fraction"].sum()
np.testing.assert_allclose(arrays["density"], density * arrays["solid_fraction"], rtol=1e-9)  # of one material
normal, tangential = (np.stack([contacts[name + axis] for axis in "xyz"], 1) for name in ("n", "ft_"))
force = contacts["fn"][:, None] * normal + np.cross(tangential, normal)
moment = force.T @ (-(contacts["arm_i"] + contacts["arm_j"])[:, None] * normal)
size = abs(moment.trace())
assert arrays["kinetic_pressure"].sum() * cell < 1e-3 * size
xx, yy, zz, xy, yz, xz = arrays["stress"].sum(0) * cell
stress = np.array([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]])
np.testing.assert_allclose(stress, 0.5 * (moment + moment.T), atol=2e-3 * size)

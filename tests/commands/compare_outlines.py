"""Reads the exported rims of squares, pairs of disks and disks with VTK itself and holds them against closed forms of
the stored shapes."""
import math
import os
import sys

import h5py
import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkCompositeDataSet
from vtkmodules.vtkIOXML import vtkXMLMultiBlockDataReader

stage_file, folder = sys.argv[1:3]


def outlines_of(state):
    reader = vtkXMLMultiBlockDataReader()
    reader.SetFileName(os.path.join(folder, f"state_{state:04}.vtm"))
    reader.Update()
    blocks = reader.GetOutput()
    assert reader.GetErrorCode() == 0 and blocks.GetNumberOfBlocks() == 4
    assert blocks.GetMetaData(3).Get(vtkCompositeDataSet.NAME()) == "outlines"
    return blocks.GetBlock(3)


def area_and_reach(place, radius, filled):
    """Closed forms: of a rounded square, of two equal disks that overlap, of a disk."""
    r = radius[0]
    if filled:
        side = place[0, 0] - place[1, 0]
        return side * side + 4 * side * r + math.pi * r * r, math.hypot(*place[0]) + r
    if len(place) == 2:
        half = math.acos(np.ptp(place[:, 0]) / (2 * r))
        return 2 * math.pi * r * r - 2 * r * r * (half - math.sin(half) * math.cos(half)), place[1, 0] + r
    return math.pi * r * r, r


def check(data, centre, angle, shapes):
    ends = vtk_to_numpy(data.GetPoints().GetData()).reshape(-1, 2, 3)
    grain = vtk_to_numpy(data.GetCellData().GetArray("id")) - 100
    assert data.GetNumberOfLines() == len(ends) and set(grain) == set(range(len(centre)))
    for g, (first, last) in enumerate(zip(shapes["first"][:-1], shapes["first"][1:])):
        lines = ends[grain == g]
        np.testing.assert_array_equal(lines[:, 1], np.roll(lines[:, 0], -1, axis=0))  # a closed loop
        place = np.column_stack([shapes["x"][first:last], shapes["y"][first:last]])
        area, reach = area_and_reach(place, shapes["radius"][first:last], shapes["filled"][g])
        a, b = (lines[:, k, :2] - centre[g] for k in (0, 1))
        inside = 0.5 * np.sum(a[:, 0] * b[:, 1] - a[:, 1] * b[:, 0])
        assert 0.985 * area < inside < area, (g, inside, area)  # chords of arcs of a fifth of a radian at most
        assert 0.98 * reach < np.hypot(*a.T).max() < (1 + 1e-9) * reach, g
        if len(place) == 2:  # longest along the angle, which a loop that is not turned with the grain would not be
            along = a @ [math.cos(angle[g]), math.sin(angle[g])]
            assert along.max() > 0.98 * reach, (g, along.max())


with h5py.File(stage_file) as file:
    for state, frame in enumerate(file["frames"].values()):
        shapes = {name: file["grains/shapes"][name][:] for name in ("first", "x", "y", "radius", "filled")}
        check(
            outlines_of(state),
            np.column_stack([frame["grains/x"], frame["grains/y"]]),
            frame["grains/angle"][:],
            shapes,
        )
print("checked", state + 1, "states")

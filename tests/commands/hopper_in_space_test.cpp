// The example of a hopper in space in small: it flows, and other programs and the page see its boundaries.
#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <string>

#include "support/document_of_page.hpp"
#include "support/program.hpp"
#include "support/temporary_folder.hpp"

namespace {

using namespace arenite;

/// Of the first state of the discharge by VTK: the gate's face and the cone's, whose area is known.
const char* const faces = R"(
import sys
import numpy as np
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader
from vtkmodules.vtkFiltersCore import vtkMassProperties, vtkTriangleFilter
from vtkmodules.util.numpy_support import vtk_to_numpy
reader = vtkXMLPolyDataReader()
reader.SetFileName(sys.argv[1] + '/boundaries_0002.vtp')
reader.Update()
data = reader.GetOutput()
cells = data.GetCellData()
assert data.GetNumberOfPolys() == data.GetNumberOfCells() == 33
assert list(vtk_to_numpy(cells.GetArray('boundary'))) == [0] * 32 + [1]
assert list(vtk_to_numpy(cells.GetArray('present'))) == [1] * 32 + [0]
triangles, area = vtkTriangleFilter(), vtkMassProperties()
triangles.SetInputData(data)
area.SetInputConnection(triangles.GetOutputPort())
# 32 trapezia between chords of two circles, as high as the distance of the chords' middles.
half = np.pi / 32
low, high, rise = 19, 56.5, 50
cone = 32 * (low + high) * np.sin(half) * np.hypot(rise, (high - low) * np.cos(half))
assert abs(area.GetSurfaceArea() / (1e-6 * (cone + 40 * 40)) - 1) < 1e-6
)";

}  // namespace

TEST(HopperInSpace, FlowsAndIsSeenByOtherProgramsAndOnThePage) {
  const test::TemporaryFolder folder;
  const std::string out = (folder / "out").string(), vtk = (folder / "vtk").string();
  const auto run =
      test::arenite("run " ARENITE_SOURCE_DIR "/examples/17-hopper-in-space/recipe.toml --quiet --out " + out +
                    " --set populations.0.count=250 --set 'stages.1.duration=\"0.3 s\"' --set stages.1.snapshots=2");
  ASSERT_EQ(run.status, 0) << run.err;
  const auto shown = test::arenite("show --json " + out);
  const auto discharge = nlohmann::json::parse(shown.out)["discharge"];
  EXPECT_GT(discharge["rate_kg_s"]["value"].get<double>(), 0.1);
  EXPECT_NEAR(discharge["opening_m"].get<double>(), 0.038, 5e-4);  // of 32 edges within a circle of 38 mm
  ASSERT_EQ(test::arenite("export " + out + " --to vtk --out " + vtk).status, 0);
  std::ofstream(folder / "faces.py") << faces;
  const auto read = test::shell("/usr/bin/python3 " + (folder / "faces.py").string() + " " + vtk);
  EXPECT_EQ(read.status, 0) << read.err;
  const auto flow = test::document_of_page(out + "/report.html")["spheres"].back();
  EXPECT_EQ(flow["states"].back()["boundaries"][0]["name"], "hopper");
  EXPECT_TRUE(flow["figures"].contains("discharge") && flow["figures"].contains("boundary-forces")) << flow["figures"];
}

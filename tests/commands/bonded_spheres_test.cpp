// Bonded spheres from the recipe to the files.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include <filesystem>
#include <fstream>
#include <string>

#include "support/program.hpp"
#include "support/small_spheres.hpp"
#include "support/temporary_folder.hpp"

namespace {
using arenite::test::arenite;
using arenite::test::contains;
using arenite::test::TemporaryFolder;
namespace fs = std::filesystem;

/// The example, small.
const std::string small_cylinder =
    "run " ARENITE_SOURCE_DIR
    "/examples/37-bonded-cylinder/recipe.toml --quiet --set packing.grains=120 "
    "--set 'variables.W=\"5.6 mm\"' --set 'variables.speed=\"600 mm/s\"' --set integration.safety=0.2 --out ";

fs::path stage_file(const fs::path& folder, const std::string& stage) {
  for (const auto& entry : fs::directory_iterator(folder))
    if (contains(entry.path().filename().string(), "-" + stage)) return entry.path();
  ADD_FAILURE() << "no file of " << stage;
  return {};
}

/// By VTK itself, beside the stage file as h5py reads it.
const char* const compare = R"(
import sys
import h5py, numpy as np
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader
from vtkmodules.util.numpy_support import vtk_to_numpy
file = h5py.File(sys.argv[1])
last = sorted(file['frames'])[-1]
state = file['frames'][last]
b = {name: state['bonds'][name][()] for name in state['bonds']}
whole, broken = b['broken'] == 0, b['broken'] != 0
history = {name: file['history'][name][()] for name in file['history']}
assert 0 < broken.sum() < len(whole)
assert history['bonds'][-1] == whole.sum(), (history['bonds'][-1], whole.sum())
kinds = ['tension', 'bending', 'shear', 'twisting']
assert [history['broken_in_' + k][-1] for k in kinds] == [(b['broken'] == n + 1).sum() for n in range(4)]
assert (b['time'][broken] > 0).all() and (b['load'][broken] >= 1).all() and (b['load'][whole] < 1).all()
def read(name):
    reader = vtkXMLPolyDataReader()
    reader.SetFileName(sys.argv[2] + '/' + name + '_%04d.vtp' % int(sys.argv[3]))
    reader.Update()
    return reader.GetOutput()
bonds, cracks = read('bonds'), read('cracks')
assert bonds.GetNumberOfCells() == whole.sum() and cracks.GetNumberOfPoints() == broken.sum()
force = vtk_to_numpy(bonds.GetCellData().GetArray('force'))
ends = vtk_to_numpy(bonds.GetPoints().GetData()).reshape(-1, 2, 3)
n = ends[:, 0] - ends[:, 1]
n /= np.linalg.norm(n, axis=1)[:, None]
assert np.allclose((force * n).sum(1), b['fn'][whole], atol=1e-6 * abs(b['fn']).max())
assert np.allclose(vtk_to_numpy(cracks.GetPoints().GetData()), np.stack([b[c][broken] for c in 'xyz'], 1))
)";

TEST(BondedSpheres, TheExampleIsCrushedAndItsFilesSayHow) {
  const TemporaryFolder folder;
  const auto out = folder / "out", vtk = folder / "vtk";
  const auto run = arenite(small_cylinder + out.string());
  ASSERT_EQ(run.status, 0) << run.err;
  EXPECT_TRUE(contains(run.out, "top_force < 0.5*max(top_force)")) << run.out;
  EXPECT_TRUE(contains(arenite("show " + out.string()).out, "bonds broken"));
  ASSERT_EQ(arenite("export " + out.string() + " --to vtk --out " + vtk.string()).status, 0);
  int states = 0;
  for (const auto& entry : fs::directory_iterator(vtk)) states += contains(entry.path().filename().string(), "grains_");
  std::ofstream(folder / "compare.py") << compare;
  const auto read =
      arenite::test::shell("/usr/bin/python3 " + (folder / "compare.py").string() + " " +
                           stage_file(out, "press").string() + " " + vtk.string() + " " + std::to_string(states - 1));
  EXPECT_EQ(read.status, 0) << read.err;

  // What a later stage goes on from is all in the file of the one before.
  const auto last = stage_file(out, "press");
  const std::string bytes = arenite::test::slurp(last);
  fs::remove(last);
  ASSERT_EQ(arenite(small_cylinder + out.string()).status, 0);
  EXPECT_TRUE(arenite::test::slurp(last) == bytes) << "other bytes after it was computed again";
}

TEST(BondedSpheres, AConditionEndsAStageOfSpheres) {
  const TemporaryFolder folder;
  std::ofstream(folder / "recipe.toml") << arenite::test::small_triaxial;
  const std::string recipe = (folder / "recipe.toml").string();
  const auto run = arenite("run " + recipe + " --quiet --set 'stages.axial.until=axial_strain > 1 %' --out " +
                           (folder / "out").string());
  ASSERT_EQ(run.status, 0) << run.err;
  EXPECT_TRUE(contains(run.out, "axial_strain > 1 % (axial_strain = 0.01")) << run.out;
}

}  // namespace

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "support/program.hpp"

namespace {
using namespace arenite;
using test::arenite;
using test::contains;
using test::TemporaryFolder;
namespace fs = std::filesystem;

/// Layers of a particle (1) and a matrix (2), made by Python.
std::string two_layers(const fs::path& file) {
  const auto made =
      test::shell("/usr/bin/python3 -c \"import h5py, numpy as np; y, x = np.mgrid[0:24, 0:24]; h5py.File('" +
                  file.string() + "', 'w')['map'] = np.where(x < 12, 1, 2).astype(np.uint8)\"");
  EXPECT_EQ(made.status, 0) << made.err;
  return file.string();
}

std::string left_aside(const std::string& option, const std::string& without) {
  return option + ": only has an effect with " + without + "; it is left aside\n";
}

TEST(LoadIdleOptions, OfAPictureAreTold) {
  const TemporaryFolder folder;
  const std::string load = "load " + two_layers(folder / "map.h5") + " --phases 1=particle,2=matrix --quiet ";
  const auto idle =
      arenite(load + "--voxels 32 --cement kind=full --horizon-in-space 2 --smoothing 3 --labels components");
  ASSERT_EQ(idle.status, 0) << idle.err;
  for (const auto& [option, without] :
       std::vector<std::pair<std::string, std::string>>{{"--voxels", "a table of spheres"},
                                                        {"--cement", "a table of spheres"},
                                                        {"--horizon-in-space", "a sample in space"},
                                                        {"--smoothing", "--labels watershed"}})
    EXPECT_TRUE(contains(idle.err, left_aside(option, without))) << idle.err;
  EXPECT_FALSE(contains(idle.err, "--phases: ")) << idle.err;
  const auto stiff = arenite("load " + (folder / "map.h5").string() +
                             " --phases 1=particle,2=matrix --method elements --exact-stretch --stop-at-voids");
  for (const char* key : {"exact_stretch", "stop_at_voids"})
    EXPECT_TRUE(contains(stiff.err, std::string(key) + ": has no effect, because elements have no bonds")) << stiff.err;
  EXPECT_FALSE(contains(arenite(load + "--smoothing 3 --labels watershed").err, "left aside"));
}

TEST(LoadIdleOptions, OfSpheresAreTold) {
  const TemporaryFolder folder;
  std::ofstream(folder / "s.csv") << "x [mm],y [mm],z [mm],radius [mm]\n0,0,0,1\n1.9,0,0,1\n0,1.9,0,1\n0,0,1.9,1\n";
  const auto idle =
      arenite("load " + (folder / "s.csv").string() +
              " --voxels 16 --cement kind=full --dx '10 um' --phases 1=matrix --labels none --dimension 2 "
              "--quiet");
  ASSERT_EQ(idle.status, 0) << idle.err;
  EXPECT_TRUE(contains(idle.err, left_aside("--dimension", "a picture"))) << idle.err;
  for (const char* option : {"--dx", "--phases", "--labels"})
    EXPECT_TRUE(contains(idle.err, left_aside(option, "a picture or a volume"))) << idle.err;
  EXPECT_FALSE(contains(idle.err, "--voxels: ")) << idle.err;
}

TEST(LoadIdleOptions, APartThatIsGivenTwiceIsRefused) {
  const TemporaryFolder folder;
  const auto refused = arenite("load " + two_layers(folder / "map.h5") + " --stiffness 'matrix=1 GPa,matrix=2 GPa'");
  EXPECT_EQ(refused.status, 2);
  EXPECT_TRUE(contains(refused.err, "--stiffness: matrix is given twice; keep one")) << refused.err;
}

}  // namespace

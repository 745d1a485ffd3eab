#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include <filesystem>
#include <string>

#include "support/program.hpp"

namespace {
using namespace arenite;
using test::arenite;
using test::TemporaryFolder;
using Json = nlohmann::json;
namespace fs = std::filesystem;

/// A volume of 12^3 voxels made by an expression of Python over x, y and z, saved by NumPy.
std::string volume(const fs::path& file, const std::string& value) {
  const auto made =
      test::shell("/usr/bin/python3 -c \"import numpy as np; z, y, x = np.mgrid[0:12, 0:12, 0:12]; np.save('" +
                  file.string() + "', np.where(" + value + ").astype(np.uint8))\"");
  EXPECT_EQ(made.status, 0) << made.err;
  return file.string();
}

const std::string by_elements = " --method elements --poisson matrix=0 --dx '10 um' --json ";

TEST(LoadVoxels, LayersInSpaceHaveTheirExactModuli) {
  const TemporaryFolder folder;
  const std::string map = volume(folder / "map.npy", "x % 6 < 3, 1, 2");
  const auto loaded =
      arenite("load " + map + by_elements +
              "--phases 1=particle,2=matrix --effective-stiffness --tolerance 1e-8 --out " + (folder / "out").string());
  ASSERT_EQ(loaded.status, 0) << loaded.err;
  const Json j = Json::parse(loaded.out);
  EXPECT_NEAR(j["modulus_Pa"].get<double>() / 2.5e9, 1, 1e-6);  // 1 and 4 GPa, along the layers
  const Json& young = j["effective_stiffness"]["young_Pa"];
  EXPECT_NEAR(young[0].get<double>() / 1.6e9, 1, 1e-6);  // across them
  EXPECT_NEAR(young[1].get<double>() / 2.5e9, 1, 1e-6);
  EXPECT_NEAR(young[2].get<double>() / 2.5e9, 1, 1e-6);
  EXPECT_NEAR(j["stress"]["sigma_zz"]["sets"]["particle"]["mean_over_sample_mean"]["value"].get<double>(), 1.6, 1e-4);
  EXPECT_EQ(j["map"]["voxels"], (Json{12, 12, 12}));
  EXPECT_EQ(Json::parse(test::slurp(folder / "out" / "tension.json")), j);
  const auto read = test::shell(
      "/usr/bin/python3 -c \"import vtk; r = vtk.vtkXMLImageDataReader(); r.SetFileName('" +
      (folder / "out" / "tension.vti").string() +
      "'); r.Update(); o = r.GetOutput(); a = o.GetPointData().GetArray('stress'); print(o.GetDimensions(), "
      "o.GetSpacing()[2], a.GetNumberOfComponents(), round(a.GetTuple(0)[2] / 1e4))\"");
  EXPECT_EQ(read.out, "(12, 12, 12) 1e-05 6 40\n") << read.err;
}

TEST(LoadVoxels, AStackOfPicturesIsASampleInSpaceWhereItIsSaid) {
  const TemporaryFolder folder;
  const auto made = test::shell("/usr/bin/python3 -c \"import h5py, numpy as np; h5py.File('" +
                                (folder / "s.h5").string() + "', 'w')['map'] = np.ones((9, 8, 7), np.uint8)\"");
  ASSERT_EQ(made.status, 0) << made.err;
  const auto loaded = arenite("load " + (folder / "s.h5").string() + by_elements +
                              "--dimension 3 --phases 0=void,1=matrix --lower sliding");
  ASSERT_EQ(loaded.status, 0) << loaded.err;
  const Json j = Json::parse(loaded.out);
  EXPECT_EQ(j["map"]["voxels"], (Json{7, 8, 9}));
  EXPECT_NEAR(j["modulus_Pa"].get<double>() / 1e9, 1, 1e-6);
}

TEST(LoadVoxels, WhatIsOfThePlaneIsRefused) {
  const TemporaryFolder folder;
  const std::string map = volume(folder / "map.npy", "x < 6, 1, 2") + " --phases 1=particle,2=matrix ";
  const auto refused = [&](const std::string& options) {
    const auto r = arenite("load " + map + options);
    EXPECT_EQ(r.status, 2) << options;
    return r.err;
  };
  EXPECT_NE(refused("").find("--method elements"), std::string::npos);
  EXPECT_NE(refused("--failure --dx '1 um'").find("leave failure out"), std::string::npos);
  EXPECT_NE(refused("--method elements --axis x").find("leave axis out"), std::string::npos);
  EXPECT_NE(refused("--method elements --labels watershed").find("components"), std::string::npos);
  EXPECT_NE(refused("--method elements --slice 3").find("--dimension 2"), std::string::npos);
}

}  // namespace

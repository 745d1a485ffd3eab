#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>

#include "support/program.hpp"

namespace {
using namespace arenite;
using test::arenite;
using test::TemporaryFolder;

TEST(LoadAxes, ModuliAreOfTheSampleWhicheverWayItIsLoaded) {
  const TemporaryFolder folder;
  const std::string map = (folder / "upright_layers.h5").string();
  const auto made =
      test::shell("/usr/bin/python3 -c \"import h5py, numpy as np; y, x = np.mgrid[0:40, 0:60]; h5py.File('" + map +
                  "', 'w')['map'] = np.where((x // 10) % 2 == 0, 1, 2).astype(np.uint8)\"");
  ASSERT_EQ(made.status, 0) << made.err;
  const auto told = [&](const std::string& axis) {
    const auto loaded = arenite("load " + map + " --phases 1=particle,2=matrix --method elements --moduli " +
                                "--effective-stiffness --axis " + axis + " --json");
    EXPECT_EQ(loaded.status, 0) << loaded.err;
    return nlohmann::json::parse(loaded.out);
  };
  const auto along = told("y"), across = told("x");
  for (const char* name : {"E_x_Pa", "E_y_Pa", "nu_xy", "nu_yx", "G_Pa"})
    EXPECT_EQ(along["apparent_moduli"][name], across["apparent_moduli"][name]) << name;
  EXPECT_LT(along["apparent_moduli"]["E_x_Pa"].get<double>(), along["apparent_moduli"]["E_y_Pa"].get<double>());
  EXPECT_EQ(along["effective_stiffness"]["young_Pa"], across["effective_stiffness"]["young_Pa"]);
  EXPECT_LT(across["modulus_Pa"].get<double>(), along["modulus_Pa"].get<double>());
  EXPECT_NE(across["notes"].dump().find("x and y exchanged"), std::string::npos);
}

TEST(LoadAxes, WhatNeedsNoClampsIsFoundWhereTheLoadIsNotAndTheRestSaysWhichPullFailed) {
  const TemporaryFolder folder;
  const std::string map = (folder / "cut.h5").string();
  const auto made = test::shell(
      "/usr/bin/python3 -c \"import h5py, numpy as np; m = np.ones((40, 60), np.uint8); m[18:22] = 0; "
      "h5py.File('" +
      map + "', 'w')['map'] = m\"");
  ASSERT_EQ(made.status, 0) << made.err;
  const auto loaded = arenite("load " + map + " --phases 0=void,1=particle --method elements --moduli " +
                              "--effective-stiffness --json");
  EXPECT_EQ(loaded.status, 3) << loaded.err;
  const auto told = nlohmann::json::parse(loaded.out);
  EXPECT_GT(told["apparent_moduli"]["E_x_Pa"].get<double>(), 0);
  EXPECT_EQ(told["apparent_moduli"]["E_y_Pa"].get<double>(), 0);
  EXPECT_GT(told["effective_stiffness"]["stiffness_Pa"][0][0].get<double>(), 0);
  EXPECT_NE(loaded.out.find("apparent moduli: not found under tension along y (1080 nodes"), std::string::npos)
      << loaded.out;
}

}  // namespace

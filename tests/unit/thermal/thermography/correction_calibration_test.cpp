#include "thermal/thermography/correction.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>

#include "io/table/laboratory_table.hpp"
#include "support/films.hpp"
#include "support/pictures.hpp"
#include "support/temporary_folder.hpp"

namespace arenite::thermography {
namespace {

const radiometry::Band band;

/// What a curve gives for a level, K.
double temperature_of(const LevelCurve& curve, double level) {
  const double x = (level - curve.first) / curve.step;
  const auto k =
      static_cast<std::size_t>(std::clamp(std::floor(x), 0.0, static_cast<double>(curve.temperature.size() - 2)));
  const auto a = static_cast<double>(curve.temperature[k]), b = static_cast<double>(curve.temperature[k + 1]);
  return a + (x - static_cast<double>(k)) * (b - a);
}

TEST(Calibration, PiecewiseGoesThroughItsPointsAndOnBeyondThem) {
  const LevelCurve curve =
      curve_through({{8192, 305}, {4096, 295}, {12288, 310}});  // in any order, at steps of the table
  EXPECT_NEAR(temperature_of(curve, 4096), 295, 1e-3);
  EXPECT_NEAR(temperature_of(curve, 6144), 300, 2e-3);
  EXPECT_NEAR(temperature_of(curve, 10240), 307.5, 2e-3);
  EXPECT_NEAR(temperature_of(curve, 0), 285, 1e-3);
  EXPECT_NEAR(temperature_of(curve, 16383), 315, 5e-3);
}

TEST(Calibration, ASurfaceThatIsNotBlackIsSeenThroughTheCurveToo) {
  const radiometry::Surface surface{0.8, 288};
  const LevelCurve curve = curve_through({{4096, 295}, {8192, 305}}, band, surface);
  const double seen = 0.8 * radiometry::photon_exitance(band, 303) + 0.2 * radiometry::photon_exitance(band, 288);
  const double level = 4096 + (radiometry::temperature_of_exitance(band, seen) - 295) * 409.6;
  EXPECT_NEAR(temperature_of(curve, level), 303, 2e-3);
}

TEST(Calibration, WhatIsNoCurveIsRefused) {
  EXPECT_NE(test::complaint([] { curve_through({{1, 300}}); }).find("too short"), std::string::npos);
  EXPECT_NE(test::complaint([] { curve_through({{1, 300}, {2, 299}}); }).find("does not rise"), std::string::npos);
  EXPECT_NE(test::complaint([] { curve_through({{1, 300}, {2, -4}}); }).find("which is impossible"), std::string::npos);
  EXPECT_NE(test::complaint([] {
              curve_by_references(band, {5000, 300}, {9000, 290}, {});
            }).find("colder"),
            std::string::npos);
  EXPECT_NE(test::complaint([] { curve_by_radiometry(band, {0, 300}, {}); }).find("above 0"), std::string::npos);
}

/// A camera whose level is a line of the photons sees a grey surface before warm surroundings; the curve undoes it.
RC_GTEST_PROP(CalibrationProperty, RadiometryFindsTheTemperatureOfAGreySurface, ()) {
  const radiometry::Surface surface{*rc::gen::inRange(50, 101) * 0.01, *rc::gen::inRange(280, 310) * 1.0};
  const double per_photon = 6000 / radiometry::photon_exitance(band, 300), zero = *rc::gen::inRange(0, 1500) * 1.0;
  const auto level = [&](double photons) { return zero + per_photon * photons; };
  const LevelPoint cold{level(radiometry::photon_exitance(band, 291)), 291},
      warm{level(radiometry::photon_exitance(band, 301)), 301};
  const LevelCurve curve = curve_by_references(band, cold, warm, surface);
  const double temperature = *rc::gen::inRange(2880, 3120) * 0.1;
  RC_ASSERT(std::abs(temperature_of(curve, level(radiometry::seen_exitance(band, surface, temperature))) -
                     temperature) < 1e-4);
}

TEST(Calibration, RadiometryWithOneLevelKnown) {
  const radiometry::Surface grey{0.9, 296};
  const LevelCurve curve = curve_by_radiometry(band, {5000, 296}, grey);
  EXPECT_NEAR(temperature_of(curve, 5000), 296, 1e-4);
  const double seen = radiometry::seen_exitance(band, grey, 300) / radiometry::photon_exitance(band, 296);
  EXPECT_NEAR(temperature_of(curve, 5000 * seen), 300, 1e-4);
}

TEST(Calibration, FramesTurnIntoKelvinAsTheCurveSays) {
  const LevelCurve curve = curve_by_radiometry(band, {5000, 296}, {0.9, 296});
  Correction correction{3, 1, {}, {}, curve, {}, {}, {}};
  std::vector<float> out;
  apply(correction, {0, 1, {4800, 5000, 5301}, {}}, out);
  EXPECT_NEAR(out[0], temperature_of(curve, 4800), 5e-5);
  EXPECT_NEAR(out[1], 296, 1e-4);
  EXPECT_NEAR(out[2], temperature_of(curve, 5301), 5e-5);
}

TEST(Calibration, CurvesAreReadFromTables) {
  const test::TemporaryFolder folder;
  test::spill(folder / "k.csv", "level,temperature\n4000,295\n8000,305\n");
  test::spill(folder / "c.csv", "temperature [C];level\n21.85;4000\n31.85;8000\n");
  test::spill(folder / "bad.csv", "level,temperature\n4000,warm\n8000,305\n9000,hot\n");
  test::spill(folder / "other.csv", "a,b\n1,2\n");
  for (const char* name : {"k.csv", "c.csv"}) {
    const auto curve = io::read_calibration_curve((folder / name).string());
    EXPECT_EQ(curve.level, (std::vector<double>{4000, 8000}));
    EXPECT_NEAR(curve.temperature[1], 305, 1e-9);
  }
  const std::string text = test::complaint([&] { io::read_calibration_curve((folder / "bad.csv").string()); });
  EXPECT_NE(text.find(":2"), std::string::npos);
  EXPECT_NE(text.find(":4"), std::string::npos);
  EXPECT_NE(test::complaint([&] {
              io::read_calibration_curve((folder / "other.csv").string());
            }).find("level and temperature"),
            std::string::npos);
}

}  // namespace
}  // namespace arenite::thermography

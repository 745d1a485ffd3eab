#include "solid/cement/cement.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <string>

#include "core/error.hpp"
#include "support/disks.hpp"

namespace arenite::cement {
namespace {

using Kind = CementParameters::Kind;
using std::numbers::pi;
using test::disks;
const Window wide{-9, 9, -9, 9};

CementParameters bridges(double gap, double width, bool full_width = false) {
  CementParameters p;
  p.gap = gap, p.width = width, p.full_width = full_width;
  return p;
}

CementParameters coating(double thickness) {
  CementParameters p;
  p.kind = Kind::coating, p.thickness = thickness;
  return p;
}

CementParameters menisci(double gap, double volume) {
  CementParameters p;
  p.kind = Kind::menisci, p.gap = gap, p.volume = volume;
  return p;
}

CementParameters of_kind(Kind kind) {
  CementParameters p;
  p.kind = kind;
  return p;
}

CementParameters with_saturation(CementParameters p, double saturation) {
  p.saturation = saturation;
  return p;
}

CementReport made(const Packing& packing, const CementParameters& parameters, const Window& window = wide) {
  CementReport report;
  make_cement(packing, parameters, window, report);
  return report;
}

double matrix(const Packing& packing, const CementParameters& parameters, const Window& window = wide) {
  return made(packing, parameters, window).areas.matrix;
}

/// A bridge of half-width eta r between two equal disks: a rectangle less what the disks cover of it.
double bridge_area(double r, double gap, double eta) {
  const double half = eta * r, covered = half * std::sqrt(r * r - half * half) + r * r * std::asin(eta);
  return 2 * half * (2 * r + gap) - 2 * covered;
}

TEST(Bridges, BetweenTwoEqualDisksHaveTheClosedFormsArea) {
  for (const double gap : {0.0, 0.075})
    for (const double eta : {0.2, 0.6, 1.0}) {
      const Packing two = disks({{-0.3, 0.1, 1}, {-0.3 + 0.6 * (2 + gap), 0.1 + 0.8 * (2 + gap), 1}}, 10);
      EXPECT_NEAR(matrix(two, bridges(0.08, eta)), bridge_area(1, gap, eta), 1e-12);
      EXPECT_NEAR(matrix(two, bridges(0.08, eta, true)), bridge_area(1, gap, eta / 2), 1e-12);
    }
}

TEST(Bridges, JoinGrainsWhoseGapIsAtMostEll) {
  const Packing three = disks({{0, 0, 1}, {2.05, 0, 1}, {0, 2.2, 1}}, 10);
  EXPECT_EQ(made(three, bridges(0.04, 0.4)).necks, 0u);
  EXPECT_EQ(made(three, bridges(0.06, 0.4)).necks, 1u);
  EXPECT_EQ(made(three, bridges(0.21, 0.4)).necks, 2u);
}

TEST(Bridges, FillAPoreOfThreeGrainsAtHalfWidthOverRootThree) {
  const double h = std::sqrt(3.0);
  const Packing three = disks({{-1, 0, 1}, {1, 0, 1}, {0, h, 1}}, 10);
  const Window pore{-0.5, 0.5, 0.3, 1.1};  // holds the pore's middle and much of its sides
  const auto saturation = [&](double eta) { return made(three, bridges(1e-9, eta), pore).saturation; };
  EXPECT_NEAR(saturation(1 / h + 1e-6), 1, 1e-12);
  EXPECT_LT(saturation(1 / h - 1e-3), 1 - 1e-7);
}

TEST(Bridges, ReachAcrossPeriodicSides) {
  const Packing walls = disks({{-2, 0, 1}, {2, 0, 1}}, 3), across = disks({{-2, 0, 1}, {2, 0, 1}}, 3, true);
  const Window window{-3, 3, -3, 3};
  const CementParameters p = bridges(0.01, 0.5);
  EXPECT_EQ(matrix(walls, p, window), 0);
  EXPECT_NEAR(matrix(across, p, window), bridge_area(1, 0, 0.5), 1e-12);
  EXPECT_NEAR(made(across, p, window).areas.particle, 2 * pi, 1e-12);
}

TEST(FullCement, FillsAllThatIsNotGrain) {
  const auto report = made(disks({{0, 0, 1}}, 10), of_kind(Kind::full), {-2, 2, -2, 2});
  EXPECT_NEAR(report.areas.matrix, 16 - pi, 1e-12);
  EXPECT_EQ(report.saturation, 1);
}

TEST(Coating, IsTheLayerRoundTheGrains) {
  const Packing one = disks({{0, 0, 1}}, 10), two = disks({{-1, 0, 1}, {1, 0, 1}}, 10);
  EXPECT_NEAR(matrix(one, coating(0.2)), pi * (1.44 - 1), 1e-12);
  const double r = 1.2, lens = 2 * r * r * std::acos(1 / r) - 2 * std::sqrt(r * r - 1);
  EXPECT_NEAR(matrix(two, coating(0.2)), 2 * pi * r * r - lens - 2 * pi, 1e-12);
}

TEST(Menisci, HoldTheVolumeAskedFor) {
  for (const double gap : {-0.02, 0.0, 0.05})
    for (const double ratio : {1.0, 0.3})
      for (const double volume : {0.02, 0.1}) {
        const double d = 1 + ratio + gap;
        const Packing two = disks({{0.2, -0.4, 1}, {0.2 - 0.6 * d, -0.4 + 0.8 * d, ratio}}, 10);
        const auto report = made(two, menisci(0.06, volume));
        EXPECT_EQ(report.necks, 1u);
        EXPECT_NEAR(report.areas.matrix, volume, 1e-11) << gap << " " << ratio;
      }
}

TEST(Menisci, BetweenTouchingEqualDisksHaveTheClosedFormsArea) {
  // Rhombus of the centres of both disks and both arcs, less the four sectors.
  const double arc = 0.25, height = std::sqrt((1 + arc) * (1 + arc) - 1), angle = std::atan(height);
  const double volume = 2 * (height - angle - (pi / 2 - angle) * arc * arc);
  CementReport report;
  const Cement cement = make_cement(disks({{-1, 0, 1}, {1, 0, 1}}, 10), menisci(0.01, volume), wide, report);
  EXPECT_NEAR(cement.menisci.at(0).radius, arc, 1e-10);
}

TEST(Menisci, RuptureWhereTheArcsMeetAndEndAtStraightTangents) {
  const double gap = 0.1;
  const Packing two = disks({{0, 0, 1}, {2 + gap, 0, 1}}, 10);
  // Arcs that meet in the middle of the gap: (1 + R)^2 = (1 + gap/2)^2 + R^2.
  const double a = 1 + gap / 2, arc = (a * a - 1) / 2, angle = std::atan(arc / a);
  const double least = 2 * (a * arc - angle - (pi / 2 - angle) * arc * arc), most = 2 * (2 * a) - pi;
  EXPECT_EQ(made(two, menisci(0.2, least * (1 - 1e-9))).ruptured, 1u);
  EXPECT_EQ(made(two, menisci(0.2, least * (1 - 1e-9))).areas.matrix, 0);
  EXPECT_EQ(made(two, menisci(0.2, least * (1 + 1e-9))).necks, 1u);
  EXPECT_NEAR(matrix(two, menisci(0.2, least * (1 + 1e-6))), least, 1e-5 * least);
  EXPECT_EQ(made(two, menisci(0.2, most * (1 - 1e-9))).capped, 0u);
  EXPECT_NEAR(matrix(two, menisci(0.2, most * (1 - 1e-9))), most, 1e-7);
  EXPECT_EQ(made(two, menisci(0.2, 2 * most)).capped, 1u);
  EXPECT_NEAR(matrix(two, menisci(0.2, 2 * most)), most, 1e-12);
}

TEST(Saturation, OutOfReachNamesWhatIsInReach) {
  const Packing two = disks({{-1, 0, 1}, {1, 0, 1}}, 10);
  CementReport report;
  try {
    make_cement(two, with_saturation(bridges(0.1, 0), 0.9), {-2, 2, -2, 2}, report);
    FAIL() << "a bridge between two disks cannot fill the corners of the window";
  } catch (const InputError& error) {
    const double most = (4 - pi) / (16 - 2 * pi);
    EXPECT_NE(std::string(error.what()).find(std::to_string(most).substr(0, 5)), std::string::npos) << error.what();
  }
}

TEST(Cement, BadInputIsNamed) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  const Packing two = disks({{-1, 0, 1}, {1, 0, 1}}, 10);
  for (const auto& p :
       {bridges(-1, 0.4), bridges(nan, 0.4), bridges(0.1, -0.1), bridges(0.1, 1.01), bridges(0.1, 2.01, true),
        coating(-1), coating(nan), menisci(0.1, -1), with_saturation(bridges(0.1, 0), 0),
        with_saturation(coating(0), 1.1), with_saturation(of_kind(Kind::none), 0.5)})
    EXPECT_THROW(made(two, p), InputError);
  EXPECT_THROW(made(two, bridges(0.1, 0.4), {0, 0, 0, 1}), InputError);
  EXPECT_THROW(made(disks({{0, 0, -1}}, 10), bridges(0.1, 0.4)), InputError);
  EXPECT_THROW(made(disks({{nan, 0, 1}}, 10), bridges(0.1, 0.4)), InputError);
}

TEST(Saturation, IsFoundForEveryKindThatCanChooseIt) {
  const Packing four = disks({{-1.01, 0, 1}, {1.02, 0, 1}, {0, 1.8, 1}, {0.02, -1.78, 1}}, 4);
  const Window window{-1.2, 1.2, -1.2, 1.2};
  for (const auto& kind : {bridges(0.1, 0), coating(0), menisci(0.1, 0)})
    for (const double wanted : {0.05, 0.5, 0.9}) {
      const auto report = made(four, with_saturation(kind, wanted), window);
      EXPECT_NEAR(report.saturation, wanted, 1e-8);
      EXPECT_EQ(report.saturation_error, report.saturation - wanted);
      CementParameters found = kind;
      found.width = found.thickness = found.volume = report.parameter;
      EXPECT_EQ(made(four, found, window).saturation, report.saturation);
    }
}

}  // namespace
}  // namespace arenite::cement

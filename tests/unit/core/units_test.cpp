#include "core/units.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <string>

#include "core/error.hpp"
#include "core/unit_names.hpp"

namespace arenite {
namespace {

std::string refused(std::string_view text, Dimension wanted, std::string_view unit = {}) {
  try {
    parse_si(text, wanted, unit);
  } catch (const InputError& error) { return error.what(); }
  return "accepted";
}

TEST(Units, QuantitiesOfTheThesisReadAsTheNearestDouble) {
  EXPECT_EQ(parse_si("27.35 kN/mm", dimension::stiffness), 27.35e6);
  EXPECT_EQ(parse_si("0.0150 K/MPa", dimension::thermoelastic_factor), 0.0150e-6);
  EXPECT_EQ(parse_si("16.4 mm", dimension::length), 0.0164);
  EXPECT_EQ(parse_si("1410 kg/m^3", dimension::density), 1410.0);
  EXPECT_EQ(parse_si("1.41 g/cm³", dimension::density), 1410.0);
  EXPECT_EQ(parse_si("100 N", dimension::force), 100.0);
  EXPECT_EQ(parse_si("3 Hz", dimension::frequency), 3.0);
  EXPECT_EQ(parse_si("30 %", dimension::none), 0.3);
  EXPECT_EQ(parse_si("30%", dimension::none), 0.3);
  EXPECT_EQ(parse_si("0.3", dimension::none), 0.3);
}

TEST(Units, ProductsQuotientsAndPowersCombine) {
  EXPECT_EQ(parse_si("5 N s/m", dimension::damping), 5.0);
  EXPECT_EQ(parse_si("5 N*s/m", dimension::damping), 5.0);
  EXPECT_EQ(parse_si("5 N·s/m", dimension::damping), 5.0);
  EXPECT_EQ(parse_si("2 kg m s^-2", dimension::force), 2.0);
  EXPECT_EQ(parse_si("2 kg*m/s^2", dimension::force), 2.0);
  EXPECT_EQ(parse_si("2 J/(m m)", dimension::stiffness), 2.0);
  EXPECT_EQ(parse_si("7 1/s", dimension::frequency), 7.0);
  EXPECT_EQ(parse_si("7 /s", dimension::frequency), 7.0);
  EXPECT_EQ(parse_si("3 min", dimension::time), 180.0);
  EXPECT_EQ(parse_si("12 µm", dimension::length), 12e-6);
  EXPECT_EQ(parse_si("-1.5e-3 km", dimension::length), -1.5);
  EXPECT_NEAR(parse_si("180 deg", dimension::none), 3.14159265358979, 1e-14);
}

TEST(Units, BareNumberForADimensionSaysWhichUnitToWrite) {
  EXPECT_EQ(refused("350", dimension::length, "mm"),
            "\"350\" has no unit; write it with its unit, for example \"350 mm\"");
  EXPECT_NE(refused("350", dimension::force).find("\"350 N\""), std::string::npos);
}

TEST(Units, WrongDimensionNamesBoth) {
  EXPECT_EQ(refused("50 mm", dimension::force, "kN"),
            "\"50 mm\" is a length (m), but a force (N) is needed; write it in kN");
  EXPECT_EQ(refused("1 m^4", dimension::force),
            "\"1 m^4\" is a quantity in m^4, but a force (N) is needed; write it in N");
  EXPECT_EQ(refused("1 mm", dimension::none), "\"1 mm\" is a length (m), but a number without unit is needed");
}

TEST(Units, HalfPowersSpeakOfToughness) {
  EXPECT_EQ(parse_si("2.5 MPa m^0.5", dimension::toughness), 2.5e6);
  EXPECT_NEAR(parse_si("1 MPa mm^0.5", dimension::toughness), 31622.7766, 1e-4);
  EXPECT_EQ(parse_si("4 m^0.5", parse_unit("km^0.5").dimension), 4);
  EXPECT_EQ(format_quantity(2.5e6, "MPa m^0.5"), "2.5 MPa m^0.5");
  EXPECT_EQ(refused("1 MPa", dimension::toughness),
            "\"1 MPa\" is a pressure (Pa), but a fracture toughness (Pa m^0.5) is needed; write it in Pa m^0.5");
  EXPECT_NE(refused("1 m^0.3", dimension::toughness).find("or a half"), std::string::npos);
}

TEST(Units, AHalfPowerMayBeAFractionOrARoot) {
  for (const char* text :
       {"0.1 MPa m^1/2", "0.1 MPa m^(1/2)", "0.1 MPa*m^( 1/2)", "0.1 MPa √m", "0.1 MPa√m", "1e2 kPa m^1/2"})
    EXPECT_DOUBLE_EQ(parse_si(text, dimension::toughness), 1e5) << text;
  EXPECT_EQ(parse_unit("N/m^(3/2)").dimension, parse_unit("N m^-1.5").dimension);
  EXPECT_EQ(parse_unit("m^(-1/2)").dimension, parse_unit("m^-0.5").dimension);
  EXPECT_EQ(parse_unit("m^(4/2)").dimension, dimension::area);
  for (const char* text : {"1 m^3/2", "1 m^2/2", "1 m^1/20", "1 m^(1/3)", "1 m^(1/0)", "1 m^(0/0)", "1 m^(1/2", "1 m^(",
                           "1 √", "1 √√√√√√√√√√m"})
    EXPECT_THROW(parse_quantity(text), InputError) << text;
  for (const char* text : {"5 m^1/3", "5 m^3/2", "5 N/m^1/3", "5 m^1/20"})
    EXPECT_NE(refused(text, dimension::area).find("a half such as 0.5, (1/2) or (3/2)"), std::string::npos) << text;
  EXPECT_EQ(parse_unit("m^2/1").dimension, dimension::area);
}

TEST(Units, UnknownUnitOffersTheNearest) {
  EXPECT_EQ(refused("5 kNn", dimension::force), "unknown unit \"kNn\"; did you mean kN?");
  EXPECT_EQ(refused("5 mpa", dimension::pressure), "unknown unit \"mpa\"; did you mean mPa?");
  EXPECT_EQ(refused("5 hz", dimension::frequency), "unknown unit \"hz\"; did you mean Hz?");
  EXPECT_NE(refused("5 furlongs", dimension::length).find("unknown unit \"furlongs\""), std::string::npos);
}

TEST(Units, WhatIsNoQuantityIsRefusedWithAReason) {
  EXPECT_NE(refused("", dimension::length).find("does not start with a number"), std::string::npos);
  EXPECT_NE(refused("mm", dimension::length).find("does not start with a number"), std::string::npos);
  EXPECT_NE(refused("nan mm", dimension::length).find("not a finite number"), std::string::npos);
  EXPECT_NE(refused("inf mm", dimension::length).find("not a finite number"), std::string::npos);
  EXPECT_NE(refused("1e999 mm", dimension::length).find("beyond the range"), std::string::npos);
  EXPECT_NE(refused("27,35 kN", dimension::force).find("decimal point"), std::string::npos);
  EXPECT_NE(refused("5 N/m s", dimension::force).find("brackets"), std::string::npos);
  EXPECT_NE(refused("5 m^", dimension::area).find("power"), std::string::npos);
  EXPECT_NE(refused("5 m^99", dimension::area).find("power"), std::string::npos);
  EXPECT_NE(refused("5 m^nan", dimension::area).find("power"), std::string::npos);
  EXPECT_NE(refused("5 (m", dimension::length).find("bracket"), std::string::npos);
  EXPECT_NE(refused("5 m)", dimension::length).find("unexpected"), std::string::npos);
  EXPECT_NE(refused("5 m/", dimension::length).find("missing"), std::string::npos);
}

TEST(Units, WrittenQuantitiesAreShortAndReadable) {
  EXPECT_EQ(format_quantity(0.0164, "mm"), "16.4 mm");
  EXPECT_EQ(format_quantity(27.35e6, "kN/mm"), "27.35 kN/mm");
  EXPECT_EQ(format_quantity(0.35, "mm"), "350 mm");
  EXPECT_EQ(format_quantity(0.0150e-6, "K/MPa"), "0.015 K/MPa");
  EXPECT_EQ(format_quantity(50e3, "N"), "50000 N");
  EXPECT_EQ(format_quantity(0, "mm"), "0 mm");
  EXPECT_EQ(format_quantity(-1e-9, "m"), "-1e-9 m");
  EXPECT_EQ(format_quantity(0.1, ""), "0.1");
  EXPECT_EQ(format_quantity(std::numeric_limits<double>::quiet_NaN(), ""), "nan");
}

TEST(Units, NumbersThatNothingMeasuredHasAreRefused) {
  for (const char* text : {"5e-324 kN", "1e-310 m", "1e-70 m", "-1e-64 kN", "1e61 m", "1e300 N"})
    EXPECT_NE(refused(text, parse_quantity("1" + std::string(text).substr(std::string(text).find(' '))).dimension)
                  .find("beyond the range"),
              std::string::npos)
        << text;
  EXPECT_EQ(parse_si("0 kN", dimension::force), 0);
  EXPECT_EQ(parse_si("1e-59 m", dimension::length), 1e-59);
}

TEST(Units, WritingAndReadingGivesTheSameBits) {
  EXPECT_TRUE(rc::check("any double in reach, in any decimal unit", [] {
    const auto bits = *rc::gen::resize(rc::kNominalSize, rc::gen::arbitrary<std::uint64_t>());
    double value = 0;
    std::memcpy(&value, &bits, sizeof value);
    RC_PRE(std::isfinite(value) && is_in_reach(value));
    const std::string unit = *rc::gen::element<std::string>("mm", "kN/mm", "K/MPa", "kg/m^3", "N s/m", "1/s", "MPa");
    const double back = parse_si(format_quantity(value, unit), parse_unit(unit).dimension);
    RC_ASSERT(std::memcmp(&back, &value, sizeof value) == 0 || (value == 0 && back == 0));
  }));
}

TEST(Units, AnAreaMayBeWrittenAsTwoLengths) {
  EXPECT_DOUBLE_EQ(parse_si("30.9 mm x 4.9 mm", dimension::area), 30.9e-3 * 4.9e-3);
  EXPECT_DOUBLE_EQ(parse_si("151.4 mm^2", dimension::area), 151.4e-6);
  EXPECT_THROW(parse_si("30.9 mm x 4.9 kN", dimension::area), InputError);
  EXPECT_THROW(parse_si("30.9 mm x 4.9 mm", dimension::length), InputError);
}

}  // namespace
}  // namespace arenite

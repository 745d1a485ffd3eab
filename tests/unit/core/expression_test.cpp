#include "core/expression.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "core/error.hpp"

namespace arenite {
namespace {

const Variables known{{"D", parse_quantity("40 mm")},
                      {"n", {3, {}, {}}},
                      {"P", parse_quantity("100 kPa")},
                      {"rho", parse_quantity("2500 kg/m^3")},
                      {"h", parse_quantity("2 m")}};

double length(const std::string& text) {
  const Quantity found = evaluate(text, known);
  EXPECT_EQ(found.dimension, dimension::length) << text;
  return found.value;
}
double plain(const std::string& text) {
  const Quantity found = evaluate(text, known);
  EXPECT_EQ(found.dimension, dimension::none) << text;
  return found.value;
}

TEST(Expression, HasTheUsualOrderOfOperators) {
  EXPECT_EQ(plain("1 + 2*3 - 4/2"), 5);
  EXPECT_EQ(plain("-2^2"), -4);
  EXPECT_EQ(plain("2^3^2"), 512);
  EXPECT_EQ(plain("(1 + 2)*(3 - -4)"), 21);
  EXPECT_EQ(plain("2^-1"), 0.5);
  EXPECT_NEAR(plain("sin(30 deg) + cos(pi)"), -0.5, 1e-15);
  EXPECT_EQ(plain("max(n, 2) + min(1, 2) + round(2.6)"), 7);
}

TEST(Expression, CarriesUnits) {
  EXPECT_DOUBLE_EQ(length("2*D + 5 mm"), 0.085);
  EXPECT_DOUBLE_EQ(length("D/n"), 0.04 / 3);
  EXPECT_DOUBLE_EQ(length("sqrt(D^2 + (30 mm)^2)"), 0.05);
  EXPECT_DOUBLE_EQ(evaluate("27.35 kN/mm * D", known).value, 27.35e6 * 0.04);
  const Quantity rate = evaluate("0.01/D*sqrt(P/rho)", known);
  EXPECT_EQ(rate.dimension, dimension::frequency);
  EXPECT_DOUBLE_EQ(rate.value, 0.01 / 0.04 * std::sqrt(1e5 / 2500));
}

TEST(Expression, GivesTheDecimalsOneWouldWrite) {
  const Variables silo{{"W", parse_quantity("150 mm")}, {"D", parse_quantity("40 mm")}};
  EXPECT_EQ(format_quantity(evaluate("(W - D)/2", silo).value, "mm"), "55 mm");
  EXPECT_EQ(format_quantity(evaluate("(W - D)/2 - 4 mm", silo).value, "mm"), "51 mm");
  EXPECT_EQ(format_quantity(evaluate("105 mm - 100 mm", {}).value, "mm"), "5 mm");
  EXPECT_EQ(format_quantity(evaluate("0.35*80 mm/(100 mm/s)", {}).value, "s"), "0.28 s");
}

TEST(Expression, ANumberKeepsItsUnitAndAVariableItsName) {
  EXPECT_DOUBLE_EQ(length("40 mm/2"), 0.02);
  EXPECT_EQ(evaluate("9.81 m/s^2", known).dimension, dimension::acceleration);
  EXPECT_EQ(evaluate("5 1/s * 2", known).dimension, dimension::frequency);
  // h is an hour only where nothing else is called so.
  EXPECT_DOUBLE_EQ(evaluate("4 m^2/h", known).value, 2);
  EXPECT_EQ(evaluate("16.4 mm", {}).value, parse_quantity("16.4 mm").value);
  for (const char* text : {"2*3 MPa m^1/2", "2*3 MPa m^(1/2)", "2*(3 MPa m^0.5)"}) {
    EXPECT_DOUBLE_EQ(evaluate(text, {}).value, 6e6) << text;
    EXPECT_EQ(evaluate(text, {}).dimension, dimension::toughness) << text;
  }
  EXPECT_DOUBLE_EQ(evaluate("40 mm^2/2", {}).value, 20e-6);  // half of an area, no power of 2/2
}

TEST(Expression, IsToldFromSingleQuantitiesAndText) {
  for (const char* text : {"2*D", "D", "(1 + 2)", "1 mm + 2 mm", "sqrt(2)", "-D"})
    EXPECT_TRUE(is_expression(text, known)) << text;
  for (const char* text : {"40 mm", "27.35 kN/mm", "wide", "1e-3", "-5 kPa", "5 1/s", "", "12 men"})
    EXPECT_FALSE(is_expression(text, known)) << text;
}

TEST(Expression, WhatCannotBeEvaluatedIsRefusedWithItsReason) {
  for (const auto& [text, reason] : {std::pair{"D + n", "cannot be added"},
                                     std::pair{"1 m^1/3", "or a half such as 0.5, (1/2) or (3/2)"},
                                     {"2*E", "no variable \"E\""},
                                     {"D)", "unexpected"},
                                     {"2*(D", "missing"},
                                     {"2/0", "zero"},
                                     {"D^0.3", "exponent"},
                                     {"sin(D)", "without unit"},
                                     {"max(D)", "arguments"},
                                     {"2*", "missing"},
                                     {"foo(2)", "no function"},
                                     {"2 furlongs*D", "unknown unit"},
                                     {"10^400", "finite"}}) {
    try {
      evaluate(text, known);
      ADD_FAILURE() << text;
    } catch (const InputError& error) {
      EXPECT_NE(std::string(error.what()).find(reason), std::string::npos) << text << ": " << error.what();
    }
  }
  EXPECT_THROW(evaluate(std::string(5000, '('), known), InputError);
  EXPECT_THROW(evaluate(std::string(5000, '-') + "1", known), InputError);
}

TEST(Expression, UnitsAndFunctionsAreNoNames) {
  for (const char* name : {"D", "h", "W", "rho_s", "n2", "I"}) EXPECT_TRUE(is_variable_name(name)) << name;
  for (const char* name : {"mm", "kN", "m", "s", "sqrt", "pi", "2n", "a-b", "", "Pa"})
    EXPECT_FALSE(is_variable_name(name)) << name;
}

}  // namespace
}  // namespace arenite

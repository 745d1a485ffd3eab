#include "report/number_block.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <iterator>

using namespace arenite::report;

namespace {

struct Rough {
  int width = 0, height = 0;
  std::vector<double> values;
  std::vector<std::uint8_t> known;
};

/// Smooth waves with a heavy tail and holes.
Rough rough(int width, int height, double size, double offset) {
  Rough field{width, height, {}, {}};
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const double wave = std::sin(0.31 * x) * std::cos(0.17 * y + 0.05 * x);
      field.values.push_back(offset + size * (wave + (x % 29 == 7 && y % 31 == 5 ? 60 * wave : 0)));
      field.known.push_back((x / 5 + y / 3) % 7 != 0);
    }
  return field;
}

double decoded(const CodedField& c, std::int32_t code) {
  const double t = code / c.levels;
  return c.centre + c.width * (c.companded ? std::sinh(t) : t);
}

/// The codes behind the residuals, as the page finds them (web/src/field/decode.js).
std::vector<std::int32_t> codes_of(int width, int height, const std::vector<std::uint32_t>& residual) {
  std::vector<std::int32_t> code;
  const auto at = [&](int x, int y) { return code[static_cast<std::size_t>(y * width + x)]; };
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const std::uint32_t r = residual[code.size()];
      std::int32_t guess = 0;
      if (x > 0 && y > 0) {
        std::int32_t near[] = {at(x - 1, y), at(x, y - 1), at(x - 1, y) + at(x, y - 1) - at(x - 1, y - 1)};
        std::sort(std::begin(near), std::end(near));
        guess = near[1];
      } else if (x > 0 || y > 0) {
        guess = x > 0 ? at(x - 1, y) : at(x, y - 1);
      }
      code.push_back(guess + static_cast<std::int32_t>(r >> 1 ^ (0 - (r & 1))));
    }
  return code;
}

std::vector<double> decoded(const Rough& field, const CodedField& coded) {
  std::vector<double> values;
  for (const auto code : codes_of(field.width, field.height, coded.residual)) values.push_back(decoded(coded, code));
  return values;
}

}  // namespace

TEST(FieldCodes, BringEveryValueBackWithinTheirPromise) {
  for (const double offset : {0.0, 3e5, -20.0}) {
    const Rough field = rough(90, 70, 1e5, offset);
    const CodedField coded = code_field(field.width, field.height, field.values, field.known, true);
    const auto values = decoded(field, coded);
    for (std::size_t k = 0; k < values.size(); ++k) {
      if (!field.known[k]) continue;
      const double away = std::abs(field.values[k] - coded.centre);
      EXPECT_NEAR(values[k], field.values[k], 1.01e-3 * std::hypot(away, coded.width)) << k;
    }
  }
}

TEST(FieldCodes, OfADisplacementAreFineOverItsWholeRange) {
  const Rough field = rough(64, 64, 1e-6, 2e-6);
  const CodedField coded = code_field(field.width, field.height, field.values, field.known, false);
  const auto values = decoded(field, coded);
  std::vector<double> kept;
  for (std::size_t k = 0; k < values.size(); ++k)
    if (field.known[k]) kept.push_back(field.values[k]);
  const auto [least, most] = std::minmax_element(kept.begin(), kept.end());
  for (std::size_t k = 0; k < values.size(); ++k)
    if (field.known[k]) { EXPECT_NEAR(values[k], field.values[k], 3.1e-5 * (*most - *least)); }
}

TEST(FieldCodes, OfOneValueOrNoneStand) {
  const std::vector<double> one(12, -4.5);
  const std::vector<std::uint8_t> all(12, 1), none(12, 0);
  for (const bool companded : {false, true}) {
    const CodedField coded = code_field(4, 3, one, all, companded);
    for (const auto code : codes_of(4, 3, coded.residual)) EXPECT_DOUBLE_EQ(decoded(coded, code), -4.5);
    const CodedField empty = code_field(4, 3, one, none, companded);
    for (const auto residual : empty.residual) EXPECT_EQ(residual, 0u);
  }
}

RC_GTEST_PROP(FieldCodes, ResidualsAndCodesAreEachOthersInverse, ()) {
  const int width = *rc::gen::inRange(1, 12), height = *rc::gen::inRange(1, 12);
  const auto count = static_cast<std::size_t>(width * height);
  const auto codes = *rc::gen::container<std::vector<std::int32_t>>(count, rc::gen::inRange(-5000, 5000));
  std::vector<double> values(codes.begin(), codes.end());
  const CodedField coded = code_field(width, height, values, std::vector<std::uint8_t>(count, 1), false);
  const auto back = codes_of(width, height, coded.residual);
  for (std::size_t k = 0; k < count; ++k)
    RC_ASSERT(std::abs(decoded(coded, back[k]) - values[k]) <= 0.6 * coded.width / coded.levels + 1e-9);
}

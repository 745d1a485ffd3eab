#include "report/field_codes.hpp"

#include <algorithm>
#include <cmath>

namespace arenite::report {
namespace {

constexpr double fine = 16384;  // codes over half the range, linear

std::int32_t median_prediction(const std::vector<std::int32_t>& code, int width, int x, int y) {
  const auto at = static_cast<std::size_t>(x) + static_cast<std::size_t>(width) * static_cast<std::size_t>(y);
  const auto row = static_cast<std::size_t>(width);
  if (x == 0 && y == 0) return 0;
  if (y == 0) return code[at - 1];
  if (x == 0) return code[at - row];
  const std::int32_t left = code[at - 1], below = code[at - row], corner = code[at - row - 1];
  const auto [low, high] = std::minmax(left, below);
  return std::clamp(left + below - corner, low, high);
}

Coding coding_of(std::vector<double> sample, bool companded, double levels) {
  if (sample.empty()) return {};
  const auto at = [&](double share) {
    const auto k = static_cast<std::ptrdiff_t>(share * static_cast<double>(sample.size() - 1));
    std::nth_element(sample.begin(), sample.begin() + k, sample.end());
    return sample[static_cast<std::size_t>(k)];
  };
  const double low = at(companded ? 0.001 : 0), high = at(companded ? 0.999 : 1);
  const double half = (high - low) / 2;
  // A field of one value has no range to divide.
  return {companded, (low + high) / 2, half > 0 ? half : std::max(1e-300, std::abs(low)), companded ? levels : fine};
}

}  // namespace

double Coding::decoded(std::int32_t code) const {
  const double t = code / levels;
  return centre + width * (companded ? std::sinh(t) : t);
}

CodedField code_field(int width, int height, const std::vector<double>& values, const std::vector<std::uint8_t>& known,
                      bool companded, double levels) {
  std::vector<double> sample;
  for (std::size_t k = 0; k < values.size(); ++k)
    if (known[k] && std::isfinite(values[k])) sample.push_back(values[k]);
  CodedField out{coding_of(std::move(sample), companded, levels), std::vector<std::uint32_t>(values.size())};
  const Coding& c = out.coding;
  std::vector<std::int32_t> code(values.size());
  std::size_t k = 0;
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x, ++k) {
      const std::int32_t guess = median_prediction(code, width, x, y);
      const double t = (values[k] - c.centre) / c.width;
      code[k] = known[k] && std::isfinite(t) ? static_cast<std::int32_t>(std::lround(c.levels * (companded ? std::asinh(t) : t))) : guess;
      const std::int32_t off = code[k] - guess;
      out.residual[k] = static_cast<std::uint32_t>(off) << 1 ^ static_cast<std::uint32_t>(off >> 31);
    }
  return out;
}

std::vector<std::int32_t> codes_of(int width, int height, const std::vector<std::uint32_t>& residual) {
  std::vector<std::int32_t> code(residual.size());
  std::size_t k = 0;
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x, ++k)
      code[k] = median_prediction(code, width, x, y) + static_cast<std::int32_t>(residual[k] >> 1 ^ (0 - (residual[k] & 1)));
  return code;
}

}  // namespace arenite::report

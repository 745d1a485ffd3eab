#include "report/number_block.hpp"

#include <zlib.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "core/ranks.hpp"

namespace arenite::report {
namespace {

constexpr double fine_codes = 16384;  // codes over half the range, linear

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

/// Without residuals.
CodedField coding_of(const std::vector<double>& sample, bool companded, double levels) {
  if (sample.empty()) return {};
  const double low = at_share(sample, companded ? 0.001 : 0), high = at_share(sample, companded ? 0.999 : 1);
  const double half = (high - low) / 2;
  // A field of one value has no range to divide.
  return {companded, (low + high) / 2, half > 0 ? half : std::max(1e-300, std::abs(low)),
          companded ? levels : fine_codes};
}

}  // namespace

static_assert(std::endian::native == std::endian::little, "the block's bytes are written as they lie in memory");

template <class T> NumberRef NumberBlock::add(std::span<const T> values, const char* type, std::string unit) {
  NumberRef ref{bytes_.size(), values.size(), type, std::move(unit)};
  bytes_.resize(bytes_.size() + values.size_bytes());
  const auto* from = reinterpret_cast<const std::uint8_t*>(values.data());
  std::uint8_t* to = bytes_.data() + ref.offset;
  for (std::size_t rank = 0; rank < sizeof(T); ++rank)
    for (std::size_t k = 0; k < values.size(); ++k) *to++ = from[k * sizeof(T) + rank];
  return ref;
}

NumberRef NumberBlock::add_reals(std::span<const double> values, std::string unit) {
  const std::vector<float> narrow(values.begin(), values.end());
  return add<float>(narrow, "f4", std::move(unit));
}

NumberRef NumberBlock::add_coarse(std::span<const double> values, std::string unit) {
  std::vector<float> narrow(values.begin(), values.end());
  for (float& value : narrow)
    if (std::isfinite(value)) value = std::bit_cast<float>((std::bit_cast<std::uint32_t>(value) + 0x800u) & ~0xfffu);
  return add<float>(narrow, "f4", std::move(unit));
}

NumberRef NumberBlock::add_narrowest(const std::vector<std::uint32_t>& values) {
  const std::uint32_t largest = values.empty() ? 0 : std::ranges::max(values);
  if (largest < 0x100) return add<std::uint8_t>(std::vector<std::uint8_t>(values.begin(), values.end()), "u1");
  if (largest < 0x10000) return add<std::uint16_t>(std::vector<std::uint16_t>(values.begin(), values.end()), "u2");
  return add<std::uint32_t>(values, "u4");
}

NumberRef NumberBlock::add_integers(std::span<const std::int32_t> values) { return add<std::int32_t>(values, "i4"); }

std::string NumberBlock::text() const { return packed_text(bytes_); }

std::string packed_text(std::span<const std::uint8_t> bytes) {
  uLongf length = compressBound(static_cast<uLong>(bytes.size()));
  std::vector<std::uint8_t> packed(length);
  const int status = compress2(packed.data(), &length, bytes.data(), static_cast<uLong>(bytes.size()), 6);
  if (status != Z_OK) throw std::runtime_error("zlib could not compress the page's numbers");
  packed.resize(length);
  return base64(packed);
}

std::string base64(std::span<const std::uint8_t> bytes) {
  static constexpr char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t k = 0; k < bytes.size(); k += 3) {
    const std::size_t left = std::min<std::size_t>(3, bytes.size() - k);
    std::uint32_t triple = static_cast<std::uint32_t>(bytes[k]) << 16;
    if (left > 1) triple |= static_cast<std::uint32_t>(bytes[k + 1]) << 8;
    if (left > 2) triple |= bytes[k + 2];
    text += digits[triple >> 18];
    text += digits[(triple >> 12) & 63];
    text += left > 1 ? digits[(triple >> 6) & 63] : '=';
    text += left > 2 ? digits[triple & 63] : '=';
  }
  return text;
}

CodedField code_field(int width, int height, const std::vector<double>& values, const std::vector<std::uint8_t>& known,
                      bool companded, double levels) {
  std::vector<double> sample;
  for (std::size_t k = 0; k < values.size(); ++k)
    if (known[k] && std::isfinite(values[k])) sample.push_back(values[k]);
  CodedField out = coding_of(sample, companded, levels);
  std::vector<std::int32_t> code(values.size());
  std::size_t k = 0;
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x, ++k) {
      const std::int32_t guess = median_prediction(code, width, x, y);
      const double t = (values[k] - out.centre) / out.width;
      code[k] = known[k] && std::isfinite(t)
                    ? static_cast<std::int32_t>(std::lround(out.levels * (companded ? std::asinh(t) : t)))
                    : guess;
      const std::int32_t off = code[k] - guess;
      out.residual.push_back(static_cast<std::uint32_t>(off) << 1 ^ static_cast<std::uint32_t>(off >> 31));
    }
  return out;
}

Numbers numbers_of(const CodedField& c, NumberBlock& block) {
  return {{"law", c.companded ? "sinh" : "linear"},
          {"centre", c.centre},
          {"width", c.width},
          {"levels", c.levels},
          {"residual", block.add_indices(c.residual)}};
}

}  // namespace arenite::report

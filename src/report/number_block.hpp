#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "core/mapped.hpp"
#include "statistics/numbers.hpp"

namespace arenite::report {

/// Where an array lies in a NumberBlock: byte offset, number of elements, type "f4", "u1", "u2", "u4" or "i4", and its
/// SI unit.
struct NumberRef {
  std::size_t offset = 0;
  std::size_t count = 0;
  const char* type = "f4";
  std::string unit = {};

  /// {"at", "n", "as"}, as a document says where its arrays are; "unit" where they have one.
  operator Numbers() const {
    Numbers j{{"at", offset}, {"n", count}, {"as", type}};
    if (!unit.empty() && unit != "1") j["unit"] = unit;
    return j;
  }
};

/// Arrays of numbers as the page carries them: little-endian, the bytes of equal rank of one array side by side (which
/// lets deflate find the repeats of exponents and high bytes), all of them deflated together and written in base64.
class NumberBlock {
 public:
  NumberRef add_reals(std::span<const double> values, std::string unit = "");  ///< rounded to float32
  NumberRef add_coarse(std::span<const double> values,
                       std::string unit = "");  ///< float32 with 11 bits behind the first: three digits, half the bytes
  /// Whole numbers from 0 on, in the narrowest of u1, u2, u4.
  template <class Range = std::vector<std::uint32_t>> NumberRef add_indices(const Range& values) {
    return add_narrowest(mapped(values, [](auto value) { return static_cast<std::uint32_t>(value); }));
  }
  NumberRef add_integers(std::span<const std::int32_t> values);  ///< i4

  std::size_t size() const { return bytes_.size(); }
  /// The whole block as packed_text.
  std::string text() const;

 private:
  NumberRef add_narrowest(const std::vector<std::uint32_t>& values);
  template <class T> NumberRef add(std::span<const T> values, const char* type, std::string unit = "");
  std::vector<std::uint8_t> bytes_;
};

/// Deflated (zlib) and in base64 (RFC 4648, with padding).
std::string packed_text(std::span<const std::uint8_t> bytes);
std::string base64(std::span<const std::uint8_t> bytes);

/// A field on a grid as whole numbers that deflate well: a code v = centre + width code/levels, or, companded, centre +
/// width sinh(code/levels), whose steps widen with the distance from the centre, so that a long tail costs few codes.
/// Each node's code less a prediction from its neighbours to the left and below (the median of both and of left + below
/// - their corner), with the sign in the lowest bit. The first node is predicted as 0. Nodes that are left out take the
/// prediction.
struct CodedField {
  bool companded = false;
  double centre = 0, width = 1, levels = 1;
  std::vector<std::uint32_t> residual = {};
};

/// The field with its coding, residuals in the block.
Numbers numbers_of(const CodedField& field, NumberBlock& block);

/// `known` says which nodes count. Companded: between the quantiles 0.001 and 0.999 every value comes back to
/// 0.5/levels of half their distance, beyond them to 0.5/levels of the distance from the middle. Otherwise to 3e-5 of
/// the whole range.
CodedField code_field(int width, int height, const std::vector<double>& values, const std::vector<std::uint8_t>& known,
                      bool companded, double levels = 500);

}  // namespace arenite::report

#pragma once
#include <cstdint>
#include <vector>

namespace arenite::report {

/// How a number became a code: v = centre + width code/levels, or centre + width sinh(code/levels), whose steps widen
/// with the distance from the centre, so that a long tail costs few codes.
struct Coding {
  bool companded = false;
  double centre = 0, width = 1, levels = 1;
  double decoded(std::int32_t code) const;
};

/// A field on a raster as whole numbers that deflate well: each node's code less a prediction from its neighbours to the
/// left and below (the median of both and of left + below - their corner), with the sign in the lowest bit. The
/// first node is predicted as 0. Nodes that are left out take the prediction.
struct CodedField {
  Coding coding;
  std::vector<std::uint32_t> residual;
};

/// `known` says which nodes count. Companded: between the quantiles 0.001 and 0.999 every value comes back to 0.5/levels
/// of half their distance, beyond them to 0.5/levels of the distance from the middle. Otherwise to 3e-5 of the whole range.
CodedField code_field(int width, int height, const std::vector<double>& values, const std::vector<std::uint8_t>& known,
                      bool companded, double levels = 500);

/// The codes behind the residuals, as the page finds them.
std::vector<std::int32_t> codes_of(int width, int height, const std::vector<std::uint32_t>& residual);

}  // namespace arenite::report

#pragma once
#include <cstdint>
#include <vector>

#include "thermal/inference/balance.hpp"
#include "thermal/inference/grain_rows.hpp"

namespace arenite::inference {

using Pixels = std::vector<std::vector<GrainPixel>>;  ///< of every grain

/// Root mean square of the pixels' values, K.
double root_mean_square(const std::vector<GrainPixel>& pixels);

/// Sums of squares that the equations of the pixels leave.
struct Misfit {
  double weighed = 0;      ///< in the errors that the equations were weighed by, over their degrees of freedom
  double over_noise = 0;   ///< in the measured noise alone, likewise
  double over_signal = 0;  ///< median size of what is left over that of the signal: one lost grain does not decide it
};

/// Equations of all grains' pixels. Everything that is given stays with the caller.
class PixelEquations {
 public:
  /// `material` of every grain; `model_error` as a share of a grain's signal; `contact_margin` in m.
  PixelEquations(const Placed& placed, const Pixels& pixels, const std::vector<std::int32_t>& material, const Footprint& footprint, double model_error,
                 double contact_margin)
      : placed_(placed), pixels_(pixels), material_(material), footprint_(footprint), model_error_(model_error), contact_margin_(contact_margin) {}

  void add_to(NormalEquations& equations, const Unknowns& unknowns);
  /// At the solution x; pixels have as many degrees of freedom as there are beyond `taken`.
  Misfit misfit(const std::vector<double>& x, double taken) const;

 private:
  struct Block {
    std::vector<int> columns;
    std::vector<double> rows, right, weight, value, noise;
  };

  void add_grain(NormalEquations& equations, const Unknowns& unknowns, std::size_t g);

  const Placed& placed_;
  const Pixels& pixels_;
  const std::vector<std::int32_t>& material_;
  const Footprint& footprint_;
  double model_error_, contact_margin_;
  std::vector<Block> blocks_;
};

}  // namespace arenite::inference

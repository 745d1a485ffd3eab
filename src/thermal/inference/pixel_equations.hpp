#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/threads.hpp"
#include "thermal/inference/balance.hpp"
#include "thermal/inference/grain_rows.hpp"

namespace arenite::inference {

/// The pixels of every grain whose centres are farther from the rim than its margin, and from all its contact points
/// than half of theirs (margins in pixels). In a periodic direction images of a grain count, too.
Pixels pixels_of_grains(const ThermoelasticPicture& picture, const Packing& packing, const Touches& touches,
                        double rim_margin, double contact_margin);

/// Root mean square of the pixels' values, K.
double root_mean_square(const std::vector<GrainPixel>& pixels);

/// Equations of the pixels of one grain (NormalEquations::add).
struct PixelEquations {
  std::vector<int> columns;
  std::vector<double> rows, right, weight;
  std::vector<double> model;  ///< standard error of the field in every pixel, over the model error, K
  std::span<const GrainPixel> pixels;

  /// What is left of equation q at the solution x, K.
  double left(std::size_t q, const std::vector<double>& x) const;
};

/// The equations of all grains that have pixels and touches, without weights. `contact_margin` in m. Grains are shared
/// out among the pool.
std::vector<PixelEquations> pixel_equations(const Unknowns& unknowns, const Placed& placed, const Pixels& pixels,
                                            const PointSpread& spread, double contact_margin, const ThreadPool& pool);

/// Weighs pixels by their errors and by the model error of the field, a share of a grain's signal. Those that `x`
/// leaves off by more than `most` of these errors count less (Huber); 0: all count alike.
void weigh(std::vector<PixelEquations>& equations, double model_error, const std::vector<double>& x, double most);

/// Sums of squares that the equations of the pixels leave.
struct Misfit {
  double weighed = 0;  ///< in the errors of pixels and fields, each cut at `most`, over what they are on average where
                       ///< errors are as told
  double over_noise = 0;   ///< in the measured noise alone, over the degrees of freedom
  double over_signal = 0;  ///< median size of what is left over that of the signal: one lost grain does not decide it
};

/// What these leave at the solution x; pixels have as many degrees of freedom as there are beyond `taken`.
Misfit misfit(const std::vector<PixelEquations>& equations, const std::vector<double>& x, double model_error,
              double taken, double most);

}  // namespace arenite::inference

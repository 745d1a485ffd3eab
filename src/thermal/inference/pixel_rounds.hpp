#pragma once
#include <vector>

#include "core/threads.hpp"
#include "thermal/inference/grain_rows.hpp"
#include "thermal/inference/pixel_equations.hpp"

namespace arenite::inference {

/// Forces, centres and factors together, from a first solution for forces alone: Gauss-Newton rounds, each of which is
/// taken only as far as it lowers the sum of squares of all equations. Between rounds the model error of the fields,
/// the weights of pixels that are far off and the scatter of factors follow from what the last one left.
class PixelRounds {
 public:
  /// All of these must outlive it. `force` and `move` are the units of forces (N) and centres (m; 0: these stay),
  /// `shift` the error of what all pixels share (K).
  PixelRounds(const ForceProblem& problem, const ForceOptions& options, const Pixels& pixels, const PointSpread& spread,
              double pixel, Placed placed, double force, double shift);

  /// Forces with their errors; `fit` without `picture`.
  InferredForces solved();
  /// As it came to be, with the materials' factors that were fitted and without the scatter of single grains.
  Placed placed_by_material() const;

 private:
  /// What is known at one time: where grains are, what presses them, and how many times larger than given factors are.
  struct Known {
    Placed placed;
    std::vector<double> scale, own;  ///< of materials, of grains beside that of their material
    double shift = 0;                ///< of all pixels, in units of the unknown
  };

  Unknowns unknowns_of(double force, double shift) const;
  std::vector<PixelEquations> linearised(const Known& known) const;
  ForceEquations assembled(const Known& known, const std::vector<PixelEquations>& rows) const;
  double squares(const Known& known, const std::vector<PixelEquations>& rows) const;
  void add_beside_pixels(ForceEquations& equations, const Known& known) const;
  void add_positions(ForceEquations& equations, const Known& known) const;
  void add_factors(ForceEquations& equations, const Known& known) const;
  std::vector<double> as_unknowns(const Known& known) const;
  void take(Known& known, const std::vector<double>& x) const;
  Misfit left() const;
  void weigh_anew();
  void learn_scatter(const ForceEquations& equations);
  bool improve();

  const ForceProblem& problem_;
  const ForceOptions& options_;
  const Pixels& pixels_;
  const PointSpread& spread_;
  const double side_;  ///< of a pixel, m
  const ThreadPool pool_;
  const Unknowns unknowns_;
  Known known_;
  std::vector<PixelEquations> rows_;  ///< linearised about what is known
  double model_error_, scatter_ = 0.01;
  bool settled_ = false;  ///< the last round changed next to nothing
};

}  // namespace arenite::inference

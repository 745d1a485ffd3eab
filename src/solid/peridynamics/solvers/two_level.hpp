#pragma once
#include <vector>

#include "solid/peridynamics/solvers/coarse_space.hpp"

namespace arenite::peridynamics {

/// The preconditioner of the static solve: Chebyshev steps on the 2 x 2 block diagonal, a correction on the coarse
/// space cut by grain, and the same steps again, all in single precision. Symmetric and positive, as conjugate
/// gradients ask.
class TwoLevel {
 public:
  TwoLevel(const Bonds& bonds, Pieces pieces, const std::vector<std::uint8_t>& prescribed);

  /// z := M r, where z comes in as first_step() times D^-1 r.
  void apply(const Bonds& bonds, const Field<float>& r, Field<float>& z);

  float first_step() const { return coefficient_[0].b; }
  BlockPlane inverse() const { return inverse_.plane(); }
  std::size_t loose_nodes() const { return inverse_.loose; }
  const CoarseSpace& coarse() const { return coarse_; }

  static constexpr int degree = 4;

 private:
  TwoLevel(const Bonds& bonds, Pieces pieces, const std::vector<std::uint8_t>& prescribed,
           const BlockDiagonal<double>& diagonal);

  struct Coefficient {
    float a, b;
  };

  InverseDiagonal inverse_;
  CoarseSpace coarse_;
  Field<float> other_, residual_;
  std::array<Coefficient, degree> coefficient_;
};

}  // namespace arenite::peridynamics

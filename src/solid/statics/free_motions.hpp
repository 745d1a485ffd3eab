#pragma once
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include "solid/statics/residual.hpp"

namespace arenite::statics {

/// Motions that nothing in a sample resists, each of norm 1 and at right angles to the others. The answer to a force
/// does not say how far such parts move, and in a solve rounding alone would carry them away.
template <int D> class FreeMotions {
 public:
  /// Of a force or a displacement, what lies along these motions.
  template <class T> void leave_out(const Grid& grid, FieldIn<D, T>& field) const {
    for (const FieldIn<D, double>& motion : motions_) {
      double along = 0;
      grid.each([&](std::ptrdiff_t i, int) {
        for (int c = 0; c < D; ++c) along += motion[c][i] * field[c][i];
      });
      grid.each([&](std::ptrdiff_t i, int) {
        for (int c = 0; c < D; ++c) field[c][i] -= static_cast<T>(along * motion[c][i]);
      });
    }
  }

  /// Takes a motion at right angles to those that are known.
  void add(const Grid& grid, FieldIn<D, double> motion) {
    const double norm = std::sqrt(square_norm(grid, motion));
    grid.each([&](std::ptrdiff_t i, int) { motion.set(i, motion.at(i) / norm); });
    motions_.push_back(std::move(motion));
  }

 private:
  std::vector<FieldIn<D, double>> motions_;
};

}  // namespace arenite::statics

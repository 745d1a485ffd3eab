#include "solid/peridynamics/exact_stretch.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/vec.hpp"
#include "solid/statics/residual.hpp"

namespace arenite::peridynamics {
namespace {

/// Keeps of the force on every node what its bonds can resist, and nothing where displacements are prescribed.
void hold_to_bonds(const Grid& grid, const BlockDiagonal<double>& diagonal, const std::vector<std::uint8_t>& prescribed,
                   Field<double>& f) {
  grid.each([&](std::ptrdiff_t i, int y) {
    const auto rows = prescribed[y];
    if (rows & x_prescribed) f.x[i] = 0;
    if (rows & y_prescribed) f.y[i] = 0;
    const double xx = diagonal.xx[i], xy = diagonal.xy[i], yy = diagonal.yy[i], trace = xx + yy;
    if (rows || xx * yy - xy * xy > 1e-9 * trace * trace || !(trace > 0)) return;
    f.set(i, Vec2{xx * f.x[i] + xy * f.y[i], xy * f.x[i] + yy * f.y[i]} / trace);
  });
}

/// A solve that found no end has moved from `before` to `after` along what resists least: true, and left free from now
/// on, where that is a motion that no bond resists linearly. No search for hinges by nodes finds some of them, such as
/// a flap on bonds in line. Second-order forces may push such a part, which linearly has no answer; exactly it turns
/// until they vanish. A soft part that is held stores more than 1e-9 of the energy of its nodes moved one by one, and
/// rounding less than 1e-16.
bool leave_free(const Bonds& bonds, const BlockDiagonal<double>& diagonal, const Field<double>& before,
                const Field<double>& after, statics::FreeMotions<2>& free) {
  const Grid& grid = bonds.grid;
  Field<double> motion(grid.padded_size()), f(grid.padded_size());
  grid.each([&](std::ptrdiff_t i, int) { motion.set(i, after.at(i) - before.at(i)); });
  free.leave_out(grid, motion);
  double held = 0;
  grid.each([&](std::ptrdiff_t i, int) {
    const Vec2 v = motion.at(i);
    held += diagonal.xx[i] * v.x * v.x + 2 * diagonal.xy[i] * v.x * v.y + diagonal.yy[i] * v.y * v.y;
  });
  if (!(std::abs(linear_force(bonds, motion, f)) <= 1e-13 * held)) return false;
  free.add(grid, std::move(motion));
  return true;
}

}  // namespace

double linear_force(const Bonds& bonds, const Field<double>& u, Field<double>& f) {
  const std::vector<std::uint8_t> none(static_cast<std::size_t>(bonds.grid.height), nothing_prescribed);
  return kernels_of(bonds).force(bonds, none.data(), pointers(u), pointers(f));
}

StaticReport solve_exact_stretch(const Bonds& bonds, double dx, const std::vector<std::uint8_t>& prescribed,
                                 StaticSolver& solver, Field<double>& u, double tolerance, int max_iterations,
                                 const Watch& watch) {
  const Grid& grid = bonds.grid;
  Field<double> body(grid.padded_size()), linear(grid.padded_size()), best;
  const double reference = statics::residual_reference(bonds, prescribed, u, body, linear);
  const auto diagonal = block_diagonal(bonds);
  statics::FreeMotions<2>& free = solver.free_motions();
  StaticReport total = solver.solve(bonds, u, tolerance, max_iterations, watch);
  if (!(reference > 0) || !total.converged) return total;
  const Watch later = [&](const Progress& p) {
    return !watch || watch({1, total.iterations + p.iterations, total.residual, 0, 0, 0});
  };
  double least = HUGE_VAL;
  for (int round = 0; round < 20; ++round) {
    exact_force(bonds, dx, u, body);
    hold_to_bonds(grid, diagonal, prescribed, body);
    free.leave_out(grid, body);
    total.residual = std::sqrt(statics::square_norm(grid, body)) / reference;
    total.converged = total.residual <= tolerance;
    if (total.converged) return total;
    if (!(total.residual < least)) break;
    least = total.residual;
    best = u;
    kernels(bonds.law).force(bonds, prescribed.data(), pointers(u), pointers(linear));
    for (std::ptrdiff_t i = grid.row(0), end = grid.row(grid.height); i < end; ++i)
      body.set(i, body.at(i) - linear.at(i));
    StaticReport more = solver.solve(bonds, u, 0.1 * tolerance, max_iterations, later, &body);
    while (!more.converged && !more.stopped && leave_free(bonds, diagonal, best, u, free)) {
      total.iterations += more.iterations;
      u = best;
      free.leave_out(grid, body);
      more = solver.solve(bonds, u, 0.1 * tolerance, max_iterations, later, &body);
    }
    total.iterations += more.iterations;
    total.history.insert(total.history.end(), more.history.begin(), more.history.end());
    if (more.stopped) {
      total.stopped = true;
      total.converged = false;
      return total;
    }
  }
  u = best;
  total.residual = least;
  return total;
}

}  // namespace arenite::peridynamics

#include <algorithm>
#include <cmath>
#include <numbers>

#include "geometry/close_pairs.hpp"
#include "inference/balance.hpp"
#include "inference/check_problem.hpp"
#include "inference/contact_forces.hpp"
#include "inference/finish.hpp"
#include "inference/grain_rows.hpp"

namespace arenite::inference {
namespace {

using Pixels = std::vector<std::vector<GrainPixel>>;

Placed placed_grains(const ForceProblem& problem) {
  const Grains& grains = problem.packing.grains;
  Placed placed;
  placed.length = problem.packing.domain.thickness;
  placed.radius = grains.radius;
  for (std::size_t g = 0; g < grains.size(); ++g) {
    placed.factor.push_back(problem.factor[static_cast<std::size_t>(grains.material[g])]);
    placed.found.push_back(grains.centre(g));
  }
  placed.centre = placed.found;
  placed.touches = touches_of_grains(problem.packing, placed.centre);
  placed.force.assign(2 * problem.packing.contacts.size(), 0.0);
  return placed;
}

/// Grains whose rims are nearer than a footprint reaches.
std::vector<std::vector<Near>> near_grains(const Packing& packing, double gap) {
  const Grains& grains = packing.grains;
  const Domain& d = packing.domain;
  std::vector<std::vector<Near>> near(grains.size());
  const auto add = [&](std::size_t i, std::size_t j) {
    const Vec2 apart = grains.centre(i) - grains.centre(j);
    near[i].push_back({j, apart - d.nearest_image(apart)});
  };
  if (d.tilt != 0) {  // few and for tests of other codes' cells: every pair
    for (std::size_t i = 0; i < grains.size(); ++i)
      for (std::size_t j = 0; j < grains.size(); ++j)
        if (i != j && norm(d.nearest_image(grains.centre(i) - grains.centre(j))) < grains.radius[i] + grains.radius[j] + gap) add(i, j);
    return near;
  }
  const geometry::Box box{d.wall[left].position, d.wall[bottom].position, d.width(), d.height(), d.periodic_x, d.periodic_y};
  for (const geometry::Pair& pair : geometry::close_pairs(grains.x, grains.y, grains.radius, box, gap)) {
    add(static_cast<std::size_t>(pair.i), static_cast<std::size_t>(pair.j));
    add(static_cast<std::size_t>(pair.j), static_cast<std::size_t>(pair.i));
  }
  return near;
}

double root_mean_square(const std::vector<GrainPixel>& pixels) {
  double sum = 0;
  for (const GrainPixel& p : pixels) sum += static_cast<double>(p.value) * p.value;
  return pixels.empty() ? 0 : std::sqrt(sum / static_cast<double>(pixels.size()));
}

/// Mean force of a contact by the sum rule, from the grains' mean warming, N.
double typical_force(const Placed& placed, const Pixels& pixels) {
  double sum = 0, touches = 0;
  for (std::size_t g = 0; g < pixels.size(); ++g) {
    sum += std::numbers::pi * placed.radius[g] * placed.length * root_mean_square(pixels[g]) / std::abs(placed.factor[g]);
    touches += static_cast<double>(placed.touches[g].size());
  }
  return sum > 0 ? sum / touches : 1;
}

/// Equations of one grain's pixels.
class PixelEquations {
 public:
  PixelEquations(const Placed& placed, const Pixels& pixels, const Footprint& footprint, double model_error,
                 double contact_margin)
      : placed_(placed), pixels_(pixels), footprint_(footprint), model_error_(model_error), contact_margin_(contact_margin) {}

  void add_to(NormalEquations& equations, const Unknowns& unknowns) {
    for (std::size_t g = 0; g < pixels_.size(); ++g)
      if (!pixels_[g].empty() && !placed_.touches[g].empty()) add_grain(equations, unknowns, g);
  }
  /// Sum of squares of what the equations leave at the solution x, in standard errors, over the degrees of freedom that
  /// pixels have beyond `taken`.
  double misfit(const std::vector<double>& x, double taken) const {
    double sum = 0, count = 0;
    for (const Block& b : blocks_)
      for (std::size_t q = 0; q < b.right.size(); ++q, count += 1) {
        double left = b.right[q];
        for (std::size_t k = 0; k < b.columns.size(); ++k) left -= b.rows[q * b.columns.size() + k] * x[static_cast<std::size_t>(b.columns[k])];
        sum += left * left * b.weight[q];
      }
    return count > 0 ? sum / std::max(0.1 * count, count - taken) : 0;
  }

 private:
  struct Block {
    std::vector<int> columns;
    std::vector<double> rows, right, weight;
  };

  void add_grain(NormalEquations& equations, const Unknowns& unknowns, std::size_t g) {
    const auto& touches = placed_.touches[g];
    const std::size_t z = touches.size();
    const GrainRows found = rows_of_grain(placed_, g, pixels_[g], footprint_);
    Block b{columns_of(unknowns, g, touches), {}, {}, {}};
    const std::size_t n = b.columns.size();
    b.rows.assign(n * pixels_[g].size(), 0.0);
    const double signal = root_mean_square(pixels_[g]);
    for (std::size_t q = 0; q < pixels_[g].size(); ++q) {
      double* row = &b.rows[n * q];
      for (std::size_t k = 0; k < 2 * z; ++k) row[k] = unknowns.force * found.response[2 * z * q + k];
      if (unknowns.move > 0) {
        row[2 * z] += unknowns.move * found.shift[2 * q], row[2 * z + 1] += unknowns.move * found.shift[2 * q + 1];
        for (std::size_t k = 0; k < z; ++k) add_turn(unknowns, touches, k, found.turn[z * q + k], row);
      }
      const double error = pixels_[g][q].error, close = std::max(1.0, contact_margin_ / pixels_[g][q].to_contact);
      const double model = model_error_ * signal * close * close * close;
      b.right.push_back(pixels_[g][q].value - found.spill[q]);
      b.weight.push_back(1 / (error * error + model * model));
    }
    equations.add(b.columns, b.rows, b.right, b.weight);
    blocks_.push_back(std::move(b));
  }

  const Placed& placed_;
  const Pixels& pixels_;
  const Footprint& footprint_;
  double model_error_, contact_margin_;  // share of a grain's signal; m
  std::vector<Block> blocks_;
};

/// Centres stay near where they were found.
void add_positions(NormalEquations& equations, const Unknowns& unknowns, const Placed& placed, double error) {
  if (unknowns.move <= 0) return;
  const double weight = unknowns.move * unknowns.move / (error * error);
  for (std::size_t g = 0; g < unknowns.grains; ++g) {
    const Vec2 back = (1 / unknowns.move) * (placed.found[g] - placed.centre[g]);
    equations.add_diagonal(unknowns.centre(g), weight, back.x);
    equations.add_diagonal(unknowns.centre(g) + 1, weight, back.y);
  }
}

/// Takes over the solution; returns the largest move of a centre, m.
void take(Placed& placed, const Packing& packing, const Unknowns& unknowns, const std::vector<double>& x) {
  for (std::size_t k = 0; k < 2 * unknowns.contacts; ++k) placed.force[k] = unknowns.force * x[k];
  if (unknowns.move <= 0) return;
  for (std::size_t g = 0; g < unknowns.grains; ++g) {
    const auto u = static_cast<std::size_t>(unknowns.centre(g));
    placed.centre[g] += unknowns.move * Vec2{x[u], x[u + 1]};
  }
  placed.touches = touches_of_grains(packing, placed.centre);
}

}  // namespace

InferredForces infer_from_pixels(const ForceProblem& problem, const SwingPicture& picture, const ForceOptions& options) {
  check_problem(problem, options, true);
  check_picture(picture);
  const Packing& packing = problem.packing;
  Placed placed = placed_grains(problem);
  const Pixels pixels = pixels_of_grains(picture, packing, placed.touches, options);
  check_pixels(packing, pixels);
  const Footprint footprint(picture.pixel, options.blur);
  placed.near = near_grains(packing, footprint.reach);
  Unknowns unknowns{packing.contacts.size(), packing.grains.size(), typical_force(placed, pixels), 0};
  // Balance takes three of the forces' unknowns a grain.
  const double taken = std::max(0.0, 2.0 * static_cast<double>(unknowns.contacts) - 3.0 * static_cast<double>(unknowns.grains));
  double model_error = options.model_error;
  for (int iteration = 1;; ++iteration) {
    // Without forces centres are of no consequence: the first solution is of forces only.
    const double position_error = options.position_error * picture.pixel;
    unknowns.move = iteration > 1 ? position_error : 0;
    NormalEquations equations(unknowns.count());
    PixelEquations rows(placed, pixels, footprint, model_error, options.contact_margin * picture.pixel);
    rows.add_to(equations, unknowns);
    add_balance(equations, unknowns, packing, placed.touches, placed.force, options.gravity, options.balance_error * unknowns.force);
    add_walls(equations, unknowns, packing.contacts, problem.walls);
    add_energy(equations, unknowns, packing, options.prior > 0 ? options.prior : 10);
    add_positions(equations, unknowns, placed, position_error);
    const std::vector<double> x = options.inequality == Inequality::cone && iteration == options.iterations
                                      ? equations.solve_in_cone(static_cast<int>(unknowns.contacts), options.friction)
                                      : equations.solve();
    take(placed, packing, unknowns, x);
    const double misfit = rows.misfit(x, taken);
    if (iteration < options.iterations) {
      if (options.fit_model_error) model_error = std::max(1e-4, model_error * std::sqrt(misfit));
      continue;
    }
    InferredForces out = finish(problem, options, equations, unknowns, placed.touches, placed.force);
    out.residual = std::sqrt(misfit);
    for (const auto& of_grain : pixels) out.pixels += of_grain.size();
    out.iterations = iteration;
    return out;
  }
}

}  // namespace arenite::inference

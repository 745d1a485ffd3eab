#include "thermal/inference/pixel_rounds.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace arenite::inference {
namespace {

constexpr double unknown_factor = 3;  // relative: of a factor of which nothing is known
constexpr double least_model_error = 1e-4;
constexpr double least_scatter = 1e-3, most_scatter = 0.3;  // of factors by grain
constexpr double shortest_step = 0.05, small_gain = 1e-4, small_change = 0.02;

std::vector<double> between(const std::vector<double>& from, const std::vector<double>& to, double share) {
  std::vector<double> x = from;
  for (std::size_t u = 0; u < x.size(); ++u) x[u] += share * (to[u] - from[u]);
  return x;
}

}  // namespace

PixelRounds::PixelRounds(const ForceProblem& problem, const ForceOptions& options, const Pixels& pixels,
                         const PointSpread& spread, double pixel, Placed placed, double force, double shift)
    : problem_(problem),
      options_(options),
      pixels_(pixels),
      spread_(spread),
      side_(pixel),
      pool_(options.threads),
      unknowns_(unknowns_of(force, shift)),
      model_error_(options.model_error) {
  known_.placed = std::move(placed);
  known_.scale.assign(unknowns_.scales, 1.0);
  known_.own.assign(unknowns_.own_factors, 1.0);
}

Unknowns PixelRounds::unknowns_of(double force, double shift) const {
  const Packing& packing = problem_.packing;
  const std::size_t grains = packing.grains.size();
  const bool alone = options_.iterations == 1;  // without forces centres and factors are of no consequence
  return {packing.contacts.size(),
          grains,
          force,
          alone ? 0 : options_.position_error * side_,
          options_.own_factors && !alone ? grains : 0,
          options_.fit_factors && !alone ? problem_.factor.size() : 0,
          shift};
}

std::vector<PixelEquations> PixelRounds::linearised(const Known& known) const {
  return pixel_equations(unknowns_, known.placed, pixels_, spread_, options_.contact_margin * side_, pool_);
}

ForceEquations PixelRounds::assembled(const Known& known, const std::vector<PixelEquations>& rows) const {
  ForceEquations equations(problem_.packing, unknowns_);
  for (const PixelEquations& of_grain : rows)
    equations.add(of_grain.columns, of_grain.rows, of_grain.right, of_grain.weight);
  add_beside_pixels(equations, known);
  return equations;
}

/// The sum of squares of all equations where things are: what `assembled` would say, without assembling the pixels'.
double PixelRounds::squares(const Known& known, const std::vector<PixelEquations>& rows) const {
  const std::vector<double> x = as_unknowns(known);
  ForceEquations others(problem_.packing, unknowns_);
  add_beside_pixels(others, known);
  double sum = others.squares(x);
  for (const PixelEquations& of_grain : rows)
    for (std::size_t q = 0; q < of_grain.right.size(); ++q) sum += of_grain.weight[q] * squared(of_grain.left(q, x));
  return sum;
}

void PixelRounds::add_beside_pixels(ForceEquations& equations, const Known& known) const {
  equations.add_balance(known.placed.touches, known.placed.force, options_.balance_error * unknowns_.force,
                        known.scale);
  equations.add_walls(problem_.walls);
  equations.add_energy(options_.prior > 0 ? options_.prior : 10);
  add_positions(equations, known);
  add_factors(equations, known);
  if (unknowns_.shift > 0) equations.add_diagonal(unknowns_.common_shift(), 1, 0);
}

/// Centres stay near where they were found.
void PixelRounds::add_positions(ForceEquations& equations, const Known& known) const {
  if (unknowns_.move <= 0) return;
  for (std::size_t g = 0; g < unknowns_.grains; ++g) {
    const double error = std::max(options_.position_error * side_, problem_.unseen_error(g));
    const double weight = squared(unknowns_.move / error);
    const Vec2 back = (1 / unknowns_.move) * (known.placed.found[g] - known.placed.centre[g]);
    equations.add_diagonal(unknowns_.centre(g), weight, back.x);
    equations.add_diagonal(unknowns_.centre(g) + 1, weight, back.y);
  }
}

/// Factors stay near what was given, as far as nothing else says: without a load only their ratio shows.
void PixelRounds::add_factors(ForceEquations& equations, const Known& known) const {
  const auto add = [&](int unknown, double scale, double error) {
    equations.add_diagonal(unknown, squared(scale / error), (1 - scale) / scale);
  };
  const double error = options_.factor_error > 0 ? options_.factor_error : unknown_factor;
  for (std::size_t m = 0; m < unknowns_.scales; ++m) add(unknowns_.scale(m), known.scale[m], error);
  for (std::size_t g = 0; g < unknowns_.own_factors; ++g) add(unknowns_.own_factor(g), known.own[g], scatter_);
}

/// Changes are none; forces and the shift are as they are.
std::vector<double> PixelRounds::as_unknowns(const Known& known) const {
  std::vector<double> x(static_cast<std::size_t>(unknowns_.count()), 0.0);
  for (std::size_t k = 0; k < 2 * unknowns_.contacts; ++k) x[k] = known.placed.force[k] / unknowns_.force;
  if (unknowns_.shift > 0) x[static_cast<std::size_t>(unknowns_.common_shift())] = known.shift;
  return x;
}

/// Takes over a solution.
void PixelRounds::take(Known& known, const std::vector<double>& x) const {
  Placed& placed = known.placed;
  // Half or double in one round at most: product of factor and force is far from linear beyond.
  const auto times = [&](int unknown) { return std::clamp(1 + x[static_cast<std::size_t>(unknown)], 0.5, 2.0); };
  for (std::size_t k = 0; k < 2 * unknowns_.contacts; ++k) placed.force[k] = unknowns_.force * x[k];
  for (std::size_t m = 0; m < unknowns_.scales; ++m) known.scale[m] *= times(unknowns_.scale(m));
  for (std::size_t g = 0; g < unknowns_.own_factors; ++g) known.own[g] *= times(unknowns_.own_factor(g));
  for (std::size_t g = 0; g < placed.factor.size(); ++g) {
    const auto m = static_cast<std::size_t>(placed.material[g]);
    placed.factor[g] =
        problem_.factor[m] * (known.scale.empty() ? 1 : known.scale[m]) * (known.own.empty() ? 1 : known.own[g]);
  }
  if (unknowns_.shift > 0) known.shift = x[static_cast<std::size_t>(unknowns_.common_shift())];
  if (unknowns_.move <= 0) return;
  for (std::size_t g = 0; g < unknowns_.grains; ++g) {
    const auto u = static_cast<std::size_t>(unknowns_.centre(g));
    placed.centre[g] += unknowns_.move * Vec2{x[u], x[u + 1]};
  }
  placed.touches = touches_of_grains(problem_.packing, placed.centre);
}

Misfit PixelRounds::left() const {
  // Balance takes three of the forces' unknowns a grain.
  const double taken =
      std::max(0.0, 2.0 * static_cast<double>(unknowns_.contacts) - 3.0 * static_cast<double>(unknowns_.grains));
  return misfit(rows_, as_unknowns(known_), model_error_, taken, options_.most_off);
}

void PixelRounds::weigh_anew() {
  if (options_.fit_model_error) {
    const double times = std::sqrt(left().weighed);
    model_error_ = std::max(least_model_error, model_error_ * times);
    settled_ = settled_ && std::abs(times - 1) < small_change;
  }
  weigh(rows_, model_error_, as_unknowns(known_), options_.most_off);
}

/// MacKay's fixed point: the mean square of the grains' own factors over the number of those that the data determine.
void PixelRounds::learn_scatter(const ForceEquations& equations) {
  if (unknowns_.own_factors == 0) return;
  const std::vector<double> variance = equations.inverse_diagonal();
  double determined = 0, sum = 0;
  for (std::size_t g = 0; g < unknowns_.own_factors; ++g) {
    const double own = known_.own[g];
    determined += 1 - variance[static_cast<std::size_t>(unknowns_.own_factor(g))] * squared(own / scatter_);
    sum += squared(own - 1);
  }
  if (!(determined > 0.05)) return;
  const double learned = std::clamp(std::sqrt(sum / determined), least_scatter, most_scatter);
  settled_ = settled_ && std::abs(learned / scatter_ - 1) < 5 * small_change;
  scatter_ = learned;
}

/// One round; false if there is nothing left to gain.
bool PixelRounds::improve() {
  const std::vector<double> now = as_unknowns(known_);
  const ForceEquations equations = assembled(known_, rows_);
  const double before = squares(known_, rows_);
  const std::vector<double> best = equations.solve();
  for (double step = 1; step > shortest_step; step *= 0.5) {
    Known tried = known_;
    take(tried, between(now, best, step));
    auto rows = linearised(tried);
    for (std::size_t k = 0; k < rows.size(); ++k) rows[k].weight = rows_[k].weight;
    const double after = squares(tried, rows);
    if (!(after < before)) continue;
    known_ = std::move(tried);
    rows_ = std::move(rows);
    settled_ = before - after < small_gain * before;
    learn_scatter(equations);
    return true;
  }
  return false;
}

InferredForces PixelRounds::solved() {
  rows_ = linearised(known_);
  weigh(rows_, model_error_, {}, 0);
  const ForceEquations first = assembled(known_, rows_);
  const bool cone = options_.inequality == Inequality::cone;
  take(known_, options_.iterations == 1 ? first.solution(options_) : first.solve());
  if (options_.iterations > 1) {
    rows_ = linearised(known_);
    weigh_anew();
    for (int round = 2; round <= options_.iterations && !settled_ && improve(); ++round) weigh_anew();
    if (cone) {
      take(known_, assembled(known_, rows_).solution(options_));
      rows_ = linearised(known_);
      weigh_anew();
    }
  }
  const ForceEquations last = options_.iterations > 1 ? assembled(known_, rows_) : first;
  InferredForces out = last.finish(options_, known_.placed.touches, known_.placed.force);
  const Misfit left = this->left();
  out.residual = std::sqrt(left.weighed);
  out.fit.over_noise = std::sqrt(left.over_noise), out.fit.over_signal = left.over_signal,
  out.fit.model_error = model_error_;
  for (std::size_t m = 0; m < known_.scale.size(); ++m) out.fit.factor_scale_error[m] *= known_.scale[m];
  out.fit.factor_scale = known_.scale;
  out.fit.shift = unknowns_.shift * known_.shift;
  out.fit.factor_scatter = known_.own.empty() ? 0 : scatter_;
  return out;
}

Placed PixelRounds::placed_by_material() const {
  Placed placed = known_.placed;
  for (std::size_t g = 0; g < known_.own.size(); ++g) placed.factor[g] /= known_.own[g];
  return placed;
}

}  // namespace arenite::inference

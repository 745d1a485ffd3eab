#include "solid/peridynamics/failure_equilibrium.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <variant>

#include "core/error.hpp"
#include "solid/peridynamics/bonded_aggregates.hpp"

namespace arenite::peridynamics {
namespace {

/// e . (u_j - u_i) of a bond, whose sign is that of its linearised stretch.
double extension(const Bond& b, const Field<double>& u) {
  const Offset e = b.step();
  return e.x * (u.x[b.j] - u.x[b.i]) + e.y * (u.y[b.j] - u.y[b.i]);
}

/// A parted bond along a step from one field to the next.
struct PartedBond {
  double modulus, start, change;  ///< of `extension`
  bool resisted;                  ///< in what the step was found with
};

bool fits(const FailureState& s, const PhaseMap& map, std::size_t padded, bool closes) {
  if (s.parted.size() != (closes ? padded : 0)) return false;
  for (const std::size_t size : {s.words.size(), s.words_at_setup.size(), s.u.x.size(), s.u.y.size()})
    if (size != padded) return false;
  const std::size_t strongest = s.strength > 0 ? padded : 0;
  for (const std::size_t size : {s.strongest_words.size(), s.strongest_u.x.size(), s.strongest_u.y.size()})
    if (size != strongest) return false;
  return s.width == map.width && s.height == map.height;
}

}  // namespace

FailureEquilibrium::FailureEquilibrium(const PhaseMap& map, const DamageOptions& options)
    : map_(map),
      options_(options),
      closes_(!options.cracks_stay_open),
      bonds_(make_bonds(map, options.stiffness, options.law, options.stop_at_voids)),
      way_(direction_of<2>(options.loading)),
      prescribed_(prescribed_levels<2>(map.height, options.loading, options.lower)),
      f_(bonds_.grid.padded_size()) {
  state_.width = map.width;
  state_.height = map.height;
  state_.u = f_;
  if (closes_) state_.parted = bonds_.words;
  make_cuts(bonds_, options.cuts);
  for (std::size_t i = 0; i < state_.parted.size(); ++i) state_.parted[i] ^= bonds_.words[i];
  resisting_ = bonds_;
}

void FailureEquilibrium::resume(const FailureState& s) {
  if (!fits(s, map_, bonds_.words.size(), closes_))
    throw InputError(
        "the stored state of a test belongs to a phase map of another size; run the load again from its start");
  state_ = s;
  bonds_.words = s.words;
  // The set-up lags behind the bonds: it is that of the bonds that it was once made for.
  resisting_.words = s.words_at_setup;
  classify_groups(resisting_, 0, map_.height - 1);
  auto aggregates = cut_into_aggregates(map_, resisting_, prescribed_);
  Buffer<Tie> tie;
  if (prune(resisting_, aggregates, prescribed_, tie).carrying == 0)
    throw InputError("in the stored state of a test the clamps are not connected; run the load again from its start");
  solver_.emplace(resisting_, std::move(aggregates), prescribed_);
}

/// What resists at the displacements as they are: whole bonds, and parted ones whose faces press on each other.
FailureEquilibrium::Joined FailureEquilibrium::join() {
  Joined joined;
  const Grid& grid = bonds_.grid;
  const bool set_up = state_.words_at_setup.size() == bonds_.words.size();
  int low = grid.height, high = -1;
  Buffer<std::uint32_t> pressed = state_.parted;
  for (int y = 0; closes_ && y < grid.height; ++y)
    each_bond_of_row(grid, state_.parted, y, [&](const Bond& b) {
      const bool resists =
          std::visit([&](const auto& law) { return law.resists_broken(extension(b, state_.u)); }, bonds_.law);
      if (!resists) pressed[b.i] &= ~(3u << (2 * b.d));
    });
  grid.each([&](std::ptrdiff_t i, int y) {
    const std::uint32_t word = closes_ ? bonds_.words[i] | pressed[i] : bonds_.words[i];
    joined.outside = joined.outside || (set_up && (word & ~state_.words_at_setup[i]) != 0);
    if (word == resisting_.words[i]) return;
    resisting_.words[i] = word;
    low = std::min(low, y);
    high = std::max(high, y);
  });
  if (high >= 0) classify_groups(resisting_, low, high);
  joined.changed = high >= 0;
  return joined;
}

void FailureEquilibrium::uniform_strain() {
  auto phase = map_.phase.begin();
  bonds_.grid.each([&](std::ptrdiff_t i, int y) {
    if (*phase++ != Phase::empty) state_.u.set(i, y * map_.dx * way_);
  });
}

/// Set-up for what resists; false if nothing ties the clamps any more. A part that hangs on one clamp alone goes along
/// with it, and may so meet the rest again; what stays loose is taken out.
bool FailureEquilibrium::prepare() {
  constexpr int most_looks = 4;
  for (int look = 1;; ++look) {
    const bool met = join().outside || look == 1;
    state_.words_at_setup = resisting_.words;
    auto aggregates = cut_into_aggregates(map_, resisting_, prescribed_);
    Buffer<Tie> tie;
    const Support support = prune(resisting_, aggregates, prescribed_, tie);
    if (closes_ && met && look < most_looks && support.held_below + support.held_above > 0) {
      follow_clamps(tie);
      continue;
    }
    if (support.carrying == 0) return false;
    if (support.carrying < support.solid) drop_loose(tie);
    solver_.emplace(resisting_, std::move(aggregates), prescribed_);
    return true;
  }
}

void FailureEquilibrium::follow_clamps(const Buffer<Tie>& tie) {
  bonds_.grid.each([&](std::ptrdiff_t i, int) {
    if (tie[i] == Tie::below) state_.u.set(i, {});
    if (tie[i] == Tie::above) state_.u.set(i, gauge() * way_);
  });
}

/// Takes all bonds of what does not carry out of the test, for good.
void FailureEquilibrium::drop_loose(const Buffer<Tie>& tie) {
  const auto carries = [&](std::ptrdiff_t i, int y) {
    return prescribed_[y] == both_prescribed || tie[i] == Tie::both;
  };
  for (int y = 0; y < map_.height; ++y)
    for (auto* words : {&bonds_.words, &state_.parted}) {
      if (words->size() == 0) continue;
      each_bond_of_row(bonds_.grid, *words, y, [&](const Bond& b) {
        if (!carries(b.i, b.y) || !carries(b.j, b.y + b.step().y)) (*words)[b.i] &= ~(3u << (2 * b.d));
      });
    }
}

bool FailureEquilibrium::watched(int iterations, double residual) {
  if (!options_.watch) return true;
  const double fallen = state_.strength > 0 ? (1 - state_.now.stress / state_.strength) / (1 - options_.end_stress) : 0;
  state_.share = std::clamp(std::max({fallen, state_.now.strain / options_.max_strain,
                                      static_cast<double>(state_.solves) / (options_.max_events + 1)}),
                            state_.share, 1.0);
  return options_.watch({state_.share, state_.iterations + iterations, residual, state_.broken.size(),
                         state_.now.strain, state_.now.stress});
}

StaticReport FailureEquilibrium::solve(int most) {
  const StaticReport report = solver_->solve(resisting_, state_.u, options_.tolerance, most,
                                             [&](const Progress& p) { return watched(p.iterations, p.residual); });
  state_.iterations += report.iterations;
  if (report.stopped) ending_ = Ending::stopped;
  return report;
}

/// Goes back along the last solve's step to where the energy is least, if faces that met on its way hold it up; false
/// if none does. The energy is convex and falls with every step, so which faces press is settled after finitely many.
bool FailureEquilibrium::shorten_step(const Field<double>& from) {
  std::vector<PartedBond> parted;
  for (int y = 0; y < map_.height; ++y)
    each_bond_of_row(bonds_.grid, state_.parted, y, [&](const Bond& b) {
      const double start = extension(b, from), modulus = bonds_.modulus(b.type) / std::pow(length(b.step()), 3);
      parted.push_back({modulus, start, extension(b, state_.u) - start, resisting_.type(b.i, b.d) != no_bond});
    });
  // Slope of the energy of parted bonds at a share of the step, less what the solve took for it.
  const auto extra_slope = [&](double share) {
    double sum = 0;
    for (const PartedBond& bond : parted) {
      const double now = bond.start + share * bond.change;
      const bool resists = std::visit([&](const auto& law) { return law.resists_broken(now); }, bonds_.law);
      if (resists != bond.resisted) sum += (resists ? 1 : -1) * bond.modulus * now * bond.change;
    }
    return sum;
  };
  if (!(extra_slope(1) > 0)) return false;
  Field<double> step(bonds_.grid.padded_size());
  bonds_.grid.each([&](std::ptrdiff_t i, int) { step.set(i, state_.u.at(i) - from.at(i)); });
  const double curvature = -linear_force(resisting_, step, f_);  // of what the solve knew, whose slope is 0 at its end
  double low = 0, high = 1;
  for (int halvings = 0; halvings < 40; ++halvings) {
    const double middle = (low + high) / 2;
    (curvature * (middle - 1) + extra_slope(middle) > 0 ? high : low) = middle;
  }
  bonds_.grid.each([&](std::ptrdiff_t i, int) { state_.u.set(i, from.at(i) + low * step.at(i)); });
  return true;
}

/// The field at unit strain from the last one: solves until the same faces press on each other at the end as at the
/// start. A set-up that the bonds have left behind is made anew.
FailureEquilibrium::Rest FailureEquilibrium::find_rest() {
  constexpr int tired = 25, most_solves = 100;
  const bool may_meet = closes_ && (!state_.broken.empty() || !options_.cuts.empty());
  bool fresh = false;
  Field<double> from;
  for (int solves = 0; solves < most_solves; ++solves) {
    if (join().outside) {
      if (!prepare()) return Rest::apart;
      fresh = true;
    }
    if (may_meet) from = state_.u;
    const StaticReport report = solve(fresh ? 4 * tired : 2 * tired);
    if (report.stopped) return Rest::not_found;
    if (!fresh && (report.iterations > tired || !report.converged)) {
      if (!prepare()) return Rest::apart;
      fresh = true;
      continue;
    }
    if (!report.converged) return Rest::not_found;
    if (!may_meet || report.iterations == 0) return Rest::found;
    fresh = false;
    if (!shorten_step(from) && !join().changed) return Rest::found;
  }
  return Rest::not_found;
}

/// False where the test ends here.
bool FailureEquilibrium::equilibrate() {
  ending_ = Ending::not_converged;
  ++state_.solves;
  const Rest rest = find_rest();
  unit_force_ = unit_energy_ = 0;
  if (rest != Rest::found) return rest == Rest::apart;
  unit_energy_ = -linear_force(resisting_, state_.u, f_) / 2;
  for (std::ptrdiff_t i = bonds_.grid.row(map_.height - 1), end = i + map_.width; i < end; ++i)
    unit_force_ -= dot(f_.at(i), way_);
  return true;
}

}  // namespace arenite::peridynamics

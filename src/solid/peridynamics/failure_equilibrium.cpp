#include "solid/peridynamics/failure_equilibrium.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <variant>

#include "core/error.hpp"
#include "solid/peridynamics/exact_stretch.hpp"

namespace arenite::peridynamics {
namespace {

/// A parted bond along a step from one field to the next.
struct PartedBond {
  double modulus, start, change;  ///< of `extension`
  bool resisted;                  ///< in what the step was found with
};

std::array<std::int32_t, 3> size_of(const PhaseMap& map) { return {map.width, map.height, 1}; }
std::array<std::int32_t, 3> size_of(const VoxelMap& map) { return {map.width, map.height, map.depth}; }

/// What forces between nodes of unit spacing are to be multiplied by, in m: in the plane they are per unit thickness.
double depth_of_node(const PhaseMap& /*map*/) { return 1; }
double depth_of_node(const VoxelMap& map) { return map.dx; }

/// Whether `words` are those of every node, as `whole` has them, or none.
template <class Words> bool have_size_of(const Words& words, const Words& whole, bool present) {
  const auto one = buffers(words), other = buffers(whole);
  for (std::size_t w = 0; w < one.size(); ++w)
    if (one[w].size() != (present ? other[w].size() : 0)) return false;
  return true;
}

template <int D>
bool fits(const FailureStateIn<D>& s, const std::array<std::int32_t, 3>& size, const BondsIn<D>& bonds, bool closes) {
  const bool strongest = s.strength > 0;
  for (int axis = 0; axis < D; ++axis)
    if (s.u[axis].size() != bonds.grid.padded_size() ||
        s.strongest_u[axis].size() != (strongest ? bonds.grid.padded_size() : 0))
      return false;
  return s.size == size && have_size_of(s.words, bonds.words, true) && have_size_of(s.parted, bonds.words, closes) &&
         have_size_of(s.words_at_setup, bonds.words, true) && have_size_of(s.strongest_words, bonds.words, strongest);
}

}  // namespace

template <int D>
FailureEquilibrium<D>::FailureEquilibrium(const MapIn<D>& map, const DamageOptionsIn<D>& options)
    : map_(map),
      options_(options),
      closes_(!options.cracks_stay_open),
      bonds_(bonds_of(map, options)),
      way_(statics::direction_of<D>(options.loading)),
      prescribed_(statics::prescribed_levels<D>(bonds_.grid.levels(), options.loading, options.lower)),
      f_(bonds_.grid.padded_size()) {
  state_.size = size_of(map);
  state_.u = f_;
  if (closes_) state_.parted = bonds_.words;
  make_cuts(bonds_, options.cuts);
  const auto parted = buffers(state_.parted);
  for (std::size_t w = 0; w < parted.size(); ++w)
    for (std::size_t i = 0; i < parted[w].size(); ++i) parted[w][i] ^= buffers(bonds_.words)[w][i];
  resisting_ = bonds_;
}

template <int D> void FailureEquilibrium<D>::resume(const FailureStateIn<D>& s) {
  if (!fits(s, size_of(map_), bonds_, closes_))
    throw InputError("the stored state of a test belongs to a map of another size; run the load again from its start");
  state_ = s;
  bonds_.words = s.words;
  // The set-up lags behind the bonds: it is that of the bonds that it was once made for.
  resisting_.words = s.words_at_setup;
  mark_changed(resisting_, 0, bonds_.grid.levels() - 1);
  Buffer<statics::Tie> tie;
  auto [support, aggregates] = carrying(map_, resisting_, prescribed_, tie);
  if (support.carrying == 0)
    throw InputError("in the stored state of a test the clamps are not connected; run the load again from its start");
  solver_.emplace(resisting_, std::move(aggregates), prescribed_);
}

/// What resists at the displacements as they are: whole bonds, and parted ones whose faces press on each other.
template <int D> typename FailureEquilibrium<D>::Joined FailureEquilibrium<D>::join() {
  Joined joined;
  const statics::Grid& grid = bonds_.grid;
  int low = grid.levels(), high = -1;
  WordsIn<D> pressed = state_.parted;
  for (int level = 0; closes_ && level < grid.levels(); ++level)
    each_bond_of_level(bonds_, state_.parted, level, [&](const auto& b) {
      const double now = extension(b, state_.u);
      if (!std::visit([&](const auto& law) { return law.resists_broken(now); }, options_.law)) clear(pressed, b.i, b.d);
    });
  const auto whole = buffers(bonds_.words), presses = buffers(pressed), at_setup = buffers(state_.words_at_setup);
  for (std::size_t w = 0; w < whole.size() && whole[w].size() > 0; ++w) {
    const bool set_up = at_setup[w].size() == whole[w].size();
    auto& resisting = buffers(resisting_.words)[w];
    grid.each([&](std::ptrdiff_t i, int level) {
      const std::uint32_t word = closes_ ? whole[w][i] | presses[w][i] : whole[w][i];
      joined.outside = joined.outside || (set_up && (word & ~at_setup[w][i]) != 0);
      if (word == resisting[i]) return;
      resisting[i] = word;
      low = std::min(low, level);
      high = std::max(high, level);
    });
  }
  if (high >= 0) mark_changed(resisting_, low, high);
  joined.changed = high >= 0;
  return joined;
}

template <int D> void FailureEquilibrium<D>::uniform_strain() {
  auto phase = map_.phase.begin();
  bonds_.grid.each([&](std::ptrdiff_t i, int level) {
    if (*phase++ != Phase::empty) state_.u.set(i, level * map_.dx * way_);
  });
}

/// Set-up for what resists; false if nothing ties the clamps any more. A part that hangs on one clamp alone goes along
/// with it, and may so meet the rest again; what stays loose is taken out.
template <int D> bool FailureEquilibrium<D>::prepare() {
  constexpr int most_looks = 4;
  for (int look = 1;; ++look) {
    const bool met = join().outside || look == 1;
    state_.words_at_setup = resisting_.words;
    Buffer<statics::Tie> tie;
    auto [support, aggregates] = carrying(map_, resisting_, prescribed_, tie);
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

template <int D> void FailureEquilibrium<D>::follow_clamps(const Buffer<statics::Tie>& tie) {
  bonds_.grid.each([&](std::ptrdiff_t i, int) {
    if (tie[i] == statics::Tie::below) state_.u.set(i, {});
    if (tie[i] == statics::Tie::above) state_.u.set(i, gauge() * way_);
  });
}

/// Takes all bonds of what does not carry out of the test, for good.
template <int D> void FailureEquilibrium<D>::drop_loose(const Buffer<statics::Tie>& tie) {
  const auto carries = [&](std::ptrdiff_t i, int level) {
    return prescribed_[level] == statics::every_component<D> || tie[i] == statics::Tie::both;
  };
  for (int level = 0; level < bonds_.grid.levels(); ++level)
    for (auto* words : {&bonds_.words, &state_.parted}) {
      if (buffers(*words)[0].size() == 0) continue;
      each_bond_of_level(bonds_, *words, level, [&](const auto& b) {
        const auto [first, last] = levels_of(b);
        if (!carries(b.i, first) || !carries(b.j, last)) clear(*words, b.i, b.d);
      });
    }
}

template <int D> bool FailureEquilibrium<D>::watched(int iterations, double residual) {
  if (!options_.watch) return true;
  const double fallen = state_.strength > 0 ? (1 - state_.now.stress / state_.strength) / (1 - options_.end_stress) : 0;
  state_.share = std::clamp(std::max({fallen, state_.now.strain / options_.max_strain,
                                      static_cast<double>(state_.solves) / (options_.max_events + 1)}),
                            state_.share, 1.0);
  return options_.watch({state_.share, state_.iterations + iterations, residual, state_.broken.size(),
                         state_.now.strain, state_.now.stress});
}

template <int D> statics::StaticReport FailureEquilibrium<D>::solve(int most) {
  const statics::StaticReport report =
      solver_->solve(resisting_, state_.u, options_.tolerance, most,
                     [&](const Progress& p) { return watched(p.iterations, p.residual); });
  state_.iterations += report.iterations;
  if (report.stopped) ending_ = Ending::stopped;
  return report;
}

/// Goes back along the last solve's step to where the energy is least, if faces that met on its way hold it up; false
/// if none does. The energy is convex and falls with every step, so which faces press is settled after finitely many.
template <int D> bool FailureEquilibrium<D>::shorten_step(const Displacements& from) {
  std::vector<PartedBond> parted;
  for (int level = 0; level < bonds_.grid.levels(); ++level)
    each_bond_of_level(bonds_, state_.parted, level, [&](const auto& b) {
      const double start = extension(b, from);
      const bool resisted = (word_at(resisting_.words, b.i, b.d) >> bit_of(b.d) & 3u) != no_bond;
      parted.push_back({stiffness_of(bonds_, b), start, extension(b, state_.u) - start, resisted});
    });
  // Slope of the energy of parted bonds at a share of the step, less what the solve took for it.
  const auto extra_slope = [&](double share) {
    double sum = 0;
    for (const PartedBond& bond : parted) {
      const double now = bond.start + share * bond.change;
      const bool resists = std::visit([&](const auto& law) { return law.resists_broken(now); }, options_.law);
      if (resists != bond.resisted) sum += (resists ? 1 : -1) * bond.modulus * now * bond.change;
    }
    return sum;
  };
  if (!(extra_slope(1) > 0)) return false;
  Displacements step(bonds_.grid.padded_size());
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
template <int D> typename FailureEquilibrium<D>::Rest FailureEquilibrium<D>::find_rest() {
  constexpr int tired = 25, most_solves = 100;
  const bool may_meet = closes_ && (!state_.broken.empty() || !options_.cuts.empty());
  bool fresh = false;
  Displacements from;
  for (int solves = 0; solves < most_solves; ++solves) {
    if (join().outside) {
      if (!prepare()) return Rest::apart;
      fresh = true;
    }
    if (may_meet) from = state_.u;
    const statics::StaticReport report = solve(fresh ? 4 * tired : 2 * tired);
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
template <int D> bool FailureEquilibrium<D>::equilibrate() {
  ending_ = Ending::not_converged;
  ++state_.solves;
  const Rest rest = find_rest();
  unit_force_ = unit_energy_ = 0;
  if (rest != Rest::found) return rest == Rest::apart;
  const double depth = depth_of_node(map_);
  unit_energy_ = -depth * linear_force(resisting_, state_.u, f_) / 2;
  bonds_.grid.each([&](std::ptrdiff_t i, int level) {
    if (level == bonds_.grid.levels() - 1) unit_force_ -= depth * dot(f_.at(i), way_);
  });
  return true;
}

template class FailureEquilibrium<2>;
template class FailureEquilibrium<3>;

}  // namespace arenite::peridynamics

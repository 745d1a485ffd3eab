#include "peridynamics/damage.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

#include "core/error.hpp"
#include "peridynamics/solvers/static_solve.hpp"
#include "peridynamics/support.hpp"

namespace arenite::peridynamics {

namespace {

void break_bond(Bonds& bonds, std::ptrdiff_t i, int d) { bonds.words[i] &= ~(3u << (2 * d)); }

/// A sample under a pull; `u` is its equilibrium at unit strain.
struct Pull {
  const PhaseMap& map;
  const DamageOptions& options;
  Bonds bonds;
  std::vector<std::uint8_t> prescribed;
  std::array<double, 4> critical{};
  std::optional<StaticSolver> solver;
  Field<double> u, f;
  DamageResult result;
  double unit_force = 0;   ///< of the clamp at unit strain, N/m
  double unit_energy = 0;  ///< of all bonds at unit strain, J/m

  Pull(const PhaseMap& m, const DamageOptions& o) : map(m), options(o), bonds(make_bonds(m, o.stiffness)) {
    const Toughness& k = o.toughness;
    for (const double value : {k.matrix, k.interface, k.particle})
      if (!(value > 0) || !std::isfinite(value))
        throw InputError(fmt::format("a toughness is {:g} Pa m^0.5; give a positive one", value));
    critical = {0, critical_stretch(k.matrix, o.stiffness.matrix, m.dx),
                critical_stretch(k.interface, o.stiffness.interface, m.dx),
                critical_stretch(k.particle, o.stiffness.particle, m.dx)};
    make_cuts(bonds, o.cuts);
    prescribed.assign(static_cast<std::size_t>(map.height), nothing_prescribed);
    prescribed.front() = prescribed.back() = both_prescribed;
    u = Field<double>(bonds.grid.padded_size());
    f = Field<double>(bonds.grid.padded_size());
  }

  double gauge() const { return (map.height - 1) * map.dx; }

  /// Set-up for the bonds as they are; false if nothing ties the clamps any more.
  bool prepare() {
    auto pieces = cut_into_pieces(map, bonds, prescribed);
    Buffer<Tie> tie;
    if (prune(bonds, pieces, prescribed, tie).carrying == 0) return false;
    solver.emplace(bonds, std::move(pieces), prescribed);
    return true;
  }

  void uniform_strain() {
    for (int y = 0; y < map.height; ++y)
      for (int x = 0; x < map.width; ++x)
        if (map.phase[map.index(x, y)] != Phase::empty) u.y[bonds.grid.index(x, y)] = y * map.dx;
  }

  /// The field at unit strain from the last one. A set-up that the broken bonds have left behind is made anew.
  bool equilibrate() {
    constexpr int tired = 25;
    StaticReport report = solver->solve(bonds, u, options.tolerance, 2 * tired);
    result.iterations += report.iterations;
    ++result.solves;
    if (report.iterations > tired || !report.converged) {
      if (!prepare()) {
        unit_force = unit_energy = 0;
        return true;
      }
      report = solver->solve(bonds, u, options.tolerance, 100);
      result.iterations += report.iterations;
    }
    const std::vector<std::uint8_t> none(prescribed.size(), nothing_prescribed);
    unit_energy = -kernels().force(bonds, none.data(), plane(u), plane(f)) / 2;
    unit_force = 0;
    for (std::ptrdiff_t i = bonds.grid.row(map.height - 1), end = i + map.width; i < end; ++i) unit_force -= f.y[i];
    return report.converged;
  }

  /// Stretch over the critical one at unit strain, of every bond that is whole, handed to `visit(i, x, y, d, ratio)`.
  template <class Visit>
  void each_ratio(const Visit& visit) const {
    const Grid& grid = bonds.grid;
    for (int y = 0; y < grid.height; ++y)
      for (int x = 0; x < grid.width; ++x) {
        const std::ptrdiff_t i = grid.index(x, y);
        const std::uint32_t word = bonds.words[i];
        if (!word) continue;
        for (int d = 0; d < bonds_per_node; ++d) {
          const unsigned t = word >> (2 * d) & 3u;
          if (t == no_bond) continue;
          const Offset e = half_bonds[static_cast<unsigned>(d)];
          const std::ptrdiff_t j = i + bonds.step(d);
          const double stretch =
              (e.x * (u.x[j] - u.x[i]) + e.y * (u.y[j] - u.y[i])) / ((e.x * e.x + e.y * e.y) * map.dx);
          visit(i, x, y, d, stretch / critical[t]);
        }
      }
  }

  double largest_ratio() const {
    double largest = 0;
    each_ratio([&](std::ptrdiff_t, int, int, int, double ratio) { largest = std::max(largest, ratio); });
    return largest;
  }

  /// Breaks what is stretched beyond the critical stretch, the worst of it first; returns the energy that it held.
  double break_worst(double strain, double largest) {
    const double limit = std::max(1 - 1e-9, (1 - options.band) * strain * largest) / strain;
    double energy = 0;
    int low = map.height, high = -1;
    each_ratio([&](std::ptrdiff_t i, int x, int y, int d, double ratio) {
      if (ratio < limit) return;
      const unsigned t = bonds.type(i, d);
      const double stretch = strain * ratio * critical[t];
      energy +=
          bonds.modulus(t) * map.dx * map.dx * length(half_bonds[static_cast<unsigned>(d)]) * stretch * stretch / 2;
      break_bond(bonds, i, d);
      result.broken.push_back({x, y, static_cast<std::uint8_t>(d), static_cast<std::uint8_t>(t), strain});
      low = std::min(low, y);
      high = std::max(high, y);
    });
    classify_groups(bonds, low, high);
    return energy;
  }

  double elastic(double strain) const { return strain * strain * unit_energy; }

  void run() {
    using Ending = DamageResult::Ending;
    if (!prepare()) return;
    uniform_strain();
    DamageState now;
    for (int event = 0;; ++event) {
      if (!equilibrate()) {
        result.ending = Ending::not_converged;
        return;
      }
      if (event == 0) result.modulus = unit_force / (map.width * map.dx);
      now.released += now.elastic - elastic(now.strain);
      now.elastic = elastic(now.strain);
      if (now.strain * unit_force <= options.end_stress * result.strength * map.width * map.dx && event > 0) {
        now.stress = now.strain * unit_force / (map.width * map.dx);
        now.broken = result.broken.size();
        result.curve.push_back(now);
        result.ending = prepare() ? Ending::dropped : Ending::severed;
        return;
      }
      const double largest = largest_ratio();
      const double next = largest > 0 ? 1 / largest : options.max_strain;
      if (next > now.strain) {
        const double to = std::min(next, options.max_strain);
        now.work += unit_force * gauge() * (to * to - now.strain * now.strain) / 2;
        now.strain = to;
        now.elastic = elastic(to);
      }
      now.stress = now.strain * unit_force / (map.width * map.dx);
      now.broken = result.broken.size();
      result.curve.push_back(now);
      result.strength = std::max(result.strength, now.stress);
      if (now.work > 0)
        result.energy_defect =
            std::max(result.energy_defect, std::abs(now.work - now.elastic - now.released) / now.work);
      if (now.strain >= options.max_strain || event >= options.max_events) {
        result.ending = now.strain >= options.max_strain ? Ending::strain_reached : Ending::events_reached;
        return;
      }
      now.bond_energy += break_worst(now.strain, largest);
    }
  }
};

std::string sentence_of(const DamageResult& r) {
  using Ending = DamageResult::Ending;
  const std::string so_far =
      fmt::format("strength {:.6g} Pa, {} bonds broken in {} solves", r.strength, r.broken.size(), r.solves);
  switch (r.ending) {
    case Ending::severed: return "the sample came apart; " + so_far;
    case Ending::dropped: return "the stress fell to the share at which the pull ends; " + so_far;
    case Ending::strain_reached: return "the largest strain was reached; " + so_far;
    case Ending::events_reached: return "the largest number of rounds was reached; " + so_far;
    case Ending::not_converged: return "a static solve did not converge; " + so_far;
    case Ending::no_path: break;
  }
  return "nothing ties the bottom row to the top row";
}

}  // namespace

double critical_stretch(double toughness, double young, double dx) {
  return toughness / young * std::sqrt(4 * std::numbers::pi / (9 * horizon * dx));
}

DamageResult pull_to_failure(const PhaseMap& map, const DamageOptions& options) {
  Pull pull(map, options);
  pull.run();
  pull.result.sentence = sentence_of(pull.result);
  return std::move(pull.result);
}

}  // namespace arenite::peridynamics

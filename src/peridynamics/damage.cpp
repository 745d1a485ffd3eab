#include "peridynamics/damage.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "core/error.hpp"
#include "peridynamics/node_stress.hpp"
#include "peridynamics/solvers/static_solve.hpp"
#include "peridynamics/support.hpp"

namespace arenite::peridynamics {

namespace {

using Ending = DamageResult::Ending;

void copy(const Field<double>& from, Field<double>& to) {
  std::copy_n(from.x.data(), from.x.size(), to.x.data());
  std::copy_n(from.y.data(), from.y.size(), to.y.data());
}

/// A sample under a pull; `u` is its equilibrium at unit strain.
struct Pull {
  const PhaseMap& map;
  const DamageOptions& options;
  const Vec2 way;  ///< of the top row
  Bonds bonds;
  std::vector<std::uint8_t> prescribed;
  std::array<double, 4> critical;
  std::optional<StaticSolver> solver;
  Field<double> u, f;
  Overstretch overstretch;
  DamageResult result;
  DamageState now;
  double unit_force = 0;   ///< of the clamp at unit strain, N/m
  double unit_energy = 0;  ///< of all bonds at unit strain, J/m
  double share = 0;        ///< Progress::share

  /// Bonds and equilibrium when the stress was largest.
  struct Strongest {
    Buffer<std::uint32_t> words;
    Field<double> u;
    double strain = 0;
  } strongest;

  Pull(const PhaseMap& m, const DamageOptions& o)
      : map(m),
        options(o),
        way(direction_of(o.loading)),
        bonds(make_bonds(m, o.stiffness)),
        prescribed(prescribed_rows(m.height, o.loading, o.lower)),
        critical(critical_stretches(o.toughness, o.stiffness, m.dx)),
        u(bonds.grid.padded_size()),
        f(bonds.grid.padded_size()),
        overstretch(bonds, m.dx, critical, u) {
    make_cuts(bonds, o.cuts);
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
        if (map.phase[map.index(x, y)] != Phase::empty) {
          u.x[bonds.grid.index(x, y)] = y * map.dx * way.x;
          u.y[bonds.grid.index(x, y)] = y * map.dx * way.y;
        }
  }

  bool watched(int iterations, double residual) {
    if (!options.watch) return true;
    const double fallen = result.strength > 0 ? (1 - now.stress / result.strength) / (1 - options.end_stress) : 0;
    share = std::clamp(std::max({fallen, now.strain / options.max_strain,
                                 static_cast<double>(result.solves) / (options.max_events + 1)}),
                       share, 1.0);
    return options.watch(
        {share, result.iterations + iterations, residual, result.broken.size(), now.strain, now.stress});
  }

  StaticReport solve(int most) {
    const StaticReport report = solver->solve(bonds, u, options.tolerance, most, [&](const Progress& p) {
      return watched(p.iterations, p.residual);
    });
    result.iterations += report.iterations;
    if (report.stopped) result.ending = Ending::stopped;
    return report;
  }

  /// The field at unit strain from the last one. A set-up that the broken bonds have left behind is made anew. False
  /// where the pull ends here.
  bool equilibrate() {
    constexpr int tired = 25;
    result.ending = Ending::not_converged;
    StaticReport report = solve(2 * tired);
    ++result.solves;
    if (report.stopped) return false;
    if (report.iterations > tired || !report.converged) {
      if (!prepare()) {
        unit_force = unit_energy = 0;
        return true;
      }
      report = solve(100);
    }
    const std::vector<std::uint8_t> none(prescribed.size(), nothing_prescribed);
    unit_energy = -kernels().force(bonds, none.data(), plane(u), plane(f)) / 2;
    unit_force = 0;
    for (std::ptrdiff_t i = bonds.grid.row(map.height - 1), end = i + map.width; i < end; ++i)
      unit_force -= f.x[i] * way.x + f.y[i] * way.y;
    return report.converged;
  }

  double elastic(double strain) const { return strain * strain * unit_energy; }
  double stress(double strain) const { return strain * unit_force / (map.width * map.dx); }

  /// After a round of breaking, at the strain that it happened at.
  void settle() {
    now.released += now.elastic - elastic(now.strain);
    now.elastic = elastic(now.strain);
    now.stress = stress(now.strain);
    now.broken = result.broken.size();
  }

  /// On to the strain at which the next bond breaks.
  void strain_to(double next) {
    if (next > now.strain) {
      const double to = std::min(next, options.max_strain);
      now.work += unit_force * gauge() * (to * to - now.strain * now.strain) / 2;
      now.strain = to;
      now.elastic = elastic(to);
      now.stress = stress(to);
    }
    result.curve.push_back(now);
    if (now.work > 0)
      result.energy_defect = std::max(result.energy_defect, std::abs(now.work - now.elastic - now.released) / now.work);
    if (now.stress > result.strength) remember();
  }

  void remember() {
    result.strength = now.stress;
    if (strongest.words.size() == 0) {
      strongest.words = Buffer<std::uint32_t>(bonds.words.size());
      strongest.u = Field<double>(bonds.grid.padded_size());
    }
    std::copy_n(bonds.words.data(), bonds.words.size(), strongest.words.data());
    copy(u, strongest.u);
    strongest.strain = now.strain;
  }

  /// Breaks what is stretched beyond the critical stretch, the worst of it.
  void break_worst(double largest) {
    const double limit = std::max(1 - 1e-9, (1 - options.band) * now.strain * largest) / now.strain;
    int low = map.height, high = -1;
    overstretch.each_above(limit, [&](const Bond& b, double ratio) {
      const double stretch = now.strain * ratio * critical[b.type];
      now.bond_energy += bonds.modulus(b.type) * map.dx * map.dx * length(b.step()) * stretch * stretch / 2;
      bonds.words[b.i] &= ~(3u << (2 * b.d));
      result.broken.push_back(
          {b.x, b.y, static_cast<std::uint8_t>(b.d), static_cast<std::uint8_t>(b.type), now.strain});
      low = std::min(low, b.y);
      high = std::max(high, b.y);
    });
    classify_groups(bonds, low, high);
  }

  void run() {
    result.ending = Ending::no_path;
    if (!prepare()) return;
    uniform_strain();
    for (int event = 0;; ++event) {
      if (!equilibrate()) return;
      if (event == 0) result.modulus = unit_force / (map.width * map.dx);
      settle();
      if (event > 0 && now.stress <= options.end_stress * result.strength) {
        result.curve.push_back(now);
        result.ending = prepare() ? Ending::dropped : Ending::severed;
        return;
      }
      const double largest = overstretch.largest();
      strain_to(largest > 0 ? 1 / largest : options.max_strain);
      if (now.strain >= options.max_strain || event >= options.max_events) {
        result.ending = now.strain >= options.max_strain ? Ending::strain_reached : Ending::events_reached;
        return;
      }
      break_worst(largest);
    }
  }

  void finish() {
    if (result.strength > 0) {
      for (Buffer<double>* component : {&strongest.u.x, &strongest.u.y})
        for (std::size_t i = 0; i < component->size(); ++i) component->data()[i] *= strongest.strain;
      std::swap(bonds.words, strongest.words);
      result.at_strength = node_stress(bonds, map.dx, strongest.u, false);
    }
  }
};

void check(const DamageOptions& o) {
  const auto positive = [](double value, const char* what) {
    if (!(value > 0) || !std::isfinite(value))
      throw InputError(fmt::format("the {} of a pull to failure is {:g}; give a positive one", what, value));
  };
  positive(o.tolerance, "tolerance");
  positive(o.max_strain, "largest strain");
  if (!(o.end_stress >= 0) || !(o.end_stress < 1))
    throw InputError(fmt::format("the share of the strength at which a pull ends is {:g}; give one from 0 to below 1",
                                 o.end_stress));
  if (!(o.band >= 0) || !(o.band < 1))
    throw InputError(fmt::format("the band of bonds that break together is {:g}; give one from 0 to below 1", o.band));
}

}  // namespace

DamageResult pull_to_failure(const PhaseMap& map, const DamageOptions& options) {
  check(options);
  Pull pull(map, options);
  pull.run();
  pull.finish();
  pull.result.sentence = sentence_of(pull.result);
  return std::move(pull.result);
}

}  // namespace arenite::peridynamics

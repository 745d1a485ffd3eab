#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/error.hpp"
#include "support.hpp"

namespace arenite::verification {
namespace {

using dem::Engine;
using dem::IntegratorKind;

dem::ContactParameters damped(double restitution) {
  dem::ContactParameters law;
  law.friction_law = dem::RegularisedCoulomb{};
  law.attractive_dashpot = true;
  law.restitution = restitution;
  return law;
}

/// The number of seconds that a refusal offers; nothing if the step was not refused.
std::optional<double> offered(const Packing& start, const dem::ContactParameters& law, IntegratorKind kind) {
  try {
    Engine engine(start, law, with_step(1, kind));
  } catch (const InputError& refusal) {
    const std::string text = refusal.what();
    double least = 1;
    for (std::size_t end = text.find(" s"); end != std::string::npos; end = text.find(" s", end + 1)) {
      const bool unit = end + 2 == text.size() || !std::isalnum(static_cast<unsigned char>(text[end + 2]));
      if (unit && std::isdigit(static_cast<unsigned char>(text[end - 1])))
        least = std::min(least, std::stod(text.substr(text.rfind(' ', end - 1) + 1)));
    }
    EXPECT_LT(least, 1) << text;
    return least;
  }
  return std::nullopt;
}

TEST(StepBound, AStepBeyondItIsRefusedAndTheOneOfferedIsAcceptedAndStable) {
  for (const auto kind : integrators)
    for (const double e : {0.9, 0.05}) {
      SCOPED_TRACE(std::string(name(kind)) + ", e = " + std::to_string(e));
      const Packing start = shaken_lattice(6, 6, 1, false, 0.5);
      const auto dt = offered(start, damped(e), kind);
      ASSERT_TRUE(dt.has_value());
      dem::IntegrationParameters how = with_step(*dt, kind);
      ASSERT_NO_THROW(Engine(start, damped(e), how));
      Engine engine(start, damped(e), how);
      EXPECT_NEAR(step_bounds(engine).largest(), *dt, 0.05 * *dt);
      EXPECT_THROW(Engine(start, damped(e), with_step(1.1 * step_bounds(engine).largest(), kind)), InputError);
      engine.advance(20000);
      // Stable: what moves at the end is slower than what moved at the start.
      EXPECT_LT(energies_of(engine).kinetic + energies_of(engine).elastic, [&] {
        double sum = 0;
        for (std::size_t i = 0; i < start.grains.size(); ++i)
          sum += 0.5 * mass(start, i) * dot(velocity(start, i), velocity(start, i)) +
                 0.5 * disk_inertia(start, i) * start.grains.omega[i] * start.grains.omega[i];
        return sum;
      }());
    }
}

TEST(StepBound, OfHertzContactsKnowsThatTheSpringOfFrictionDoesNotSoftenWithTheOverlap) {
  // Six contacts with equals that all turn alike: omega^2 = 24 k_t/m, k_t = 0.8 k however small the overlap.
  const Packing start = shaken_lattice(6, 6, 1, false, 0.5);
  dem::ContactParameters law;
  law.normal = dem::Hertz{};
  law.friction_law = dem::CundallStrack{};
  law.friction = 0.5;
  double omega = 0;
  for (std::size_t i = 0; i < start.grains.size(); ++i) {
    const double k = start.materials[static_cast<std::size_t>(start.grains.material[i])].stiffness;
    omega = std::max(omega, std::sqrt(24 * law.tangential_stiffness_ratio * k / mass(start, i)));
  }
  for (const auto kind : {IntegratorKind::velocity_verlet, IntegratorKind::leapfrog}) {
    const Engine engine(start, law, with_step(1e-9, kind));
    EXPECT_LE(step_bounds(engine).stiffness, 2 / omega) << name(kind);
    EXPECT_GE(step_bounds(engine).stiffness, 1.7 / omega) << name(kind);
  }
}

TEST(StepBound, IsNeverLooserThanTheClosedFormOfOneDiskOnAWall) {
  // omega dt < 2 for Verlet and leapfrog; damping lowers it.
  Packing p = box(0.1, 0.1);
  add(p, {{0.05, 6.2e-3 - 1e-5}, 6.2e-3});
  const double omega = std::sqrt(k_pom / mass(p, 0));
  for (const auto kind : integrators) {
    Engine engine(p, frictionless(0.5), with_step(1e-9, kind));
    EXPECT_LE(step_bounds(engine).stiffness, 2 / omega) << name(kind);
    EXPECT_GE(step_bounds(engine).stiffness, 0.02 / omega) << name(kind);
  }
}

/// The largest eigenvalue of a sum of w v v', of vectors v given by their entries that are not zero, by power
/// iteration.
struct Outer {
  double weight;
  std::vector<std::pair<std::size_t, double>> vector;
};
double largest_eigenvalue(const std::vector<Outer>& sum, std::size_t n) {
  std::vector<double> x(n);
  for (std::size_t i = 0; i < n; ++i) x[i] = 1 + 0.1 * std::cos(static_cast<double>(i));  // no eigenvector by symmetry
  double value = 0;
  for (int k = 0; k < 20000; ++k) {
    std::vector<double> y(n);
    for (const auto& [weight, v] : sum) {
      double along = 0;
      for (const auto& [i, entry] : v) along += entry * x[i];
      for (const auto& [i, entry] : v) y[i] += weight * along * entry;
    }
    value = 0;
    for (const double entry : y) value = std::hypot(value, entry);
    for (std::size_t i = 0; i < n; ++i) x[i] = y[i] / value;
  }
  return value;
}

/// Largest rates of a sample's own contacts: of the springs, omega, and of the dashpots with sliding viscosity, lambda.
struct Rates {
  double omega, lambda;
};
Rates true_rates(const Packing& p, const dem::ContactParameters& law) {
  std::vector<Outer> springs, dashpots;
  for (std::size_t contact = 0; contact < p.contacts.size(); ++contact) {
    const auto i = static_cast<std::size_t>(p.contacts.i[contact]);
    const bool wall = p.contacts.is_wall(contact);
    const auto j = wall ? i : static_cast<std::size_t>(p.contacts.j[contact]);
    const Vec2 e = p.contacts.normal[contact], t = perpendicular(e);
    Outer normal, tangential;  // of displacements times roots of masses
    const auto enter = [&](std::size_t grain, double sign, double arm) {
      const double share = sign / std::sqrt(mass(p, grain));
      normal.vector.insert(normal.vector.end(), {{3 * grain, share * e.x}, {3 * grain + 1, share * e.y}});
      tangential.vector.insert(tangential.vector.end(), {{3 * grain, share * t.x},
                                                         {3 * grain + 1, share * t.y},
                                                         {3 * grain + 2, -arm / std::sqrt(disk_inertia(p, grain))}});
    };
    enter(i, 1, p.contacts.arm_i[contact]);
    if (!wall) enter(j, -1, p.contacts.arm_j[contact]);
    const double stiffness = p.contacts.fn[contact] / p.contacts.overlap[contact];
    const double m = wall ? mass(p, i) : reduced(mass(p, i), mass(p, j));
    const double alpha = 2 * damping_ratio(law.restitution) * std::sqrt(stiffness * m);
    springs.insert(springs.end(), {{stiffness, normal.vector}, {0.8 * stiffness, tangential.vector}});
    dashpots.insert(dashpots.end(), {{alpha, normal.vector}, {alpha, tangential.vector}});
  }
  const std::size_t n = 3 * p.grains.size();
  return {std::sqrt(largest_eigenvalue(springs, n)), largest_eigenvalue(dashpots, n)};
}

TEST(StepBound, IsBelowTheTrueLimitOfCompressedSamplesOfUnequalGrains) {
  for (const auto rule : {dem::StiffnessRule::thesis, dem::StiffnessRule::series})
    for (const std::uint64_t seed : {1u, 2u}) {
      Packing p = shaken_lattice(7, 7, seed);
      for (std::size_t i = 0; i < p.grains.size(); i += 3) p.grains.radius[i] *= 0.8;
      const double d = 2 * p.grains.radius[0];  // small light grains in the corner, held by two walls
      p.grains.position[0].x = p.grains.position[0].y = 0.49 * d;
      p.grains.material[0] = hdpe;
      dem::ContactParameters law;
      law.restitution = 0.5;
      law.friction_law = dem::CundallStrack{};
      law.stiffness_rule = rule;
      Engine engine(p, law, with_step(shortest_contact_time() / 30));
      set_drives(engine, {moved(2), moved(-2), moved(2), moved(-2)});
      engine.advance(1500);
      set_drives(engine, {});
      engine.advance(20000);
      Packing rest = packing_of(engine);  // at rest, so that f_n/h is the stiffness
      for (std::size_t i = 0; i < rest.grains.size(); ++i)
        rest.grains.velocity[i].x = rest.grains.velocity[i].y = rest.grains.omega[i] = 0;
      const Packing still = packing_of(Engine(rest, law, with_step(1e-8)));
      EXPECT_GT(still.contacts.size(), 60u);
      const Rates rates = true_rates(still, law);
      // Velocity Verlet that sees v at the end of the step: (omega dt)^2/4 + lambda dt = 1 at the limit, were both in
      // one mode.
      const double limit = 2 / (rates.lambda + std::hypot(rates.lambda, rates.omega));
      EXPECT_LE(step_bounds(engine).stiffness, 2 / rates.omega);
      EXPECT_LE(step_bounds(engine).largest(), limit);
      EXPECT_GE(step_bounds(engine).largest(), 0.3 * limit);  // and of use
    }
}

using Matrix6 = std::array<std::array<double, 6>, 6>;

/// Largest growth a step of Gear's fifth-order scheme (six values) on x'' = -lambda x', z = lambda dt.
double gear_growth(double z) {
  constexpr double c[6] = {3.0 / 16, 251.0 / 360, 1, 11.0 / 18, 1.0 / 6, 1.0 / 60};
  Matrix6 step{};
  for (std::size_t i = 0; i < 6; ++i) {
    double binomial = 1;
    for (std::size_t j = i; j < 6; ++j) {
      step[i][j] = binomial;
      binomial *= (static_cast<double>(j) + 1) / static_cast<double>(j + 1 - i);
    }
  }
  std::array<double, 6> residual;  // in Nordsieck scaling: dt^2 x''/2 = -z/2 (dt x')
  for (std::size_t j = 0; j < 6; ++j) residual[j] = -step[2][j] - 0.5 * z * step[1][j];
  for (std::size_t i = 0; i < 6; ++i)
    for (std::size_t j = 0; j < 6; ++j) step[i][j] += c[i] * residual[j];
  // The step's power 2^20, by squares that are scaled to 1: what it grows by a step. Uniform motion's own root, 1, is
  // no growth.
  double growth = 0, share = 1;
  for (int k = 0; k < 20; ++k) {
    double largest = 0;
    for (const auto& row : step)
      for (const double entry : row) largest = std::max(largest, std::abs(entry));
    growth += share * std::log(largest), share /= 2;
    Matrix6 square{};
    for (std::size_t i = 0; i < 6; ++i)
      for (std::size_t j = 0; j < 6; ++j)
        for (std::size_t m = 0; m < 6; ++m) square[i][j] += step[i][m] / largest * (step[m][j] / largest);
    step = square;
  }
  return std::exp(growth);
}

TEST(StepBound, GearsDampingBoundIsWhereItBlowsUp) {
  double low = 0.01, high = 1;
  for (int i = 0; i < 60; ++i) (gear_growth(0.5 * (low + high)) > 1 + 1e-4 ? high : low) = 0.5 * (low + high);
  EXPECT_NEAR(low, 0.164, 1e-3);

  Packing p = box(1, 1);
  add(p, {{0.5, 0.5}, 6.2e-3, pom, {1, 0}});
  const double rate = 1e5;  // so strong that no spring bounds the step
  for (const double share : {0.97, 1.03}) {
    dem::IntegrationParameters how = with_step(share * low / rate, IntegratorKind::gear5);
    how.drag = 1e-3;
    Engine engine(p, elastic(), how);
    bool lost = false;  // the engine notices a grain outside of the container
    try {
      set_drag(engine, rate);
      engine.advance(4000);
    } catch (const std::exception&) { lost = true; }
    const double speed = norm(velocity(packing_of(engine), 0));
    if (share < 1) {
      EXPECT_FALSE(lost);
      EXPECT_LT(speed, 1e-3);
    } else {
      EXPECT_TRUE(lost || !(speed < 1e3)) << speed;
    }
  }
}

TEST(StepBound, GearRefusesADashpotThatItCannotCarryAndVerletTakesIt) {
  Packing p = box(0.1, 0.1);
  add(p, {{0.05, 6.2e-3 - 1e-5}, 6.2e-3});
  const double m = mass(p, 0), omega = std::sqrt(k_pom / m), dt = 0.12 / omega;
  dem::ContactParameters law = elastic();
  EXPECT_NO_THROW(Engine(p, law, with_step(dt, IntegratorKind::gear5)));
  law.normal_damping = 0.3 * m * omega;  // six such contacts: lambda dt = 0.22
  EXPECT_THROW(Engine(p, law, with_step(dt, IntegratorKind::gear5)), InputError);
  EXPECT_NO_THROW(Engine(p, law, with_step(dt, IntegratorKind::velocity_verlet)));
}

TEST(StepBound, WithoutAStepGivenItIsTheShareAskedForOfTheShortestContactTime) {
  Packing p = box(1, 1);
  add(p, {{0.2, 0.2}, 6.2e-3, pom});
  add(p, {{0.3, 0.2}, 6.2e-3, pom});
  add(p, {{0.4, 0.2}, 5.25e-3, hdpe});
  dem::IntegrationParameters how;
  how.safety = 0.05;
  const Engine engine(p, frictionless(0.9), how);
  // Between the time of the lightest pair and of the lightest grain with half its mass on the stiffest spring.
  const double shortest = contact_time(0.5 * mass(p, 2), k_pom), longest = contact_time(mass(p, 0), k_pom);
  EXPECT_GE(engine.dt, 0.05 * shortest * (1 - 1e-12));
  EXPECT_LE(engine.dt, 0.05 * longest);
}

}  // namespace
}  // namespace arenite::verification

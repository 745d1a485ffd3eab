#include "solid/peridynamics/damage.hpp"

#include <gtest/gtest.h>

#include <utility>
#include <vector>

#include "core/error.hpp"
#include "solid/peridynamics/failure_state.hpp"
#include "support/cemented_sample.hpp"
#include "support/homogeneous_sample.hpp"

namespace arenite::peridynamics {
namespace {

constexpr Toughness weak{1e-5, 1e-5, 3.5e-5};

/// A test with its states before each of its rounds.
struct Recorded {
  PhaseMap map;
  double band, tolerance;
  std::vector<FailureState> states;
  DamageResult result;

  Recorded(PhaseMap m, double b, double t) : map(std::move(m)), band(b), tolerance(t) {
    DamageOptions o = options();
    o.keep = [this](const auto& state) { states.push_back(state()); };
    result = load_to_failure(map, o);
  }
  DamageOptions options() const {
    DamageOptions o{{.tolerance = tolerance}, {.end_stress = 0.02, .band = band}};
    o.toughness = {1e-5, 1e-5, 3.5e-5};
    o.max_events = 70;
    return o;
  }
};

/// A plate that breaks so far through that the solver is set up anew on the way.
const Recorded& plate() {
  static const Recorded made(test::homogeneous_sample(32, 32), 0.2, 1e-12);
  return made;
}

const Recorded& packing() {
  static const Recorded made(test::cemented_sample({.nodes = 36, .size_ratio = 2, .bridge = 0.3}), 0.3, 1e-6);
  return made;
}

void expect_same_bits(const DamageResult& a, const DamageResult& b) {
  EXPECT_EQ(a.ending, b.ending);
  EXPECT_EQ(a.sentence, b.sentence);
  ASSERT_EQ(a.curve.size(), b.curve.size());
  for (std::size_t k = 0; k < a.curve.size(); ++k) {
    const DamageState &s = a.curve[k], &t = b.curve[k];
    for (const auto member : {&DamageState::strain, &DamageState::stress, &DamageState::work, &DamageState::elastic,
                              &DamageState::released, &DamageState::bond_energy})
      ASSERT_EQ(s.*member, t.*member) << k;
    ASSERT_EQ(s.broken, t.broken);
  }
  ASSERT_EQ(a.broken.size(), b.broken.size());
  for (std::size_t k = 0; k < a.broken.size(); ++k) {
    const BrokenBond &s = a.broken[k], &t = b.broken[k];
    ASSERT_TRUE(s.x == t.x && s.y == t.y && s.direction == t.direction && s.type == t.type && s.strain == t.strain)
        << k;
  }
  for (const auto values : {&StressField::xx, &StressField::yy, &StressField::xy, &StressField::ux, &StressField::uy})
    EXPECT_EQ(a.at_strength.*values, b.at_strength.*values);
  EXPECT_EQ(a.strength, b.strength);
  EXPECT_EQ(a.modulus, b.modulus);
  EXPECT_EQ(a.energy_defect, b.energy_defect);
  EXPECT_EQ(a.solves, b.solves);
  EXPECT_EQ(a.iterations, b.iterations);
}

void expect_resumes_after_every(std::size_t rounds, const Recorded& recorded) {
  for (std::size_t k = 0; k < recorded.states.size(); k += rounds) {
    const FailureState state = failure_state_of(to_bytes(recorded.states[k]));
    EXPECT_EQ(state.rounds, static_cast<std::int64_t>(k));
    DamageOptions o = recorded.options();
    o.resume = &state;
    expect_same_bits(load_to_failure(recorded.map, o), recorded.result);
  }
}

TEST(FailureState, ResumedThePullHasTheBitsOfOneInOnePiece) {
  ASSERT_GT(packing().states.size(), 50u);
  expect_same_bits(load_to_failure(packing().map, packing().options()), packing().result);
  expect_resumes_after_every(packing().states.size() / 4, packing());
}

TEST(FailureState, ResumedItsSolverIsSetUpForTheBondsThatItWasSetUpForBefore) {
  std::size_t renewed = 0;
  for (const FailureState& state : plate().states)
    renewed += state.words_at_setup != plate().states[0].words_at_setup && state.words_at_setup != state.words;
  ASSERT_GT(renewed, 3u);
  expect_resumes_after_every(5, plate());
}

TEST(FailureState, StoppedInsideASolveThePullLosesNoRound) {
  FailureState state;
  bool resumed = false;
  for (int lives = 0;; ++lives) {
    DamageOptions o = packing().options();
    if (resumed) o.resume = &state;
    FailureState next;
    int looks = 0;
    o.watch = [&](const Progress&) { return ++looks < 60; };
    o.keep = [&](const auto& now) { next = now(); };
    const auto result = load_to_failure(packing().map, o);
    if (result.ending != DamageResult::Ending::stopped) {
      EXPECT_GT(lives, 4);
      return expect_same_bits(result, packing().result);
    }
    ASSERT_GT(next.rounds, state.rounds);
    state = std::move(next);
    resumed = true;
  }
}

TEST(FailureState, OfAMapOfAnotherSizeOrDamagedIsRefused) {
  const FailureState& state = packing().states[5];
  DamageOptions o = packing().options();
  o.resume = &state;
  EXPECT_THROW(load_to_failure(plate().map, o), InputError);
  const auto whole = to_bytes(state);
  auto bytes = whole;
  bytes.pop_back();
  EXPECT_THROW(failure_state_of(bytes), InputError);
  bytes = whole;
  bytes.push_back(0);
  EXPECT_THROW(failure_state_of(bytes), InputError);
  bytes = whole;
  bytes[0] ^= 1;
  EXPECT_THROW(failure_state_of(bytes), InputError);
}

}  // namespace
}  // namespace arenite::peridynamics

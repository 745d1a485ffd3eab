#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <string>

#include "core/error.hpp"
#include "grains/dem/engine.hpp"
#include "unit/grains/dem/boundaries/boxes.hpp"
#include "unit/grains/dem/samples.hpp"

namespace arenite::dem {
namespace {

using testing::crowd;

struct Set {
  const char* name;
  IntegratorKind integrator;
  FrictionLaw friction;
  bool periodic, tracked;
};

Engine make(const Set& set) {
  Packing p = crowd(12, 12, 5, 0.0118);
  p.domain.periodic[0] = p.domain.periodic[1] = set.periodic;
  for (std::size_t k = 0; k < p.grains.size(); k += 2) p.grains.zone[k] = 1;
  ContactParameters contact;
  contact.friction_law = set.friction;
  contact.adhesion = dem::BreakingAdhesion{};
  contact.surface_energy = 2e5;
  IntegrationParameters integration;
  integration.integrator = set.integrator;
  integration.track_energy = set.tracked;
  Engine engine(p, contact, integration);
  WallDrives drives;
  drives[bottom] = {WallDrive::Kind::force, 3000};
  drives[right] = {WallDrive::Kind::velocity, -0.05};
  set_drives(engine, drives);
  set_gravity(engine, {0, -9.81});
  return engine;
}

class Save : public ::testing::TestWithParam<Set> {};

TEST_P(Save, AResumedRunHasTheBitsOfOneInOnePiece) {
  Engine whole = make(GetParam());
  whole.advance(700);
  const auto bytes = save_sample(whole);
  whole.advance(811);

  Engine resumed = make(GetParam());
  resumed.advance(37);
  restore_sample(resumed, bytes);
  EXPECT_EQ(save_sample(resumed), bytes);
  resumed.advance(500);
  resumed.advance(311);
  EXPECT_EQ(state_hash(resumed), state_hash(whole));
  EXPECT_EQ(save_sample(resumed), save_sample(whole));
  EXPECT_EQ(energies_of(resumed).dissipated_normal, energies_of(whole).dissipated_normal);
}

INSTANTIATE_TEST_SUITE_P(
    All, Save,
    ::testing::Values(Set{"verlet", IntegratorKind::velocity_verlet, dem::RegularisedCoulomb{}, false, false},
                      Set{"verlet_tracked", IntegratorKind::velocity_verlet, dem::CundallStrack{}, false, true},
                      Set{"leapfrog_periodic", IntegratorKind::leapfrog, dem::CundallStrack{}, true, false},
                      Set{"gear_tracked", IntegratorKind::gear5, dem::CundallStrack{}, false, true},
                      Set{"gear_periodic", IntegratorKind::gear5, dem::RegularisedCoulomb{}, true, true}),
    [](const auto& test) { return std::string(test.param.name); });

TEST(SavedState, IsRefusedWhenCutShortOrOfAnotherSample) {
  Engine engine(crowd(5, 5, 1), {}, {});
  auto bytes = save_sample(engine);
  const auto hash = state_hash(engine);
  for (const std::size_t length : {std::size_t{0}, std::size_t{11}, bytes.size() / 2, bytes.size() - 1}) {
    EXPECT_THROW(restore_sample(engine, {bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(length)}),
                 InputError);
    EXPECT_EQ(state_hash(engine), hash);
  }
  Engine other(crowd(6, 5, 1), {}, {});
  EXPECT_THROW(restore_sample(other, bytes), InputError);
}

TEST(SavedState, OfAnotherVersionIsRefusedWithASentenceThatSaysSo) {
  Engine engine(crowd(5, 5, 1), {}, {});
  auto bytes = save_sample(engine);
  const auto hash = state_hash(engine);
  bytes[7] = '4';  // "a-dem-04"
  try {
    restore_sample(engine, bytes);
    FAIL() << "was taken";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("another version"), std::string::npos) << error.what();
  }
  EXPECT_EQ(state_hash(engine), hash);
}

TEST(StateHash, ChangesWithTheStateAndOnlyThen) {
  Engine engine(crowd(5, 5, 1), {}, {});
  const auto before = state_hash(engine);
  EXPECT_EQ(state_hash(engine), before);
  engine.advance(1);
  EXPECT_NE(state_hash(engine), before);
}

/// Records of space are longer than what they hold; what a compiler leaves behind the last member is nobody's.
TEST(StateHash, DoesNotSeeTheGapsOfRecords) {
  PackingIn<3> p = testing::box_with({}, 0.1);
  p.domain.boundaries.clear();
  for (int k = 0; k < 3; ++k) testing::add_ball(p, Vec3{0.02 + 0.0195 * k, 0.05, 0.05});
  EngineIn<3> engine(p, {}, {});
  engine.advance(1);
  const auto before = state_hash(engine);
  const auto dirty = [](auto& record, auto& last) {
    auto* end = reinterpret_cast<std::uint8_t*>(&last) + sizeof last;
    std::fill(end, reinterpret_cast<std::uint8_t*>(&record) + sizeof record, 0xa5);
  };
  for (GrainRecord<3>& each : engine.record) dirty(each, each.grain);
  ASSERT_FALSE(engine.list.force.empty());
  for (SlotForce<3>& each : engine.list.force) dirty(each, each.torque_j);
  EXPECT_EQ(state_hash(engine), before);
}

}  // namespace
}  // namespace arenite::dem

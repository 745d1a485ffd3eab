#include <gtest/gtest.h>

#include "core/error.hpp"
#include "grains/dem/engine.hpp"
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
  engine.set_drives(drives);
  engine.set_gravity({0, -9.81});
  return engine;
}

class Save : public ::testing::TestWithParam<Set> {};

TEST_P(Save, AResumedRunHasTheBitsOfOneInOnePiece) {
  Engine whole = make(GetParam());
  whole.advance(700);
  const auto bytes = whole.save();
  whole.advance(811);

  Engine resumed = make(GetParam());
  resumed.advance(37);
  resumed.restore(bytes);
  EXPECT_EQ(resumed.save(), bytes);
  resumed.advance(500);
  resumed.advance(311);
  EXPECT_EQ(resumed.state_hash(), whole.state_hash());
  EXPECT_EQ(resumed.save(), whole.save());
  EXPECT_EQ(resumed.energies().dissipated_normal, whole.energies().dissipated_normal);
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
  auto bytes = engine.save();
  const auto hash = engine.state_hash();
  for (const std::size_t length : {std::size_t{0}, std::size_t{11}, bytes.size() / 2, bytes.size() - 1}) {
    EXPECT_THROW(engine.restore({bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(length)}), InputError);
    EXPECT_EQ(engine.state_hash(), hash);
  }
  Engine other(crowd(6, 5, 1), {}, {});
  EXPECT_THROW(other.restore(bytes), InputError);
}

TEST(StateHash, ChangesWithTheStateAndOnlyThen) {
  Engine engine(crowd(5, 5, 1), {}, {});
  const auto before = engine.state_hash();
  EXPECT_EQ(engine.state_hash(), before);
  engine.advance(1);
  EXPECT_NE(engine.state_hash(), before);
}

}  // namespace
}  // namespace arenite::dem

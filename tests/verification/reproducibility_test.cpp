#include <gtest/gtest.h>

#include <string>

#include "support.hpp"

namespace arenite::verification {
namespace {

using dem::Engine;
using dem::FrictionLaw;
using dem::IntegratorKind;

/// A sample that is compressed, so that its lists are rebuilt on the way.
struct Case {
  Packing start;
  dem::ContactParameters law;
  dem::IntegrationParameters how;

  Case(FrictionLaw friction, IntegratorKind kind, bool periodic = false)
      : start(shaken_lattice(20, 20, 9, periodic, 3)),
        how(with_step(shortest_contact_time() / 100, kind)) {
    law.friction_law = friction;
    law.restitution = 0.5;
    law.attractive_dashpot = true;
    law.adhesion = dem::BreakingAdhesion{};
    law.surface_energy = 0.2e6;
    for (std::size_t i = 0; i < start.grains.size(); i += 3) start.grains.zone[i] = 1;
    how.kernel = "auto";
  }
  Engine engine() const {
    Engine e(start, law, how);
    if (!start.domain.periodic[0]) set_drives(e, {moved(2), pressed(2000), moved(3), dem::WallDrive{}});
    set_gravity(e, {0, -1000});
    return e;
  }
};

template <class F> void for_each_run(F f) {
  for (const dem::FrictionLaw& friction :
       std::initializer_list<dem::FrictionLaw>{dem::RegularisedCoulomb{}, dem::CundallStrack{}})
    for (const auto kind : integrators)
      for (const bool periodic : {false, true}) {
        SCOPED_TRACE(std::string(name(kind)) + (periodic ? ", periodic" : ", walls") +
                     (friction == dem::CundallStrack{} ? ", Cundall-Strack" : ", regularised"));
        f(Case(friction, kind, periodic));
      }
}

TEST(Reproducibility, OneAndTwoThreadsGiveTheSameBits) {
  for_each_run([](Case run) {
    Engine one = run.engine();
    run.how.threads = 2;
    Engine two = run.engine();
    EXPECT_EQ(state_hash(one), state_hash(two));
    const auto at_start = state_hash(one);
    for (int part = 0; part < 4; ++part) {
      one.advance(300);
      two.advance(300);
      ASSERT_EQ(state_hash(one), state_hash(two)) << "after " << one.step << " steps";
    }
    EXPECT_NE(state_hash(one), at_start);
    EXPECT_EQ(packing_of(one).grains.position, packing_of(two).grains.position);
  });
}

TEST(Reproducibility, SavedAndRestoredInTheMiddleGivesTheSameBits) {
  for_each_run([](const Case& run) {
    Engine whole = run.engine();
    whole.advance(733);
    const auto bytes = save_sample(whole);
    whole.advance(911);
    Engine resumed = run.engine();
    restore_sample(resumed, bytes);
    EXPECT_EQ(resumed.step, 733);
    resumed.advance(911);
    EXPECT_EQ(state_hash(resumed), state_hash(whole));
    EXPECT_EQ(packing_of(resumed).grains.position, packing_of(whole).grains.position);
    EXPECT_EQ(packing_of(resumed).contacts.ft, packing_of(whole).contacts.ft);
    EXPECT_EQ(resumed.domain.wall[right].position, whole.domain.wall[right].position);
  });
}

TEST(Reproducibility, LookingDoesNotChangeTheFuture) {
  for_each_run([](const Case& run) {
    Engine unseen = run.engine(), watched = run.engine();
    unseen.advance(600);
    for (int part = 0; part < 60; ++part) {
      watched.advance(10);
      packing_of(watched);
      equilibrium_of(watched);
      energies_of(watched);
      save_sample(watched);
    }
    EXPECT_EQ(state_hash(unseen), state_hash(watched));
  });
}

TEST(Reproducibility, EveryKernelGivesTheBitsOfThePortableOne) {
  for_each_run([](Case run) {
    for (const dem::NormalLaw& normal : std::initializer_list<dem::NormalLaw>{dem::Linear{}, dem::Hertz{}}) {
      run.law.normal = normal;
      run.how.kernel = "auto";
      Engine fast = run.engine();
      run.how.kernel = "portable";
      Engine portable = run.engine();
      EXPECT_STREQ(portable.kernel->name, "portable");
      fast.advance(700);
      portable.advance(700);
      const Packing a = packing_of(fast), b = packing_of(portable);
      EXPECT_GT(a.contacts.size(), 100u);
      EXPECT_EQ(a.grains.position, b.grains.position) << fast.kernel->name;
      EXPECT_EQ(a.grains.angle, b.grains.angle) << fast.kernel->name;
      EXPECT_EQ(a.contacts.fn, b.contacts.fn) << fast.kernel->name;
      EXPECT_EQ(a.contacts.ft, b.contacts.ft) << fast.kernel->name;
      for (const int side : {left, right, bottom, top})
        EXPECT_EQ(fast.domain.wall[static_cast<std::size_t>(side)].position,
                  portable.domain.wall[static_cast<std::size_t>(side)].position);
    }
  });
}

TEST(Reproducibility, ASavedStateHoldsDrivesAndGravityAndDoesNotDependOnThreads) {
  for_each_run([](Case run) {
    Engine whole = run.engine();
    set_drag(whole, 50);
    set_friction(whole, 0.1);
    whole.advance(401);
    const auto bytes = save_sample(whole);
    whole.advance(407);
    run.how.threads = 2;
    Engine resumed(run.start, run.law, run.how);  // told nothing of what drives it
    restore_sample(resumed, bytes);
    resumed.advance(407);
    EXPECT_EQ(state_hash(resumed), state_hash(whole));
  });
}

TEST(Reproducibility, AnElasticSampleRunsBackToItsStartWhenVelocitiesAreTurnedRound) {
  // Verlet's scheme is its own reverse, so only rounding, grown by the collisions, is left.
  for (const auto kind : {IntegratorKind::velocity_verlet, IntegratorKind::leapfrog}) {
    const Packing start = shaken_lattice(4, 4, 6, false, 1);
    const auto how = with_step(shortest_contact_time() / 40, kind);
    Engine there(start, elastic(), how);
    there.advance(1000);
    Packing turned = packing_of(there);
    EXPECT_GT(norm(turned.grains.position[5] - start.grains.position[5]), 1e-5);
    for (Vec2& v : turned.grains.velocity) v = -v;
    for (double& omega : turned.grains.omega) omega = -omega;
    Engine back(turned, elastic(), how);
    back.advance(1000);
    const Packing end = packing_of(back);
    for (std::size_t i = 0; i < end.grains.size(); ++i)
      EXPECT_LT(norm(end.grains.position[i] - start.grains.position[i]), 1e-8 * 6e-3) << name(kind);
  }
}

}  // namespace
}  // namespace arenite::verification

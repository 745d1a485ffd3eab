#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "core/error.hpp"
#include "grains/dem/run_stage.hpp"
#include "unit/grains/dem/samples.hpp"

namespace arenite::dem {
namespace {

/// Strong and voluminous enough for bridges, or attraction, of several sizes.
ContactParameters cohesive(const Cohesion& law) {
  ContactParameters contact;
  contact.friction = 0.5;
  contact.cohesion = law;
  return contact;
}
CapillaryDisks wet() {
  CapillaryDisks law;
  law.surface_tension = 300;
  law.contact_angle = 0.3;
  law.volume = 1e-8;
  return law;
}
CapillarySpheres wet_spheres() {
  CapillarySpheres law;
  law.surface_tension = 3e3;
  law.volume = 1e-9;
  return law;
}
const Cohesion laws[] = {Dmt{1e4, 1e-4}, wet(), wet_spheres()};

Engine squeezed(const Packing& p, const Cohesion& law, int threads, std::int64_t steps) {
  IntegrationParameters how;
  how.threads = threads;
  Engine engine(p, cohesive(law), how);
  testing::squeeze(engine, steps);
  return engine;
}

TEST(Cohesion, SameBitsOnTwoThreadsAndRestored) {
  const Packing p = testing::crowd(50, 50, 6, 0.0135);
  for (const Cohesion& law : laws) {
    SCOPED_TRACE(law.word());
    Engine a = squeezed(p, law, 1, 1500), b = squeezed(p, law, 2, 1500);
    EXPECT_GT(count_cohesion(a).joined, 500u);
    EXPECT_GT(count_cohesion(a).apart, 10u);
    EXPECT_GT(a.builds, 3);
    EXPECT_EQ(state_hash(a), state_hash(b));
    Engine c = squeezed(p, law, 1, 0);
    for (int n = 0; n < 40; ++n) {  // wherever it stands between two lists, and between pairs that meet and part
      restore_sample(c, save_sample(a));
      a.advance(7);
      c.advance(7);
      ASSERT_EQ(state_hash(a), state_hash(c)) << n;
    }
  }
}

TEST(Cohesion, KernelsOfEveryWidthGiveTheSameBits) {
  const Packing p = testing::crowd(20, 20, 6, 0.0135);
  for (const Cohesion& law : laws) {
    IntegrationParameters how;
    Engine widest(p, cohesive(law), how);
    how.kernel = "portable";
    Engine portable(p, cohesive(law), how);
    widest.advance(500);
    portable.advance(500);
    EXPECT_EQ(state_hash(widest), state_hash(portable)) << law.word();
  }
}

Packing two_disks(double gap) {
  Packing p = testing::empty_container(0.1, 0.1);
  testing::add_grain(p, 0.04, 0.05, 0.006);
  testing::add_grain(p, 0.052 + gap, 0.05, 0.006);
  return p;
}

TEST(Cohesion, LiquidJoinsOnlyGrainsThatHaveTouched) {
  Engine apart(two_disks(1e-6), cohesive(wet()), {}), touching(two_disks(-1e-9), cohesive(wet()), {});
  EXPECT_EQ(count_cohesion(apart).joined, 0u);
  EXPECT_EQ(count_cohesion(touching).joined, 1u);
  Engine sticky(two_disks(1e-6), cohesive(Dmt{1, 1e-5}), {});
  EXPECT_EQ(count_cohesion(sticky).apart, 1u);
  EXPECT_EQ(packing_of(sticky).contacts.size(), 0u);
}

TEST(Cohesion, OfAStateGoesOnInTheNextEngine) {
  Packing p = two_disks(-1e-9);
  p.grains.velocity = {{-2, 0}, {2, 0}};
  ContactParameters contact = cohesive(wet());
  Engine first(p, contact, {});
  first.advance(20);
  const Packing state = packing_of(first);
  ASSERT_EQ(state.contacts.size(), 0u);
  Engine second(state, contact, {});
  ASSERT_EQ(count_cohesion(second).apart, 1u);
  EXPECT_EQ(packing_of(second).cohesive.front().pull, state.cohesive.front().pull);
  Packing parted = state;
  parted.cohesive.clear();
  EXPECT_EQ(count_cohesion(Engine(parted, contact, {})).joined, 0u);
}

TEST(Cohesion, NeitherShortensNorMovesASampleWithoutIt) {
  const Packing p = testing::crowd(20, 20, 6, 0.0135);
  ContactParameters weak;
  weak.cohesion = Dmt{1e-30, 1e-6};
  Engine none(p, {}, {}), almost_none(p, weak, {});
  EXPECT_EQ(none.dt, almost_none.dt);
  none.advance(300);
  almost_none.advance(300);
  EXPECT_NEAR(packing_of(none).grains.position[0].x, packing_of(almost_none).grains.position[0].x, 1e-12);
}

TEST(Cohesion, ASteepPullShortensTheStep) {
  EXPECT_LT(Engine(two_disks(1e-6), cohesive(Dmt{1e4, 1e-7}), {}).dt,
            0.5 * Engine(two_disks(1e-6), cohesive(Dmt{1e-3, 1e-7}), {}).dt);
}

TEST(Cohesion, ThatMakesNoSenseIsRefused) {
  const auto said = [](const Cohesion& law) -> std::string {
    try {
      Engine(two_disks(1e-6), cohesive(law), {});
    } catch (const InputError& error) { return error.what(); }
    return "";
  };
  CapillaryDisks drowned = wet();
  drowned.volume = 0.06 * 0.9 * 0.006 * 0.006;
  EXPECT_NE(said(drowned).find("liquid_volume"), std::string::npos);
  EXPECT_NE(said(Dmt{1, 0.01}).find("adhesion_range"), std::string::npos);
}

TEST(Cohesion, OfAStageIsToldInHistoryStatesAndOutcome) {
  Engine engine(testing::crowd(20, 20, 6, 0.0128), cohesive(wet()), {});
  Stage stage;
  stage.side[right] = {SideDrive::Kind::velocity, -0.5};
  stage.duration = 3e-3;
  StageRun run = begin_stage(engine, stage);
  while (!run.finished) continue_stage(engine, stage, run);
  const CohesionCount count = count_cohesion(engine);
  ASSERT_GT(count.apart, 0u);
  EXPECT_NE(run.result.outcome.find(std::to_string(count.joined) + " cohesive pairs"), std::string::npos)
      << run.result.outcome;
  std::size_t columns = 0;
  for (const auto& column : run.result.history.columns) {
    if (!column.name.starts_with("cohesive_pairs")) continue;
    EXPECT_EQ(column.values.back(), static_cast<double>(column.name == "cohesive_pairs" ? count.joined : count.apart));
    ++columns;
  }
  EXPECT_EQ(columns, 2u);
  const auto& pairs = run.result.snapshots.back().packing.cohesive;
  ASSERT_EQ(pairs.size(), count.joined);
  EXPECT_TRUE(std::is_sorted(pairs.begin(), pairs.end(),
                             [](const auto& a, const auto& b) { return std::pair(a.i, a.j) < std::pair(b.i, b.j); }));
}

}  // namespace
}  // namespace arenite::dem

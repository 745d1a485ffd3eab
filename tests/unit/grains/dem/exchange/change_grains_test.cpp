#include "grains/dem/exchange/change_grains.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "unit/grains/dem/samples.hpp"

namespace arenite::dem {
namespace {

using testing::crowd;

Engine pressed(IntegratorKind integrator = IntegratorKind::velocity_verlet) {
  IntegrationParameters scheme;
  scheme.integrator = integrator;
  scheme.track_energy = true;
  ContactParameters contact;
  contact.friction_law = CundallStrack{};
  Packing p = crowd(8, 8, 3, 0.0118);
  p.domain.wall[top].position = 0.6;  // with room above
  Engine engine(p, contact, scheme);
  set_gravity(engine, {0, -9.81});
  engine.advance(300);
  return engine;
}

std::int32_t inner_number(const Sample& s, std::int32_t grain) {
  for (std::size_t k = 0; k < s.count; ++k)
    if (s.record[k].grain == grain) return static_cast<std::int32_t>(k);
  return -1;
}

/// Forces of all contacts whose grains both are among those named, by ids.
std::vector<std::array<double, 4>> forces_between(const Packing& p, const std::vector<std::int64_t>& ids) {
  std::vector<std::array<double, 4>> rows;
  const auto is_named = [&](std::int64_t id) { return std::ranges::count(ids, id) > 0; };
  for (std::size_t c = 0; c < p.contacts.size(); ++c) {
    const std::int64_t i = p.grains.id[p.contacts.i[c]], j = p.contacts.is_wall(c) ? -1 : p.grains.id[p.contacts.j[c]];
    if (is_named(i) && (j < 0 || is_named(j)))
      rows.push_back({static_cast<double>(i), static_cast<double>(j), p.contacts.fn[c], p.contacts.ft[c]});
  }
  std::ranges::sort(rows);
  return rows;
}

double stored(const Sample& s) {
  const Energies e = energies_of(s);
  return e.kinetic + e.elastic + e.adhesive;
}

TEST(ChangeGrains, LeavesTheContactsOfAllOthersAsTheyAre) {
  Engine engine = pressed();
  synchronise(engine);
  const Packing before = packing_of(engine);
  GrainChanges changes;
  changes.removed = {inner_number(engine, 5), inner_number(engine, 40)};
  changes.moved = {{inner_number(engine, 17), {0.02, 0.5}, {0, -1}}};
  changes.added = {{{0.05, 0.5}, {0.1, -2}, 0.006, 1}};
  change_grains(engine, changes);
  const Packing after = packing_of(engine);
  ASSERT_EQ(after.grains.size(), before.grains.size() - 1);
  std::vector<std::int64_t> stay = before.grains.id;
  for (const std::int64_t id : {1005, 1040, 1017}) std::erase(stay, id);
  const auto forces = forces_between(before, stay);
  ASSERT_GT(forces.size(), 60u);
  EXPECT_EQ(forces_between(after, stay), forces);
  for (const std::int64_t id : {1005, 1040, 1017}) EXPECT_EQ(std::ranges::count(after.grains.id, id), 0);
}

TEST(ChangeGrains, GivesIdsThatNoneHadAndKeepsTheOrder) {
  Engine engine = pressed();
  engine.exchanged.next_id = 2000;
  GrainChanges changes;
  changes.removed = {inner_number(engine, 0)};
  changes.moved = {{inner_number(engine, 2), {0.02, 0.5}, {0, -1}}};
  changes.added = {{{0.05, 0.5}, {0.1, -2}, 0.006, 1}};
  change_grains(engine, changes);
  const Grains now = packing_of(engine).grains;
  EXPECT_EQ(now.id[0], 1001);
  EXPECT_EQ(now.id[1], 2000);
  EXPECT_EQ(now.position[1], (Vec2{0.02, 0.5}));
  EXPECT_EQ(now.id.back(), 2001);
  EXPECT_EQ(now.radius.back(), 0.006);
  EXPECT_EQ(now.material.back(), 1);
  EXPECT_EQ(now.velocity.back(), (Vec2{0.1, -2}));
  EXPECT_EQ(engine.exchanged.next_id, 2002);
}

TEST(ChangeGrains, BooksWhatGrainsBringAndTake) {
  for (const IntegratorKind integrator : {IntegratorKind::velocity_verlet, IntegratorKind::gear5}) {
    Engine engine = pressed(integrator);
    synchronise(engine);
    const double before = stored(engine);
    GrainChanges changes;
    changes.added = {{{0.05, 0.5}, {3, -4}, 0.006, 0}};
    change_grains(engine, changes);
    const double brought = 0.5 * 1410 * std::numbers::pi * 0.006 * 0.006 * 0.06 * 25;
    EXPECT_NEAR(energies_of(engine).exchanged, brought, 1e-12 * before);
    changes = {};
    changes.removed = {inner_number(engine, 20)};
    change_grains(engine, changes);
    EXPECT_NEAR(energies_of(engine).exchanged, stored(engine) - before, 1e-12 * before);
    EXPECT_LT(energies_of(engine).exchanged, brought);
  }
}

TEST(ChangeGrains, ARestoredStateGoesOnWithTheSameBits) {
  for (const IntegratorKind integrator : {IntegratorKind::velocity_verlet, IntegratorKind::gear5}) {
    Engine engine = pressed(integrator);
    engine.exchanged.kept = true;
    engine.exchanged.next_id = 2000;
    GrainChanges changes;
    changes.removed = {inner_number(engine, 5), inner_number(engine, 40)};
    changes.moved = {{inner_number(engine, 17), {0.02, 0.5}, {0, -1}}};
    changes.added = {{{0.05, 0.5}, {0.1, -2}, 0.006, 1}};
    change_grains(engine, changes);
    engine.advance(100);
    const auto bytes = save_sample(engine);
    engine.advance(400);
    Engine resumed = pressed(integrator);
    restore_sample(resumed, bytes);
    EXPECT_EQ(save_sample(resumed), bytes);
    resumed.advance(400);
    EXPECT_EQ(state_hash(resumed), state_hash(engine));
    EXPECT_EQ(packing_of(resumed).grains.id, packing_of(engine).grains.id);
  }
}

}  // namespace
}  // namespace arenite::dem

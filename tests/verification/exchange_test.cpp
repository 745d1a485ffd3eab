#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <tuple>

#include "core/error.hpp"
#include "grains/dem/run_stage.hpp"
#include "grains/fields/discharge.hpp"
#include "verification/support.hpp"

// Grains that come into a sample and leave it.
namespace arenite::verification::exchange {
namespace {

constexpr double disk_radius = 6.2e-3;

packing::Population disks_of(double diameter) {
  packing::Population p;
  p.material = "POM";
  p.count = 1;
  p.size = packing::FixedSize{diameter};
  return p;
}

dem::Inflow inflow_at(double rate, Vec2 velocity, dem::Area area) {
  dem::Inflow inflow;
  inflow.rate = rate;
  inflow.velocity = velocity;
  inflow.area = area;
  inflow.of = {disks_of(2 * disk_radius)};
  return inflow;
}

dem::Stage falling(double duration) {
  dem::Stage stage;
  stage.name = "flow";
  stage.gravity = true;
  stage.duration = duration;
  stage.snapshots = 4;
  return stage;
}

dem::StageRun carried_out(dem::Engine& engine, const dem::Stage& stage) {
  dem::StageRun run = dem::begin_stage(engine, stage);
  while (!run.finished) dem::continue_stage(engine, stage, run);
  return run;
}

const std::vector<double>& column(const dem::StageRun& run, const char* name) {
  const auto* values = run.result.history.find(name);
  if (!values) throw std::out_of_range(name);
  return *values;
}

/// A box with one grain at rest on its floor; soft, so that steps are long.
Packing nearly_empty(double width, double height) {
  Packing p = box(width, height);
  for (Material& m : p.materials) m.stiffness = 2e5;
  add(p, {{0.02, disk_radius}});
  return p;
}

dem::IntegrationParameters tracked(int threads = 1) {
  dem::IntegrationParameters p;
  p.track_energy = true;
  p.threads = threads;
  return p;
}

TEST(Exchange, AnInflowBringsItsRateTimesTheTime) {
  dem::Engine engine(nearly_empty(0.3, 0.4), {}, tracked());
  dem::Stage stage = falling(0.5);
  stage.exchange.inflow = {inflow_at(200, {0, -2}, {{}, {}, 0.36, {}})};
  const dem::StageRun run = carried_out(engine, stage);
  const auto &time = column(run, "time"), &inserted = column(run, "inserted");
  for (std::size_t k = 0; k < time.size(); ++k) EXPECT_NEAR(inserted[k], 200 * time[k], 0.51) << time[k];
  EXPECT_EQ(inserted.back(), 100);
  EXPECT_EQ(column(run, "grains").back(), 101);
  EXPECT_EQ(column(run, "waiting").back(), 0);
  const double one = 1410 * pi * disk_radius * disk_radius * 0.06;
  EXPECT_NEAR(column(run, "inserted_mass").back(), 100 * one, 1e-9 * one);
  EXPECT_EQ(run.result.snapshots.back().packing.grains.size(), 101u);
  EXPECT_NE(run.result.outcome.find("100 grains came in, 0 left"), std::string::npos) << run.result.outcome;
}

TEST(Exchange, AMassRateIsMetToHalfAGrain) {
  dem::Engine engine(nearly_empty(0.3, 0.4), {}, {});
  dem::Stage stage = falling(0.3);
  dem::Inflow inflow = inflow_at(1, {0, -2}, {{}, {}, 0.36, {}});
  const double largest = 1410 * pi * disk_radius * disk_radius * 0.06;
  inflow.rate.reset();
  inflow.mass_rate = 100 * largest;
  inflow.of.front().size = packing::UniformSizes{1.4 * disk_radius, 2 * disk_radius};
  stage.exchange.inflow = {inflow};
  const dem::StageRun run = carried_out(engine, stage);
  const auto &time = column(run, "time"), &mass = column(run, "inserted_mass");
  for (std::size_t k = 0; k < time.size(); ++k)
    EXPECT_NEAR(mass[k], *inflow.mass_rate * time[k], 0.5001 * largest) << time[k];
  EXPECT_GT(column(run, "inserted").back(), 32);  // of smaller grains more
}

TEST(Exchange, WhatFindsNoRoomWaits) {
  dem::Engine engine(nearly_empty(0.1, 0.1), {}, {});
  dem::Stage stage = falling(0.4);
  dem::Inflow inflow = inflow_at(1000, {}, {{}, {}, 0.085, 0.085});  // a line
  stage.exchange.inflow = {inflow};
  const dem::StageRun run = carried_out(engine, stage);
  const double inserted = column(run, "inserted").back(), waiting = column(run, "waiting").back();
  EXPECT_LT(inserted, 80);
  EXPECT_EQ(inserted + waiting, 400);
  EXPECT_NE(run.result.outcome.find("wait, for there is no room"), std::string::npos) << run.result.outcome;
}

TEST(Exchange, AnOutletTakesAllThatFallsIntoItAndAnInflowEndsWithItsCount) {
  dem::Engine engine(nearly_empty(0.3, 0.4), {}, {});
  dem::Stage stage = falling(1.0);
  dem::Inflow inflow = inflow_at(200, {0, -2}, {{}, {}, 0.36, {}});
  inflow.count = 40;
  stage.exchange.inflow = {inflow};
  stage.exchange.outlets = {{{{}, {}, {}, 0.05}, {}, {}}};
  const dem::StageRun run = carried_out(engine, stage);
  EXPECT_EQ(column(run, "inserted").back(), 40);
  EXPECT_EQ(column(run, "removed").back(), 40);
  EXPECT_EQ(column(run, "grains").back(), 1);  // of the 41 one stays: a sample has one at least
  EXPECT_EQ(run.result.snapshots.back().packing.grains.size(), 1u);
}

TEST(Exchange, GrainsFallAsFreeOnesDo) {
  dem::Engine engine(nearly_empty(0.3, 0.4), {}, {});
  dem::Stage stage = falling(0.1);
  dem::Inflow inflow = inflow_at(1e5, {0.1, -1}, {{}, {}, 0.38, 0.38});
  inflow.count = 1;
  stage.exchange.inflow = {inflow};
  const dem::StageRun run = carried_out(engine, stage);
  const Packing& end = run.result.snapshots.back().packing;
  ASSERT_EQ(end.grains.size(), 2u);
  const double time = run.result.snapshots.back().time - column(run, "time").front();
  EXPECT_NEAR(end.grains.position[1].y, 0.38 - time - 0.5 * gravity * time * time, 1e-9);
  EXPECT_NEAR(end.grains.velocity[1].y, -1 - gravity * time, 1e-9);
  EXPECT_NEAR(end.grains.velocity[1].x, 0.1, 1e-12);
}

/// Grains of so many columns above an opening; those that fell through come back at the top.
dem::StageRun recycled(double duration, int columns = 11, int threads = 1, std::vector<std::uint8_t>* state = nullptr) {
  const double pitch = 0.0135, width = columns * pitch;
  Packing p = box(width, 0.6);
  for (Material& m : p.materials) m.stiffness = 2e5;
  for (int k = 0; k < 20 * columns; ++k)
    add(p, {{(0.5 + k % columns) * pitch, 0.0655 + pitch * static_cast<double>(k / columns)}});
  for (const auto& [name, wall, edge] :
       {std::tuple{"left shelf", 0.0, 0.27 * width}, {"right shelf", width, 0.73 * width}}) {
    Boundary floor;
    floor.name = name;
    floor.points = {{wall, 0.055}, {edge, 0.055}};
    p.domain.boundaries.push_back(floor);
  }
  dem::ContactParameters contact;
  contact.friction = 0.3;
  dem::Engine engine(p, contact, tracked(threads));
  dem::Stage stage = falling(duration);
  stage.exchange.outlets = {{{{}, {}, {}, 0.04}, dem::Area{{}, {}, 0.45, {}}, {0, -1}}};
  dem::StageRun run = carried_out(engine, stage);
  if (state) *state = save_sample(engine);
  return run;
}

TEST(Exchange, ARecycledSiloIsSteadyAndItsEnergyBalanceCloses) {
  const dem::StageRun run = recycled(1.5);
  const auto& grains = column(run, "grains");
  EXPECT_TRUE(std::ranges::all_of(grains, [](double n) { return n == 220; }));
  EXPECT_EQ(column(run, "inserted"), column(run, "removed"));
  EXPECT_EQ(column(run, "inserted_mass"), column(run, "removed_mass"));
  EXPECT_GT(column(run, "removed").back(), 220) << "the silo has not been emptied once";
  const fields::Discharge flow = fields::find_discharge(column(run, "time"), column(run, "removed"));
  EXPECT_FALSE(flow.stopped);
  const auto change = [&](const char* name) { return column(run, name).back() - column(run, name).front(); };
  const double kept = change("kinetic") + change("elastic"),
               spent = change("dissipated_normal") + change("dissipated_friction") + change("dissipated_drag"),
               given = change("work_gravity") + change("work_walls") + change("exchanged");
  EXPECT_GT(std::abs(change("exchanged")), 0.01 * change("work_gravity"));
  EXPECT_NEAR(kept + spent, given, 2e-3 * change("work_gravity"));
  const Packing &first = run.result.snapshots.front().packing, &last = run.result.snapshots.back().packing;
  EXPECT_EQ(first.grains.radius, last.grains.radius);
  EXPECT_NE(first.grains.id, last.grains.id);
}

TEST(Exchange, HasTheSameBitsForAnyThreadCount) {
  std::vector<std::uint8_t> one, two;
  const dem::StageRun run = recycled(0.12, 110, 1, &one);
  EXPECT_GT(column(run, "removed").back(), 50);
  recycled(0.12, 110, 2, &two);
  EXPECT_EQ(one, two);
}

TEST(Exchange, TheInflowOfAStageIsThatOfASeed) {
  const auto ends = [](std::uint64_t seed) {
    dem::Engine engine(nearly_empty(0.3, 0.4), {}, {});
    dem::Stage stage = falling(0.2);
    stage.exchange.inflow = {inflow_at(100, {0, -2}, {{}, {}, 0.36, {}})};
    stage.exchange.seed = seed;
    carried_out(engine, stage);
    return state_hash(engine);
  };
  EXPECT_EQ(ends(1), ends(1));
  EXPECT_NE(ends(1), ends(2));
}

TEST(Exchange, ALighterGrainShortensTheStep) {
  dem::Engine engine(nearly_empty(0.3, 0.4), {}, {});
  const double dt = engine.dt;
  dem::Stage stage = falling(0.01);
  stage.exchange.inflow = {inflow_at(100, {0, -2}, {{}, {}, 0.36, {}})};
  stage.exchange.inflow.front().of = {disks_of(disk_radius)};
  dem::begin_stage(engine, stage);
  EXPECT_NEAR(engine.dt, 0.5 * dt, 0.01 * dt);
}

TEST(Exchange, RefusesInOneSentenceWhatItCannotDo) {
  const auto refusal = [](const auto& change) {
    dem::Engine engine(nearly_empty(0.3, 0.4), {}, {});
    dem::Stage stage = falling(0.1);
    stage.exchange.inflow = {inflow_at(100, {0, -2}, {{}, {}, 0.36, {}})};
    change(stage);
    try {
      dem::begin_stage(engine, stage);
    } catch (const InputError& error) { return std::string(error.what()); }
    return std::string();
  };
  EXPECT_EQ(refusal([](dem::Stage&) {}), "");
  EXPECT_NE(refusal([](dem::Stage& s) { s.exchange.inflow[0].area.top = 0.5; }).find("container"), std::string::npos);
  EXPECT_NE(refusal([](dem::Stage& s) { s.rough[bottom] = true; }).find("rough wall"), std::string::npos);
  EXPECT_NE(refusal([](dem::Stage& s) { s.exchange.inflow[0].of[0].material = "gold"; }).find("gold"),
            std::string::npos);
}

}  // namespace
}  // namespace arenite::verification::exchange

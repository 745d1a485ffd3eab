#pragma once
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "geometry/close_pairs.hpp"
#include "grains/packing/fill.hpp"
#include "report/page.hpp"
#include "workflow/asked.hpp"

namespace arenite::test {

/// Disks of two materials in a box, contacts with F_n = k h. Without friction the least overlap energy is mechanical
/// equilibrium, so squeezing the box and relaxing gives true states of loading in a moment.
inline Contacts elastic_contacts(const Grains& grains, const Domain& domain, double stiffness) {
  Contacts contacts;
  const geometry::Box<2> box{domain.corner(), domain.size()};
  for (const auto& [i, j] : geometry::close_pairs(grains.position, grains.radius, box, 0)) {
    const Vec2 d = grains.position[static_cast<std::size_t>(i)] - grains.position[static_cast<std::size_t>(j)];
    const double ri = grains.radius[static_cast<std::size_t>(i)], rj = grains.radius[static_cast<std::size_t>(j)];
    const double h = ri + rj - norm(d);
    contacts.add(i, j, (1 / norm(d)) * d, stiffness * h, 0.02 * stiffness * h, ri - h / 2, rj - h / 2);
  }
  for (std::size_t g = 0; g < grains.size(); ++g) {
    const double r = grains.radius[g];
    const double gap[4] = {
        grains.position[g].x - domain.wall[left].position, domain.wall[right].position - grains.position[g].x,
        grains.position[g].y - domain.wall[bottom].position, domain.wall[top].position - grains.position[g].y};
    for (int side = 0; side < 4; ++side)
      if (gap[side] < r)
        contacts.add(static_cast<std::int32_t>(g), wall_partner(side), inward_normal(side), stiffness * (r - gap[side]),
                     0, gap[side], 0);
  }
  return contacts;
}

inline void load_walls(Packing& packing) {
  for (Wall& wall : packing.domain.wall) wall.force = 0;
  for (std::size_t c = 0; c < packing.contacts.size(); ++c)
    if (packing.contacts.is_wall(c))
      packing.domain.wall[static_cast<std::size_t>(packing.contacts.wall_side(c))].force += packing.contacts.fn[c];
}

/// A run of five states as it might come from the store; the first contact of the last state pulls.
struct PageSample {
  static constexpr const char* recipe = R"(title = "<two> materials & a container"
[materials.POM]
density = "1410 kg/m^3"
stiffness = "27.35 kN/mm"
[materials.HDPE]
density = "950 kg/m^3"
stiffness = "6.43 kN/mm"
[[populations]]
material = "POM"
ratio = 1
diameter = "16.4 mm"
[[populations]]
material = "HDPE"
ratio = 1
diameter = "10.5 mm"
[packing]
method = "random"
grains = 260
solid_fraction = 0.5
[container]
width = "300 mm"
thickness = "60 mm"
[[stages]]
name = "load"
bottom = { pressure = "1 kPa" }
)";
  StageResult stage;
  report::PageData data;

  explicit PageSample(std::size_t count = 260) {
    Grains grains;
    grains.resize(count);
    for (std::size_t g = 0; g < count; ++g) {
      grains.material[g] = g % 2 == 0 ? 0 : 1;
      grains.radius[g] = g % 2 == 0 ? 8.2e-3 : 5.25e-3;
      grains.id[g] = static_cast<std::int64_t>(g) + 1;
    }
    double area = 0;
    for (const double r : grains.radius) area += 3.14159265 * r * r;
    Domain domain;
    domain.thickness = 0.06;
    domain.wall[right].position = domain.wall[top].position = std::sqrt(area / 0.72);
    packing::fill_at_random(grains, domain, 7);
    const double lowest = domain.height() * (1 - 0.72 / 0.845),
                 step = (domain.height() * (1 - 0.72 / 0.9) - lowest) / 4;
    History history{{{"time", "s", {}},
                     {"bottom_position", "m", {}},
                     {"bottom_force", "N", {}},
                     {"top_force", "N", {}},
                     {"left_force", "N", {}},
                     {"right_force", "N", {}},
                     {"elastic", "J", {}},
                     {"kinetic", "J", {}},
                     {"top_position", "m", {}},
                     {"left_position", "m", {}},
                     {"right_position", "m", {}}}};
    for (int k = 0; k < 5; ++k) {
      const double before = domain.wall[bottom].position;
      domain.wall[bottom].position = lowest + k * step;
      for (std::size_t g = 0; g < count; ++g)
        grains.position[g].y +=
            (domain.wall[bottom].position - before) * (1 - grains.position[g].y / domain.wall[top].position);
      packing::relax(grains, domain, 1e-9, 4000);
      stage.snapshots.push_back(state(grains, domain, k));
      record(history, stage.snapshots.back());
    }
    Contacts& last = stage.snapshots.back().packing.contacts;
    const auto between_grains = std::find_if(last.j.begin(), last.j.end(), [](std::int32_t j) { return j >= 0; });
    const auto pulling = static_cast<std::size_t>(between_grains - last.j.begin());
    last.fn[pulling] = -2 * *std::max_element(last.fn.begin(), last.fn.end()) / 3;
    last.glued[pulling] = 1;
    stage.name = "load";
    stage.outcome = "Equilibrium in all 5 increments.";
    stage.history = history;
    stage.provenance = {
        "0.1.0", "load", "0123456789abcdef", recipe, 7, "portable", {}, "<two> materials & a container"};
    const auto asked = arenite::recipe::parse_recipe(recipe, "recipe");
    StageResult packed;
    workflow::note_asked(packed, asked, 0);
    workflow::note_asked(stage, asked, 1);
    stage.asked.diameter = packed.asked.diameter;
    stage.asked.passing = packed.asked.passing;
    data.title = "Two materials <in> a container";
    data.stages = {&stage, 1};
  }

  PageSample(const PageSample&) = delete;
  PageSample& operator=(const PageSample&) = delete;

 private:
  static Snapshot state(const Grains& grains, const Domain& domain, int k) {
    Snapshot snapshot;
    snapshot.time = 0.1 * (k + 1);
    snapshot.step = 10000 * (k + 1);
    snapshot.label = "increment " + std::to_string(k + 1) + " of 5";
    snapshot.packing = {{{"POM", 1410, 27.35e6, 0.015e-6}, {"HDPE", 950, 6.43e6, 0.0258e-6}},
                        domain,
                        grains,
                        elastic_contacts(grains, domain, 6e6),
                        {},
                        {}};
    load_walls(snapshot.packing);
    // Moves to the right the faster the higher, and turns clockwise.
    for (std::size_t g = 0; g < grains.size(); ++g) {
      snapshot.packing.grains.velocity[g].x = 0.1 * grains.position[g].y;
      snapshot.packing.grains.omega[g] = -0.05 * k;
    }
    return snapshot;
  }

  static void record(History& history, const Snapshot& snapshot) {
    const auto& wall = snapshot.packing.domain.wall;
    double elastic = 0;
    for (const double fn : snapshot.packing.contacts.fn) elastic += fn * fn / (2 * 6e6);
    const double row[] = {snapshot.time,
                          wall[bottom].position,
                          wall[bottom].force,
                          wall[top].force,
                          wall[left].force,
                          wall[right].force,
                          elastic,
                          1e-6 * elastic,
                          wall[top].position,
                          wall[left].position,
                          wall[right].position};
    for (std::size_t c = 0; c < history.columns.size(); ++c) history.columns[c].values.push_back(row[c]);
  }
};

}  // namespace arenite::test

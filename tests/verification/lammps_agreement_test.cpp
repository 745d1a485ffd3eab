#include <fmt/core.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <sstream>

#include "support/program.hpp"
#include "verification/support.hpp"

namespace arenite {
namespace {

using verification::pi;

/// The same law in both codes: LAMMPS multiplies its damping rates by the reduced mass, ours are given as they are.
/// With equal masses and half the rates at the walls the two mean the same.
struct Law {
  double damping = 0;    ///< alpha_n, N s/m
  double viscosity = 0;  ///< gamma_s, N s/m
  double friction = 0;
};

constexpr double stiffness = 1e6, mass = 0.08, size = 0.1;  // N/m, kg, m
constexpr int steps = 2000, rows = 8;

double time_step() { return pi * std::sqrt(0.5 * mass / stiffness) / 50; }

/// 64 disks of three radii and one mass that fly about in a frame under gravity.
Packing flying_disks() {
  Packing p;
  const double radii[3] = {4.5e-3, 5e-3, 5.5e-3};
  for (const double r : radii) p.materials.push_back({fmt::format("{}", r), mass / (pi * r * r), stiffness, 0});
  p.domain.wall[right].position = p.domain.wall[top].position = size;
  p.domain.thickness = 1;
  RandomStream random(3, Purpose::test);
  for (int k = 0; k < rows * rows; ++k) {
    const auto kind = static_cast<std::int32_t>(random.below(3));
    verification::add(p, {.centre = {(k % rows + 0.5) * size / rows, (k / rows + 0.5) * size / rows},
                          .radius = radii[kind],
                          .material = kind,
                          .velocity = {0.6 * random.normal(), 0.6 * random.normal()},
                          .spin = 100 * random.normal()});
  }
  return p;
}

void write_input(const std::filesystem::path& folder, const Packing& p, const Law& law) {
  std::ofstream data(folder / "data");
  data << "flying disks\n\n"
       << p.grains.size() << " atoms\n1 atom types\n\n"
       << fmt::format("{0} {1} xlo xhi\n{0} {1} ylo yhi\n-0.01 0.01 zlo zhi\n\nAtoms # sphere\n\n", -size, 2 * size);
  for (std::size_t k = 0; k < p.grains.size(); ++k) {
    const double r = p.grains.radius[k];  // LAMMPS takes the density of a sphere
    data << fmt::format("{} 1 {:.17g} {:.17g} {:.17g} {:.17g} 0\n", k + 1, 2 * r, 0.75 * mass / (pi * r * r * r),
                        p.grains.position[k].x, p.grains.position[k].y);
  }
  data << "\nVelocities\n\n";
  for (std::size_t k = 0; k < p.grains.size(); ++k)
    data << fmt::format("{} {:.17g} {:.17g} 0 0 0 {:.17g}\n", k + 1, p.grains.velocity[k].x, p.grains.velocity[k].y,
                        p.grains.omega[k]);

  const auto coefficients = [&](double reduced_mass) {
    return fmt::format("{:.17g} 0 {:.17g} {:.17g} {:.17g} 1", stiffness, law.damping / reduced_mass,
                       law.viscosity / reduced_mass, law.friction);
  };
  std::ofstream(folder / "in") << "units si\ndimension 2\natom_style sphere\nnewton off\ncomm_modify vel yes\n"
                                  "boundary f f p\nread_data data\n"
                               << "pair_style gran/hooke " << coefficients(0.5 * mass) << "\npair_coeff * *\n"
                               << "neighbor 2e-3 bin\nneigh_modify delay 0 every 1 check yes\n"
                               << fmt::format("timestep {:.17g}\n", time_step())
                               << "fix weight all gravity 9.81 vector 0 -1 0\nfix move all nve/sphere disc\n"
                               << "fix sides all wall/gran hooke " << coefficients(mass) << " xplane 0 " << size << "\n"
                               << "fix ends all wall/gran hooke " << coefficients(mass) << " yplane 0 " << size << "\n"
                               << "fix plane all enforce2d\ndump state all custom " << steps << " state id x y fx fy\n"
                               << "dump_modify state sort id format float %.17g\nrun " << steps << "\n";
}

struct State {
  std::vector<Vec2> place, force;
};

/// The last state in the dump.
State lammps(const Packing& p, const Law& law) {
  const test::TemporaryFolder folder;
  write_input(folder.path(), p, law);
  const auto run = test::shell("cd " + folder.path().string() + " && OMP_NUM_THREADS=1 lmp -in in -log none");
  EXPECT_EQ(run.status, 0) << run.out << run.err;
  std::istringstream lines(test::slurp(folder / "state"));
  State state;
  for (std::string line; std::getline(lines, line);) {
    if (line.rfind("ITEM: ATOMS", 0) != 0) continue;
    state = {};
    for (std::size_t k = 0; k < p.grains.size(); ++k) {
      std::getline(lines, line);
      std::istringstream words(line);
      int id = 0;
      Vec2 x, f;
      words >> id >> x.x >> x.y >> f.x >> f.y;
      state.place.push_back(x);
      state.force.push_back(f);
    }
  }
  return state;
}

State ours(const Packing& start, const Law& law) {
  dem::ContactParameters contact;
  contact.friction_law = dem::RegularisedCoulomb{};
  contact.attractive_dashpot = true;
  contact.stiffness_rule = dem::StiffnessRule::series;
  contact.normal_damping = law.damping;
  contact.sliding_viscosity = law.viscosity;
  contact.friction = law.friction;
  contact.arms = dem::Arms::full_radius;
  dem::IntegrationParameters integration;
  integration.integrator = dem::IntegratorKind::leapfrog;
  integration.time_step = time_step();
  dem::Engine engine(start, contact, integration);
  set_gravity(engine, {0, -9.81});
  engine.advance(steps);
  const Packing p = packing_of(engine);
  State state;
  for (std::size_t k = 0; k < p.grains.size(); ++k) {
    state.place.push_back(p.grains.position[k]);
    state.force.push_back({0, -9.81 * mass});
  }
  for (std::size_t c = 0; c < p.contacts.size(); ++c) {
    const Vec2 f = p.contacts.force_on_i(c);
    state.force[static_cast<std::size_t>(p.contacts.i[c])] += f;
    if (!p.contacts.is_wall(c)) state.force[static_cast<std::size_t>(p.contacts.j[c])] -= f;
  }
  return state;
}

void expect_agreement(const Law& law) {
  if (test::shell("command -v lmp").status != 0) GTEST_SKIP() << "lmp (Debian package lammps) is not installed";
  const Packing start = flying_disks();
  const State theirs = lammps(start, law), own = ours(start, law);
  ASSERT_EQ(theirs.place.size(), start.grains.size());
  double way = 0, largest = 0, place_off = 0, force_off = 0;
  for (std::size_t k = 0; k < start.grains.size(); ++k) {
    way = std::max(way, norm(own.place[k] - start.grains.position[k]));
    largest = std::max(largest, norm(own.force[k]));
    place_off = std::max(place_off, norm(own.place[k] - theirs.place[k]));
    force_off = std::max(force_off, norm(own.force[k] - theirs.force[k]));
  }
  EXPECT_GT(way, 1e-2);                  // it was no still life
  EXPECT_GT(largest, 10 * 9.81 * mass);  // nor a gas without contacts
  EXPECT_LT(place_off, 1e-6 * 1e-2) << "of a diameter of 1 cm";
  EXPECT_LT(force_off, 1e-6 * largest);
}

// LAMMPS caps friction by mu |F_n| also where a dashpot pulls, ours by 0 there: the two parts of the law apart.
TEST(LammpsAgreement, FrictionOfDisksWithoutNormalDamping) {
  expect_agreement({.damping = 0, .viscosity = 20, .friction = 0.3});
}
TEST(LammpsAgreement, NormalDampingWithoutFriction) {
  expect_agreement({.damping = 30, .viscosity = 0, .friction = 0});
}

}  // namespace
}  // namespace arenite

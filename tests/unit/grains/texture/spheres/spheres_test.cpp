#include "grains/texture/spheres/spheres.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <numbers>
#include <string>
#include <vector>

#include "core/error.hpp"
#include "core/random.hpp"

namespace arenite::texture::spheres_test {
namespace {

double value(const Numbers& numbers, const char* path) {
  const Numbers* node = numbers.at_path(path);
  return node ? (node->is_tree() ? (*node)["value"] : *node).get<double>() : NAN;
}

/// A face-centred crystal of 4 n^3 spheres of diameter 2 mm in a periodic cell, each contact pressed with 3 N.
PackingIn<3> crystal(int n) {
  PackingIn<3> packing;
  packing.materials = {{"glass", 2500, 1e5}};
  const double side = 2e-3 * std::numbers::sqrt2;  // of a cell of four spheres that touch
  packing.domain.periodic = {true, true, true};
  for (int s = 0; s < 6; ++s) packing.domain.wall[s] = {false, s % 2 == 0 ? 0 : n * side};
  std::vector<Vec3> place;
  for (int k = 0; k < n * n * n; ++k)
    for (const Vec3 of : {Vec3{0, 0, 0}, Vec3{0.5, 0.5, 0}, Vec3{0.5, 0, 0.5}, Vec3{0, 0.5, 0.5}})
      place.push_back(side * (of + Vec3{k % n + 0.1, k / n % n + 0.1, k / n / n + 0.1}));
  packing.grains.resize(place.size());
  packing.grains.position = place;
  packing.grains.radius.assign(place.size(), 1e-3);
  for (std::size_t i = 0; i < place.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      const Vec3 way = packing.domain.nearest_image(place[i] - place[j]);
      if (norm(way) < 2.01e-3)
        packing.contacts.add(static_cast<std::int32_t>(i), static_cast<std::int32_t>(j), way / norm(way), 3, {}, 1e-3,
                             1e-3);
    }
  return packing;
}

TEST(Spheres, ACrystalHasTwelveNeighboursAndTheDensestFraction) {
  const Numbers numbers = measure_spheres(crystal(3));
  EXPECT_EQ(value(numbers, "/coordination/all"), 12);
  EXPECT_EQ(value(numbers, "/coordination/without_rattlers"), 12);
  EXPECT_EQ(value(numbers, "/coordination/rattlers"), 0);
  EXPECT_NEAR(value(numbers, "/solid_fraction"), std::numbers::pi / (3 * std::numbers::sqrt2), 1e-13);
}

TEST(Spheres, ABoxWithoutAllOfItsWallsIsTold) {
  PackingIn<3> packing = crystal(2);
  packing.domain.periodic[2] = false;
  for (const int side : {back, front}) packing.domain.wall[side].present = side == back;
  const std::string notes = to_json(measure_spheres(packing)["notes"]);
  EXPECT_NE(notes.find("No wall stands on the side front: "), std::string::npos) << notes;
  EXPECT_EQ(notes.find("back"), std::string::npos) << notes;
}

/// Windows of a twentieth of the side lie in a sphere or beside it; the largest cut off a layer of a fiftieth, which
/// may hold as much less or more of the solid.
TEST(Spheres, WindowsOfACrystalKnowItsFractionTheBetterTheLargerTheyAre) {
  const Numbers numbers = measure_spheres(crystal(4));
  const auto share = numbers.at_path("/rev/volume_share")->get<std::vector<double>>(),
             mean = numbers.at_path("/rev/mean")->get<std::vector<double>>(),
             deviation = numbers.at_path("/rev/deviation")->get<std::vector<double>>();
  ASSERT_EQ(share.size(), 20u);
  EXPECT_NEAR(share.front(), std::pow(0.05, 3), 1e-12);
  EXPECT_NEAR(share.back(), std::pow(0.98, 3), 1e-12);
  const double crystal_fraction = std::numbers::pi / (3 * std::numbers::sqrt2);
  EXPECT_NEAR(mean.back(), crystal_fraction, 0.03 * crystal_fraction);
  EXPECT_LT(deviation.back(), 0.1 * deviation.front());
  // Of fifty windows, four standard errors.
  EXPECT_NEAR(mean.front(), crystal_fraction, 4 * deviation.front() / std::sqrt(50));
}

/// A sphere in the middle of a periodic cell lies within all large windows that keep to the cell; the mean over places
/// is the solid fraction only if windows stand across its sides as often as elsewhere.
TEST(Spheres, WindowsOfAPeriodicCellSeeEachPartAsOften) {
  PackingIn<3> packing;
  packing.materials = {{"glass", 2500, 1e5}};
  packing.domain.periodic = {true, true, true};
  for (int s = 0; s < 6; ++s) packing.domain.wall[s] = {false, s % 2 == 0 ? 0.0 : 10e-3};
  packing.grains.resize(1);
  packing.grains.radius = {3e-3};
  packing.grains.position = {{5e-3, 5e-3, 5e-3}};
  const double fraction = 4.0 / 3 * std::numbers::pi * 0.027;
  const TextureIn<3> texture = measure(packing);
  EXPECT_NEAR(texture.solid_fraction.value, fraction, 1e-14);
  const Rev& rev = texture.rev;
  ASSERT_EQ(rev.mean.size(), 20u);
  // Of fifty windows, four standard errors.
  for (std::size_t s = 0; s < 20; ++s)
    EXPECT_NEAR(rev.mean[s], fraction, 4 * rev.deviation[s] / std::sqrt(50)) << rev.share[s];
}

/// Of equal forces f on contacts of length d: p = n_c f d/3, with n_c contacts a volume.
TEST(Spheres, PressureIsThatOfTheForcesAndTheSameAlongAllAxes) {
  const PackingIn<3> packing = crystal(3);
  const Numbers numbers = measure_spheres(packing);
  const double pressure = static_cast<double>(packing.contacts.size()) * 3 * 2e-3 / (3 * volume_of(packing.domain));
  EXPECT_NEAR(value(numbers, "/stress_details/pressure_Pa") / pressure, 1, 1e-12);
  EXPECT_NEAR(value(numbers, "/stress_details/deviator_Pa") / pressure, 0, 1e-12);
  for (int axis = 0; axis < 3; ++axis)
    EXPECT_NEAR(numbers["stress"]["value"][axis][axis].get<double>() / pressure, -1, 1e-12);
}

/// Twelve directions along the diagonals of faces: <n n> is isotropic.
TEST(Spheres, TheFabricOfACrystalIsIsotropicToSecondOrderOnly) {
  PackingIn<3> packing = crystal(3);
  EXPECT_NEAR(value(measure_spheres(packing), "/fabric/a_c"), 0, 1e-12);
  // Those along one plane's diagonals alone tell the axis.
  ContactsIn<3> flat;
  for (std::size_t c = 0; c < packing.contacts.size(); ++c)
    if (std::abs(packing.contacts.normal[c].z) < 0.1)
      flat.add(packing.contacts.i[c], packing.contacts.j[c], packing.contacts.normal[c], 3, {}, 1e-3, 1e-3);
  packing.contacts = flat;
  const Numbers numbers = measure_spheres(packing);
  // a = 15/2 (1/6, 1/6, -1/3), sqrt(3/2 a:a) = 15/4
  EXPECT_NEAR(value(numbers, "/fabric/a_c"), 3.75, 1e-9);
  SphereOptions along_x;
  along_x.load_axis = 0;
  EXPECT_NEAR(value(measure_spheres(packing, along_x), "/fabric/a_c_signed"), 1.5 * 7.5 / 6, 1e-9);
  EXPECT_NEAR(numbers["fabric"]["principal"][2].get<double>(), 0, 1e-12);
}

/// Where no direction is preferred, the axis of most contacts is any; an error that let it turn with the contacts that
/// are left would be twice as large as P_4 scatters from sample to sample, 1/(3 sqrt(n)).
TEST(Spheres, TheFourthOrderAboutAnAxisHasTheErrorThatSamplesScatterBy) {
  double told = 0, off = 0, expected = 0;
  constexpr int samples = 24;
  for (std::uint64_t seed = 1; seed <= samples; ++seed) {
    PackingIn<3> packing = crystal(5);
    RandomStream random(seed, Purpose::test);
    for (Vec3& normal : packing.contacts.normal) {
      const double z = random.uniform(-1, 1), angle = random.uniform(0, 2 * std::numbers::pi), r = std::sqrt(1 - z * z);
      normal = {r * std::cos(angle), r * std::sin(angle), z};
    }
    const Numbers numbers = measure_spheres(packing);
    const double error = (*numbers.at_path("/fabric/p_4"))["error"].get<double>();
    told += error * error / samples;
    off += std::pow(value(numbers, "/fabric/p_4"), 2) / samples;
    expected += 1 / (9 * value(numbers, "/fabric/contacts")) / samples;
  }
  EXPECT_NEAR(std::sqrt(off / expected), 1, 0.45);
  EXPECT_NEAR(std::sqrt(told / expected), 1, 0.25);
}

/// Random directions have the anisotropy that is told of chance, and forces that press by direction the one that is
/// put in: f = f_0 (1 + b n n) with b = diag(0.4, -0.2, -0.2), sqrt(3/2 b:b) = 0.6, and a quarter of b along the
/// contacts. The stress of such contacts is q/p = 2/5 (a_n + 3/2 a_t), but for the chance of the directions (Guo and
/// Zhao 2013).
TEST(Spheres, ForcesByDirectionAreToldWhateverTheCounts) {
  PackingIn<3> packing = crystal(4);
  packing.contacts = {};
  RandomStream random(7, Purpose::test);
  constexpr std::size_t contacts = 4000;
  for (std::size_t c = 0; c < contacts; ++c) {
    const double z = random.uniform(-1, 1), angle = random.uniform(0, 2 * std::numbers::pi), r = std::sqrt(1 - z * z);
    const Vec3 n{r * std::cos(angle), r * std::sin(angle), z};
    const double force = 2 * (1 + 0.4 * n.x * n.x - 0.2 * (n.y * n.y + n.z * n.z));
    const Vec3 drawn = 2 * 0.25 * Vec3{0.4 * n.x, -0.2 * n.y, -0.2 * n.z};
    packing.contacts.add(static_cast<std::int32_t>(c % 255), 255, n, force, cross(n, drawn), 1e-3, 1e-3);
  }
  const Numbers numbers = measure_spheres(packing);
  EXPECT_NEAR(value(numbers, "/fabric/a_n"), 0.6, 1e-6);
  EXPECT_NEAR(value(numbers, "/fabric/a_t"), 0.15, 1e-6);
  const double noise = value(numbers, "/fabric/a_c_noise");
  EXPECT_NEAR(noise, 7.5 / std::sqrt(static_cast<double>(contacts)), 1e-12);
  EXPECT_LT(value(numbers, "/fabric/a_c"), 2.5 * noise);
  EXPECT_GT(value(numbers, "/fabric/a_c"), 0.2 * noise);
}

/// The axes of an icosahedron weigh polynomials up to the fifth degree as all directions do: q/p = 2/5 (a_n + 3/2 a_t)
/// (Guo and Zhao 2013).
TEST(Spheres, TheStressRatioIsThatOfTheAnisotropies) {
  PackingIn<3> packing = crystal(4);
  packing.contacts = {};
  const double golden = std::numbers::phi, length = std::hypot(1, golden);
  for (int axis = 0; axis < 3; ++axis)
    for (const double sign : {1, -1}) {
      Vec3 n;
      n[axis] = 1 / length, n[(axis + 1) % 3] = sign * golden / length;
      const Vec3 drawn = 0.25 * Vec3{0.4 * n.x, -0.2 * n.y, -0.2 * n.z};
      packing.contacts.add(axis, 255, n, 1 + 0.4 * n.x * n.x - 0.2 * (n.y * n.y + n.z * n.z), cross(n, drawn), 1e-3,
                           1e-3);
    }
  const Numbers numbers = measure_spheres(packing);
  EXPECT_NEAR(value(numbers, "/fabric/a_c"), 0, 1e-9);
  EXPECT_NEAR(value(numbers, "/fabric/a_n"), 0.6, 1e-9);
  EXPECT_NEAR(value(numbers, "/fabric/a_t"), 0.15, 1e-9);
  EXPECT_NEAR(value(numbers, "/stress_details/deviator_Pa") / value(numbers, "/stress_details/pressure_Pa"),
              0.4 * (0.6 + 1.5 * 0.15), 1e-9);
}

/// A chain between two walls carries, and what hangs at one contact does not, nor what hangs on that.
TEST(Spheres, RattlersAreTakenAwayAgainAndAgain) {
  PackingIn<3> packing;
  packing.materials = {{"glass", 2500, 1e5}};
  for (int s = 0; s < 6; ++s) packing.domain.wall[s] = {true, s % 2 == 0 ? 0.0 : 6e-3};
  packing.grains.resize(5);
  packing.grains.radius.assign(5, 1e-3);
  packing.grains.position = {
      {1e-3, 1e-3, 1e-3}, {3e-3, 1e-3, 1e-3}, {5e-3, 1e-3, 1e-3}, {3e-3, 3e-3, 1e-3}, {3e-3, 5e-3, 1e-3}};
  packing.contacts.add(0, wall_partner(left), {1, 0, 0}, 1, {}, 1e-3, 0);
  packing.contacts.add(0, 1, {-1, 0, 0}, 1, {}, 1e-3, 1e-3);
  packing.contacts.add(1, 2, {-1, 0, 0}, 1, {}, 1e-3, 1e-3);
  packing.contacts.add(2, wall_partner(right), {-1, 0, 0}, 1, {}, 1e-3, 0);
  packing.contacts.add(1, 3, {0, -1, 0}, 1e-6, {}, 1e-3, 1e-3);
  packing.contacts.add(3, 4, {0, -1, 0}, 1e-6, {}, 1e-3, 1e-3);
  SphereOptions options;
  options.rattler_contacts = 2;
  options.border = 0;
  EXPECT_NEAR(value(measure_spheres(packing, options), "/coordination/rattlers"), 0.4, 1e-12);
  const Numbers numbers = measure_spheres(packing, options);
  EXPECT_NEAR(value(numbers, "/coordination/without_rattlers"), 4.0 / 3, 1e-12);
  EXPECT_EQ(numbers["wall_contacts"].get<int>(), 2);
}

/// Each contact has two ends and presses with 3 N, so that every way to take the sample apart adds up to all of it.
TEST(Spheres, PartsByMaterialAddUpToTheWhole) {
  PackingIn<3> packing = crystal(3);
  packing.materials = {{"glass", 2500, 1e5}, {"steel", 7800, 1e5}};
  for (std::size_t g = 0; g < packing.grains.size(); g += 3) packing.grains.material[g] = 1;
  ContactsIn<3>& contacts = packing.contacts;
  std::size_t unlike = 0;
  for (std::size_t c = 0; c < contacts.size(); ++c)
    unlike += packing.grains.material[contacts.i[c]] != packing.grains.material[contacts.j[c]];
  contacts.fn[0] = -1;
  const Numbers numbers = measure_spheres(packing);
  double parts = 0, shares = 0, in_sets = 0;
  for (const char* pair : {"glass-glass", "glass-steel", "steel-steel"}) {
    parts += value(numbers, (std::string("/coordination/parts_of_z/") + pair).c_str());
    shares += value(numbers, (std::string("/coordination/share_of_contacts/") + pair).c_str());
  }
  for (const char* pair : {"glass-glass", "glass-steel", "steel-steel"})
    in_sets += value(numbers, (std::string("/fabric/sets/") + pair + "/contacts").c_str());
  EXPECT_EQ(in_sets, value(numbers, "/fabric/contacts"));
  EXPECT_NEAR(parts, 12, 1e-12);
  EXPECT_NEAR(shares, 1, 1e-12);
  const auto all = static_cast<double>(contacts.size());
  EXPECT_NEAR(value(numbers, "/coordination/share_of_contacts/glass-steel"), static_cast<double>(unlike) / all, 1e-12);
  EXPECT_NEAR(value(numbers, "/coordination/steel-ANY"), 12, 1e-12);
  EXPECT_NEAR(value(numbers, "/force/tensile_share"), 1 / all, 1e-12);
  EXPECT_NEAR(value(numbers, "/force/tensile/mean_N"), 1, 1e-12);
  EXPECT_NEAR(value(numbers, "/force/by_type/glass-steel/mean_N"), 3, 1e-12);
  EXPECT_EQ(value(numbers, "/quality/negative_forces"), 1);
}

/// The stress of contacts, and of a bond and a pull across a gap beside them, is that of the grains together.
TEST(Spheres, TheStressIsTheSumOverGrains) {
  PackingIn<3> packing = crystal(2);
  packing.grains.radius[0] = 0.8e-3;
  packing.contacts.fn[3] = 20;
  packing.contacts.ft[5] = {1, -2, 0.5};
  packing.bonds.resize(1);
  packing.bonds[0].i = 0, packing.bonds[0].j = 1;
  packing.bonds[0].fn = -7, packing.bonds[0].ft = {0.5, 0.2, -1};
  packing.cohesive = {{2, 9, 1e-4, 5, 0}};
  const Numbers numbers = measure_spheres(packing);
  const double pressure = value(numbers, "/stress_details/pressure_Pa");
  for (int a = 0; a < 3; ++a)
    for (int b = 0; b < 3; ++b)
      EXPECT_NEAR(numbers["stress"]["value"][a][b].get<double>(),
                  (*numbers.at_path("/stress_details/sum_over_grains"))[a][b].get<double>(), 1e-12 * pressure);
}

/// Two spheres between walls, out of balance by 1 and 3 N, with 2 N between them.
TEST(Spheres, TheImbalanceOfTwoIsTheirMean) {
  PackingIn<3> packing;
  packing.materials = {{"glass", 2500, 1e5}};
  for (int s = 0; s < 6; ++s) packing.domain.wall[s] = {true, s % 2 == 0 ? 0 : s == right ? 4e-3 : 2e-3};
  packing.grains.resize(2);
  packing.grains.radius.assign(2, 1e-3);
  packing.grains.position = {{1e-3, 1e-3, 1e-3}, {3e-3, 1e-3, 1e-3}};
  packing.contacts.add(0, 1, {-1, 0, 0}, 2, {}, 1e-3, 1e-3);
  packing.contacts.add(0, wall_partner(left), {1, 0, 0}, 3, {}, 1e-3, 0);
  packing.contacts.add(1, wall_partner(right), {-1, 0, 0}, 5, {}, 1e-3, 0);
  for (const int g : {0, 1}) {
    packing.contacts.add(g, wall_partner(bottom), {0, 1, 0}, 1, {}, 1e-3, 0);
    packing.contacts.add(g, wall_partner(top), {0, -1, 0}, 1, {}, 1e-3, 0);
  }
  SphereOptions options;
  options.border = 0;
  EXPECT_NEAR(value(measure_spheres(packing, options), "/quality/median_imbalance"), 1, 1e-12);
}

TEST(Spheres, AContainerWithoutVolumeIsRefused) {
  PackingIn<3> packing = crystal(1);
  packing.domain.wall[front].position = 0;
  EXPECT_THROW(measure_spheres(packing), InputError);
}

}  // namespace
}  // namespace arenite::texture::spheres_test

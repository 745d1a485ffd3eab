#include "thermal/inference/pixel_forces.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/error.hpp"
#include "support/pressed_crystal.hpp"
#include "support/thermoelastic_picture.hpp"

namespace arenite::inference {
namespace {

using test::factors, test::relative_error;

/// A crystal's picture, and its grains as found: a tenth of a pixel off.
struct CrystalFilm {
  Packing truth = test::pressed_crystal(9, 8, 6e-3, 3), found = test::without_forces(truth);
  test::ThermoelasticDrawing drawing;
  ThermoelasticPicture picture = test::draw_thermoelastic(truth, factors(truth), drawing);

  CrystalFilm() {
    RandomStream random(9, Purpose::test);
    for (Vec2& centre : found.grains.position) centre += 0.1 * drawing.pixel * Vec2{random.normal(), random.normal()};
  }
  double load() const {
    double sum = 0;
    for (std::size_t c = 0; c < truth.contacts.size(); ++c)
      if (truth.contacts.is_wall(c) && truth.contacts.wall_side(c) == bottom) sum += truth.contacts.fn[c];
    return sum;
  }
  /// A grain that touches no wall.
  std::size_t inner_grain() const {
    std::vector<std::uint8_t> at_wall(truth.grains.size(), 0);
    for (std::size_t c = 0; c < truth.contacts.size(); ++c)
      if (truth.contacts.is_wall(c)) at_wall[static_cast<std::size_t>(truth.contacts.i[c])] = 1;
    return static_cast<std::size_t>(std::ranges::find(at_wall, 0) - at_wall.begin());
  }
  /// What its pixels show, times this.
  void paint(std::size_t grain, float times) {
    const auto w = static_cast<std::size_t>(picture.width);
    for (std::size_t k = 0; k < picture.value.size(); ++k) {
      const Vec2 at = picture.first + picture.pixel * Vec2{static_cast<double>(k % w), -static_cast<double>(k / w)};
      if (norm(at - truth.grains.position[grain]) < truth.grains.radius[grain]) picture.value[k] *= times;
    }
  }
  /// Relative error of the normal forces on a grain.
  double error_at(std::size_t grain, const InferredForces& f) const {
    std::vector<double> of, true_ones;
    for (std::size_t c = 0; c < truth.contacts.size(); ++c)
      if (truth.contacts.i[c] == static_cast<int>(grain) || truth.contacts.j[c] == static_cast<int>(grain))
        of.push_back(f.contacts.fn[c]), true_ones.push_back(truth.contacts.fn[c]);
    return relative_error(of, true_ones);
  }
};

/// What is out of balance (here by centres that are off) would be less if all forces were smaller and all factors
/// larger, and a load that is known badly would allow it: by some 3 % at an error of 3 %. A load that is told right
/// shifts nothing, however badly it is known; the weak prior of elastic energy does by 0.2 %.
TEST(PixelForces, ALoadThatIsKnownBadlyLeavesForcesAsLarge) {
  const CrystalFilm film;
  ForceOptions options;
  options.fit_factors = true;
  options.own_factors = true;
  const auto scales = [&](double error) {
    const double load = film.load();
    return infer_from_pixels({film.found, factors(film.found), {{bottom, load, error * load}}}, film.picture, options)
        .fit.factor_scale;
  };
  const auto sure = scales(1e-3), unsure = scales(0.03);
  for (std::size_t m = 0; m < sure.size(); ++m) EXPECT_NEAR(unsure[m] / sure[m], 1, 0.005);
}

/// A grain that shows nothing (here two fifths of what it warms, half a pixel from where it is) spoils the forces on it
/// where it is believed; left out, these follow from its neighbours.
TEST(PixelForces, AGrainThatIsNotSeenHasTheForcesOfItsNeighbours) {
  CrystalFilm film;
  const std::size_t grain = film.inner_grain();
  film.paint(grain, 0.4f);
  film.found.grains.position[grain].x += 0.5 * film.picture.pixel;
  ForceProblem problem{film.found, factors(film.found), {}};
  const double believed = film.error_at(grain, infer_from_pixels(problem, film.picture, {}));
  problem.unseen.assign(film.found.grains.size(), 0.0);
  problem.unseen[grain] = 0.5 * film.picture.pixel;
  const InferredForces f = infer_from_pixels(problem, film.picture, {});
  EXPECT_GT(believed, 0.1);
  EXPECT_LT(film.error_at(grain, f), 0.05);
  EXPECT_LT(relative_error(f.contacts.fn, film.truth.contacts.fn), 0.03);  // the target of a film whose grains are seen
  // The picture of the forces says nothing of it.
  const auto shown = [&](std::size_t g) {
    const Vec2 away = film.found.grains.position[g] - film.picture.first;
    return f.fit.picture[static_cast<std::size_t>(std::lround(-away.y / film.picture.pixel)) *
                             static_cast<std::size_t>(film.picture.width) +
                         static_cast<std::size_t>(std::lround(away.x / film.picture.pixel))];
  };
  EXPECT_FALSE(std::isfinite(shown(grain)));
  EXPECT_TRUE(std::isfinite(shown(grain + 1)));
}

/// Where a grain that is not seen was thought to be is no error of a list.
TEST(PixelForces, AGrainThatIsNotSeenMayOverlapOthers) {
  CrystalFilm film;
  const std::size_t grain = film.inner_grain();
  film.found.grains.position[grain].x += 0.5 * film.found.grains.radius[grain];
  ForceProblem problem{film.found, factors(film.found), {}};
  EXPECT_THROW(infer_from_pixels(problem, film.picture, {}), InputError);
  problem.unseen.assign(film.found.grains.size(), 0.0);
  problem.unseen[grain] = 0.25 * film.found.grains.radius[grain];
  EXPECT_LT(relative_error(infer_from_pixels(problem, film.picture, {}).contacts.fn, film.truth.contacts.fn), 0.2);
}

}  // namespace
}  // namespace arenite::inference

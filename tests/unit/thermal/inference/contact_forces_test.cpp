#include "thermal/inference/contact_forces.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "core/error.hpp"
#include "support/pressed_crystal.hpp"
#include "support/thermoelastic_picture.hpp"
#include "thermal/inference/pixel_forces.hpp"

namespace arenite::inference {
namespace {

using test::ThermoelasticDrawing, test::factors, test::pressed_crystal, test::relative_error, test::without_forces;

constexpr double radius = 8.2e-3;

/// Forces of pixels that lie wholly inside grains, where sigma_kk is harmonic and lens and pixel are not seen.
ForceOptions exact() {
  ForceOptions o;
  o.rim_margin = 2.7, o.contact_margin = 0, o.position_error = 0, o.balance_error = 1e-6, o.model_error = 1e-6,
  o.fit_model_error = false;
  o.prior = 1e5, o.iterations = 1;
  return o;
}

/// The closed form at every pixel's centre; `pixels` along a radius.
ThermoelasticPicture sampled(const Packing& p, double pixels = 8) {
  ThermoelasticDrawing d;
  d.pixel = radius / pixels, d.noise = 0, d.stated_error = 1e-4, d.fine = 1, d.blur = 0;
  ThermoelasticPicture picture = test::draw_thermoelastic(p, factors(p), d);
  const auto disks = test::loaded_disks(p, d);
  for (std::size_t g = 0; g < disks.size(); ++g)
    for (std::size_t k = 0; k < picture.value.size(); ++k) {
      const auto w = static_cast<std::size_t>(picture.width);
      const Vec2 x = picture.first + picture.pixel * Vec2{static_cast<double>(k % w), -static_cast<double>(k / w)} -
                     p.grains.position[g];
      if (norm(x) < 0.95 * radius)
        picture.value[k] = static_cast<float>(-factors(p)[static_cast<std::size_t>(p.grains.material[g])] *
                                              elasticity::sigma_kk(disks[g], x));
    }
  return picture;
}

InferredForces inferred(const Packing& truth, const ThermoelasticPicture& picture, const ForceOptions& options) {
  return infer_from_pixels({without_forces(truth), factors(truth), {}}, picture, options);
}

RC_GTEST_PROP(ContactForces, AreExactWithoutNoise, ()) {
  const Packing truth = pressed_crystal(4, 3, radius, *rc::gen::inRange<std::uint64_t>(1, 1000));
  const InferredForces f = inferred(truth, sampled(truth), exact());
  RC_ASSERT(relative_error(f.contacts.fn, truth.contacts.fn) < 1e-4);  // the picture's numbers have 24 bits
  RC_ASSERT(relative_error(f.contacts.ft, truth.contacts.ft) < 5e-4);
}

/// A mirrored sample has mirrored forces; turned by a right angle it has the same.
RC_GTEST_PROP(ContactForces, MirrorAndTurnWithTheSample, ()) {
  const Packing truth = pressed_crystal(3, 3, radius, *rc::gen::inRange<std::uint64_t>(1, 1000));
  const ThermoelasticPicture picture = sampled(truth, 4);
  ForceOptions options = exact();
  options.rim_margin = 0.7;  // pixels that lens and rim cut, too
  const InferredForces straight = inferred(truth, picture, options);
  Packing mirrored = truth, turned = truth;
  ThermoelasticPicture left_right = picture, quarter = picture;
  left_right.first.x = -picture.first.x - (picture.width - 1) * picture.pixel;
  quarter.width = picture.height, quarter.height = picture.width;
  // (x, y) goes to (-y, x): the right-most column becomes the top row.
  quarter.first = {-picture.first.y, picture.first.x + (picture.width - 1) * picture.pixel};
  for (int r = 0; r < picture.height; ++r)
    for (int c = 0; c < picture.width; ++c) {
      const float value = picture.value[static_cast<std::size_t>(r * picture.width + c)];
      left_right.value[static_cast<std::size_t>(r * picture.width + picture.width - 1 - c)] = value;
      quarter.value[static_cast<std::size_t>((picture.width - 1 - c) * quarter.width + r)] = value;
    }
  const int to_left_right[4] = {right, left, bottom, top}, to_quarter[4] = {bottom, top, right, left};
  for (std::size_t g = 0; g < truth.grains.size(); ++g) {
    mirrored.grains.position[g].x *= -1;
    turned.grains.position[g].x = -truth.grains.position[g].y, turned.grains.position[g].y = truth.grains.position[g].x;
  }
  for (std::size_t c = 0; c < truth.contacts.size(); ++c)
    if (truth.contacts.is_wall(c)) {
      mirrored.contacts.j[c] = wall_partner(to_left_right[truth.contacts.wall_side(c)]);
      turned.contacts.j[c] = wall_partner(to_quarter[truth.contacts.wall_side(c)]);
    }
  for (Packing* p : {&mirrored, &turned}) p->domain.wall[left].position = p->domain.wall[bottom].position = -1;
  const InferredForces m = inferred(mirrored, left_right, options), t = inferred(turned, quarter, options);
  std::vector<double> opposite = straight.contacts.ft;
  for (double& f : opposite) f = -f;
  RC_ASSERT(relative_error(m.contacts.fn, straight.contacts.fn) < 1e-6);
  RC_ASSERT(relative_error(m.contacts.ft, opposite) < 1e-6);
  RC_ASSERT(relative_error(t.contacts.fn, straight.contacts.fn) < 1e-6);
  RC_ASSERT(relative_error(t.contacts.ft, straight.contacts.ft) < 1e-6);
}

RC_GTEST_PROP(ContactForces, AreLinearInThePicture, ()) {
  const std::uint64_t seed = *rc::gen::inRange<std::uint64_t>(1, 1000);
  const Packing truth = pressed_crystal(3, 3, radius, seed);
  RandomStream random(seed, Purpose::test, 8);
  ThermoelasticPicture a = sampled(truth, 4), b = a, sum = a;
  for (std::size_t k = 0; k < a.value.size(); ++k)
    b.value[k] = static_cast<float>(0.01 * random.normal()), sum.value[k] = 3 * a.value[k] - b.value[k];
  ForceOptions options = exact();
  options.model_error = 0, options.rim_margin = 1;  // errors that grow with the signal would weigh pixels anew
  const InferredForces fa = inferred(truth, a, options), fb = inferred(truth, b, options),
                       fs = inferred(truth, sum, options);
  std::vector<double> expected;
  for (std::size_t c = 0; c < truth.contacts.size(); ++c) expected.push_back(3 * fa.contacts.fn[c] - fb.contacts.fn[c]);
  RC_ASSERT(relative_error(fs.contacts.fn, expected) < 2e-3);
}

/// The thesis's pixel, lens and noise; a picture drawn in another way; centres off by a tenth of a pixel.
struct SeenForces {
  Packing truth = pressed_crystal(9, 8, 6e-3, 3), found = without_forces(truth);
  ThermoelasticDrawing drawing;
  ThermoelasticPicture picture;

  explicit SeenForces(elasticity::Traction traction = elasticity::Traction::point, double off = 0.1) {
    drawing.traction = traction, drawing.half_angle = 0.06;
    picture = test::draw_thermoelastic(truth, factors(truth), drawing);
    RandomStream random(9, Purpose::test);
    for (std::size_t g = 0; g < found.grains.size(); ++g) {
      found.grains.position[g].x += off * drawing.pixel * random.normal();
      found.grains.position[g].y += off * drawing.pixel * random.normal();
    }
  }
  InferredForces infer(const ForceOptions& options = {}) const {
    return infer_from_pixels({found, factors(found), {}}, picture, options);
  }
};

TEST(ContactForces, MeetTheirTargetsOnAPicture) {
  for (const auto traction :
       {elasticity::Traction::point, elasticity::Traction::uniform, elasticity::Traction::elliptic}) {
    const SeenForces film(traction);
    const InferredForces f = film.infer();
    EXPECT_LT(relative_error(f.contacts.fn, film.truth.contacts.fn), 0.03);
    EXPECT_LT(relative_error(f.contacts.ft, film.truth.contacts.ft), 0.15);
    EXPECT_LT(f.residual, 1.5);
  }
}

TEST(ContactForces, RefinedCentresPay) {
  const SeenForces film;
  ForceOptions fixed;
  fixed.position_error = 0;
  const double with = relative_error(film.infer().contacts.ft, film.truth.contacts.ft);
  const double without = relative_error(film.infer(fixed).contacts.ft, film.truth.contacts.ft);
  EXPECT_LT(with, 0.7 * without);
}

TEST(ContactForces, StandardErrorsAreHonest) {
  const SeenForces film;
  ForceOptions options;
  options.balance_error = 1e-3;  // these forces are in balance
  const InferredForces f = film.infer(options);
  double n = 0, t = 0;
  for (std::size_t c = 0; c < f.contacts.size(); ++c) {
    n += std::pow((f.contacts.fn[c] - film.truth.contacts.fn[c]) / f.fn_error[c], 2) /
         static_cast<double>(f.contacts.size());
    t += std::pow((f.contacts.ft[c] - film.truth.contacts.ft[c]) / f.ft_error[c], 2) /
         static_cast<double>(f.contacts.size());
  }
  EXPECT_GT(n, 0.3);
  EXPECT_LT(n, 2.5);
  EXPECT_GT(t, 0.3);
  EXPECT_LT(t, 2.5);
}

/// A picture whose pixels are all shifted by the noise that they share: by an unknown of the fit, forces are as sure as
/// without, and by wider errors of each pixel they were not.
TEST(ContactForces, AShiftOfAllPixelsIsOneUnknown) {
  constexpr double common = 1.5e-3;
  constexpr int films = 12;
  double one = 0, two = 0, shifts = 0, off = 0, told = 0, told_wider = 0;
  for (int k = 1; k <= films; ++k) {
    SeenForces film;
    RandomStream random(static_cast<std::uint64_t>(k), Purpose::test, 21);
    film.drawing.seed = static_cast<std::uint64_t>(k);
    film.picture = test::draw_thermoelastic(film.truth, factors(film.truth), film.drawing);
    const double shift = common * random.normal();
    for (float& v : film.picture.value) v += static_cast<float>(shift);
    SeenForces wider = film;
    for (float& e : wider.picture.error) e = static_cast<float>(std::hypot(static_cast<double>(e), common));
    film.picture.common_error = common;
    ForceOptions options;
    options.balance_error = 1e-3;
    const InferredForces f = film.infer(options), before = wider.infer(options);
    const auto count = static_cast<double>(f.contacts.size());
    for (std::size_t c = 0; c < f.contacts.size(); ++c) {
      const double error = f.contacts.fn[c] - film.truth.contacts.fn[c], over = std::abs(error) / f.fn_error[c];
      one += (over < 1) / count / films, two += (over < 2) / count / films;
      off += error * error / count / films, told += f.fn_error[c] * f.fn_error[c] / count / films;
      told_wider += before.fn_error[c] * before.fn_error[c] / count / films;
    }
    shifts += std::pow((f.fit.shift - shift) / f.fit.shift_error, 2) / films;
    EXPECT_LT(f.fit.shift_error, 0.2 * common);
  }
  EXPECT_NEAR(one, 0.68, 0.1);
  EXPECT_NEAR(two, 0.94, 0.05);
  EXPECT_NEAR(std::sqrt(told / off), 1, 0.25);
  EXPECT_GT(std::sqrt(told_wider / off), 1.5);
  EXPECT_LT(std::sqrt(shifts), 1.8);
}

/// Contacts that are offered but carry nothing come out near zero and are marked; those that carry are not.
TEST(ContactForces, SpuriousContactsAreFound) {
  SeenForces film;
  const std::size_t real = film.found.contacts.size();
  // A real contact becomes one that was only offered: the sample is pressed anew without it.
  std::vector<std::size_t> offered{7, 40, 90, 130};
  Packing pressed = film.truth;
  Contacts kept;
  for (std::size_t c = 0; c < real; ++c)
    if (std::find(offered.begin(), offered.end(), c) == offered.end())
      kept.add(pressed.contacts.i[c], pressed.contacts.j[c], pressed.contacts.normal[c], 0, 0, radius, radius);
  pressed.contacts = kept;
  test::put_balanced_forces(pressed, 500, 3);
  film.picture = test::draw_thermoelastic(pressed, factors(pressed), film.drawing);
  const InferredForces f = film.infer();
  int lost = 0;
  for (std::size_t c = 0, k = 0; c < real; ++c) {
    const bool spurious = std::find(offered.begin(), offered.end(), c) != offered.end();
    if (spurious) {
      EXPECT_FALSE(f.present[c]) << f.contacts.fn[c] << " +- " << f.fn_error[c];
      EXPECT_LT(std::abs(f.contacts.fn[c]), 25);
    } else {
      lost += !f.present[c] && std::abs(pressed.contacts.fn[k]) > 100;
      ++k;
    }
  }
  EXPECT_EQ(lost, 0);
}

TEST(ContactForces, ConeKeepsASingleStateInsideFriction) {
  const SeenForces film;
  ForceOptions options;
  options.inequality = Inequality::cone, options.friction = 0.2;
  const InferredForces f = film.infer(options);
  for (std::size_t c = 0; c < f.contacts.size(); ++c)
    EXPECT_LE(std::abs(f.contacts.ft[c]), 0.2 * f.contacts.fn[c] + 1e-6);
}

TEST(ContactForces, WallLoadsAreKept) {
  const SeenForces film;
  double load = 0;
  for (std::size_t c = 0; c < film.truth.contacts.size(); ++c)
    if (film.truth.contacts.is_wall(c) && film.truth.contacts.wall_side(c) == bottom) load += film.truth.contacts.fn[c];
  const InferredForces f =
      infer_from_pixels({film.found, factors(film.found), {{bottom, 1.01 * load, 1e-3}}}, film.picture, {});
  double found = 0;
  for (std::size_t c = 0; c < f.contacts.size(); ++c)
    if (f.contacts.is_wall(c) && f.contacts.wall_side(c) == bottom) found += f.contacts.fn[c];
  EXPECT_NEAR(found / load, 1.01, 1e-6);
}

void expect_problem(const std::string& words, const Packing& packing, const std::vector<double>& factor,
                    const ThermoelasticPicture& picture, const ForceOptions& options = {}) {
  try {
    infer_from_pixels({packing, factor, {}}, picture, options);
    ADD_FAILURE() << "accepted: " << words;
  } catch (const InputError& e) { EXPECT_NE(std::string(e.what()).find(words), std::string::npos) << e.what(); }
}

TEST(ContactForces, BadInputIsToldInASentence) {
  const SeenForces film;
  expect_problem("material HDPE has no thermoelastic factor", film.found, {0.015e-6}, film.picture);
  Packing overlapping = film.found;
  overlapping.grains.position[1].x = overlapping.grains.position[0].x + 1e-3;
  expect_problem("overlap by", overlapping, factors(film.found), film.picture);
  ThermoelasticPicture blind = film.picture;
  blind.error.assign(blind.error.size(), 0.0f);
  expect_problem("no pixel of the picture sees the contact", film.found, factors(film.found), blind);
  ThermoelasticPicture cut = film.picture;
  cut.value.pop_back();
  expect_problem("a value and an error for each", film.found, factors(film.found), cut);
  Packing twice = film.found;
  twice.contacts.add(twice.contacts.j[0], twice.contacts.i[0], {1, 0}, 0, 0, radius, radius);
  if (twice.contacts.j[0] >= 0) expect_problem("is listed twice", twice, factors(film.found), film.picture);
  ForceOptions options;
  options.balance_error = 0;
  expect_problem("balance_error is 0", film.found, factors(film.found), film.picture, options);
}

}  // namespace
}  // namespace arenite::inference

#include "thermal/thermography/step/step_load.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/random.hpp"
#include "support/correlated_noise.hpp"
#include "support/oscillating_film.hpp"
#include "support/pictures.hpp"

namespace {
using namespace arenite;
using namespace arenite::thermography;

/// Pixel p lies at 300 + p, drifts by 0.3 (1 + p/100) before and -0.2 after, and jumps by 0.05 (p - 20) at `step`.
struct SteppingFilm {
  int width = 8, height = 6;
  std::size_t frames = 600;
  double rate = 100, step = 2.504, noise = 0, curve = 0, ramp = 0;
  std::uint64_t seed = 1;
  std::vector<double> time = {};

  double jump(std::size_t p) const { return 0.05 * (static_cast<double>(p) - 20); }
  double slope(std::size_t p) const { return 0.3 * (1 + static_cast<double>(p) / 100); }
  double at(std::size_t p, double t) const {
    const double since = t - step, share = ramp > 0 ? std::clamp(since / ramp + 0.5, 0.0, 1.0) : since > 0 ? 1.0 : 0.0;
    return 300 + static_cast<double>(p) + (since < 0 ? slope(p) : -0.2) * since + curve * since * since +
           jump(p) * share;
  }
  Film draw() const { return test::draw_film(*this); }
};

TEST(StepLoad, TheJumpIsExactWhereDriftIsOfTheFittedForm) {
  for (const double curve : {0.0, 0.4}) {
    SteppingFilm stepping;
    stepping.curve = curve;
    Film film = stepping.draw();
    StepOptions options;
    options.time = stepping.step;
    options.drift_order = curve > 0 ? 2 : 1;
    const StepMaps maps = step_load(film, options);
    EXPECT_EQ(maps.before, 251U);
    EXPECT_EQ(maps.after, 349U);
    for (std::size_t p = 0; p < maps.size(); ++p) {
      EXPECT_NEAR(maps.jump[p], stepping.jump(p), 2e-5);
      EXPECT_NEAR(maps.level[p], 300 + static_cast<double>(p), 5e-5);
      EXPECT_NEAR(maps.drift_before[p], stepping.slope(p), 2e-4);
      EXPECT_NEAR(maps.drift_after[p], -0.2, 2e-4);
    }
  }
}

TEST(StepLoad, StandardErrorsAreTrue) {
  SteppingFilm stepping;
  stepping.width = 60;
  stepping.height = 50;
  stepping.frames = 120;
  stepping.step = 0.4;
  stepping.noise = 0.02;
  Film film = stepping.draw();
  StepOptions options;
  options.time = 0.4;
  const StepMaps maps = step_load(film, options);
  double square = 0;
  for (std::size_t p = 0; p < maps.size(); ++p)
    square += std::pow(
        (static_cast<double>(maps.jump[p]) - stepping.jump(p)) / static_cast<double>(maps.standard_error[p]), 2);
  EXPECT_NEAR(square / static_cast<double>(maps.size()), 1, 0.1);
  // A line through n points has this variance one point beyond its end.
  const auto beyond = [](double n) { return (4 * n + 2) / (n * (n - 1)); };
  EXPECT_NEAR(maps.standard_error[7] / maps.residual[7], std::sqrt(beyond(40) + beyond(79)), 1e-5);
  EXPECT_NEAR(maps.residual[7], 0.02, 0.005);
}

/// 24 x 20 pixels, 50 frames a second: jumps of 0.25 to 0.7 at 10 s that relax within `decay` (0: not at all), and a
/// camera that warms up.
struct RelaxingFilm {
  int width = 24, height = 20;
  std::size_t frames = 1000;
  double rate = 50, noise = 0, decay = 0, warm_up = 0;
  std::uint64_t seed = 1;
  std::vector<double> time = {};

  double jump(std::size_t p) const { return 0.25 + 0.05 * static_cast<double>(p % 10); }
  double at(std::size_t p, double t) const {
    const double since = t - 10;
    return 300 + static_cast<double>(p % 13) + 0.02 * t + warm_up * std::exp(-t / 3) +
           (since < 0 ? 0 : jump(p) * (decay > 0 ? std::exp(-since / decay) : 1));
  }
};

/// Mean relative error of the jumps, and the root mean square of their errors over that of the standard errors.
std::pair<double, double> errors_of(RelaxingFilm of, test::CorrelatedNoise noise, bool given) {
  double bias = 0, square = 0, standard = 0;
  constexpr int films = 4;
  for (noise.seed = 1; noise.seed <= films; ++noise.seed) {
    Film film = test::draw_film(of);
    noise.add_to(film);
    StepOptions options;
    if (given) options.time = 10.0;
    const StepMaps maps = step_load(film, options);
    EXPECT_NEAR(maps.time, 10, 0.03);
    for (std::size_t p = 0; p < maps.size(); ++p) {
      const double off = static_cast<double>(maps.jump[p]) - of.jump(p);
      bias += off / of.jump(p) / static_cast<double>(maps.size()) / films;
      square += off * off;
      standard += std::pow(static_cast<double>(maps.standard_error[p]), 2);
    }
  }
  return {bias, std::sqrt(square / standard)};
}

TEST(StepLoad, JumpsThatRelaxAreNotCalledSmaller) {
  for (const double correlation : {0.0, 0.5})
    for (const double decay : {0.0, 1.0, 2.0, 5.0, 10.0})
      for (const double noise : {0.005, 0.05}) {
        RelaxingFilm film;
        film.decay = decay;
        const auto [bias, error] = errors_of(film, {noise, 0, correlation}, noise < 0.01);
        EXPECT_NEAR(bias, 0, 0.02) << decay << " " << correlation << " " << noise;
        EXPECT_GT(error, 0.7) << decay << " " << correlation << " " << noise;
        EXPECT_LT(error, 1.15) << decay << " " << correlation << " " << noise;
      }
}

TEST(StepLoad, ACameraThatWarmsUpDoesNotChangeTheJump) {
  RelaxingFilm film;
  film.warm_up = 0.5;
  film.decay = 2;
  const auto [bias, error] = errors_of(film, {0.02, 0, 0.3}, true);
  EXPECT_NEAR(bias, 0, 0.02);
  EXPECT_LT(error, 1.15);
}

TEST(StepLoad, CorrelatedNoiseIsNoStep) {
  int found = 0;
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    RelaxingFilm still;
    still.width = still.height = 12, still.frames = 300;
    Film film = test::draw_film(still);
    for (std::size_t p = 0; p < film.value.size(); ++p) film.value[p] = 300;
    test::CorrelatedNoise{0.02, seed % 2 ? 0.02 : 0, 0.6, seed}.add_to(film);
    if (test::complaint([&] { step_load(film, {}); }).empty()) ++found;
  }
  EXPECT_LE(found, 2);
}

TEST(StepLoad, TheStepIsFoundOnTheFilm) {
  SteppingFilm stepping;
  stepping.noise = 0.5;  // as large as the jumps
  Film film = stepping.draw();
  const StepMaps maps = step_load(film, {});
  EXPECT_NEAR(maps.time, 2.505, 0.011);
  Film levels = film;
  levels.about.floating = false;
  for (const float v : levels.value) levels.level.push_back(static_cast<std::uint16_t>(std::lround(10 * v)));
  levels.value.clear();
  EXPECT_NEAR(step_load(levels, {}).time, 2.505, 0.011);
}

TEST(StepLoad, FramesWithinTheRiseAreLeftOutAndThoseBeyondTheWindow) {
  SteppingFilm stepping;
  stepping.ramp = 0.2;
  Film film = stepping.draw();
  StepOptions options;
  options.time = stepping.step;
  options.rise = 0.21;
  options.window = 1;
  const StepMaps with = step_load(film, options);
  EXPECT_EQ(with.before, 89U);  // 1.51 to 2.39 s
  for (std::size_t p = 0; p < with.size(); ++p) EXPECT_NEAR(with.jump[p], stepping.jump(p), 5e-5);
  options.rise = 0;
  EXPECT_NEAR(step_load(film, options).jump[47], stepping.jump(47), 0.03 * stepping.jump(47)) << "found on the film";
}

TEST(StepLoad, UnevenTimesAreUsedAndThreadsChangeNothing) {
  SteppingFilm stepping;
  for (std::size_t n = 0; n < 300; ++n)
    if (n % 7 != 3 && (n < 90 || n > 120)) stepping.time.push_back(static_cast<double>(n) / 60);
  stepping.noise = 0.01;
  Film film = stepping.draw();
  StepOptions options;
  options.time = stepping.step;
  const StepMaps one = step_load(film, options);
  options.threads = 3;
  EXPECT_EQ(one.jump, step_load(film, options).jump);
  for (std::size_t p = 0; p < one.size(); ++p)
    EXPECT_NEAR(one.jump[p], stepping.jump(p), 5 * static_cast<double>(one.standard_error[p]));
}

TEST(StepLoad, RefusesWhatIsNoStep) {
  SteppingFilm stepping;
  stepping.noise = 0.1;
  Film film = stepping.draw();
  StepOptions options;
  for (const double time : {-1.0, 0.0, 6.0}) {
    options.time = time;
    EXPECT_NE(test::complaint([&] { step_load(film, options); }).find("not within the film"), std::string::npos)
        << time;
  }
  options.time = 0.02;
  EXPECT_NE(test::complaint([&] { step_load(film, options); }).find("2 frames before the step"), std::string::npos);
  options.time.reset();
  options.drift_order = 5;
  EXPECT_NE(test::complaint([&] { step_load(film, options); }).find("0 to 4"), std::string::npos);
  Film quiet = stepping.draw();
  RandomStream random(3, Purpose::test);
  for (float& v : quiet.value) v = static_cast<float>(0.1 * random.normal());
  EXPECT_NE(test::complaint([&] { step_load(quiet, {}); }).find("no step of the load"), std::string::npos);
  std::fill(quiet.value.begin(), quiet.value.end(), 1.f);
  EXPECT_NE(test::complaint([&] { step_load(quiet, {}); }).find("constant"), std::string::npos);
  options = {};
  options.progress = [](double) { return false; };
  EXPECT_EQ(step_load(film, options).size(), 0U);
}

}  // namespace

#include "thermal/thermography/grains/grain_motion.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "../support/moving_disks_film.hpp"
#include "thermal/thermography/grains/follow_grains.hpp"
#include "thermal/thermography/grains/grain_means.hpp"
#include "thermal/thermography/grains/grain_places.hpp"

namespace arenite::thermography {
namespace {

struct Seen {
  PictureGrains grains;
  LockinMaps still, moving;
  GrainMotion motion;
  double worst_motion = 0, rms_motion = 0;
};

Seen look(const test::MovingDisks& disks) {
  Seen seen;
  Film film = disks.draw();
  seen.grains = disks.grains();
  LockinOptions o;
  o.frequency = disks.frequency;
  seen.still = lock_in(film, o);
  const PhasePictures pictures = phase_pictures(film, seen.still, o);
  seen.motion = grain_motion(pictures, seen.grains, 1);
  seen.moving = follow_grains(pictures, seen.still, seen.grains, seen.motion, seen.grains, 1);
  for (std::size_t i = 0; i < seen.grains.size(); ++i) {
    const double off =
        std::hypot(norm(seen.motion.cosine[i] + disks.amplitude(seen.grains, i)), norm(seen.motion.sine[i]));
    seen.worst_motion = std::max(seen.worst_motion, off);
    seen.rms_motion += off * off / static_cast<double>(seen.grains.size());
  }
  seen.rms_motion = std::sqrt(seen.rms_motion);
  return seen;
}

/// Root mean square error of the grains' peak-to-peak temperatures, K.
double error_of_means(const test::MovingDisks& disks, const Seen& seen, const LockinMaps& maps) {
  GrainMeanOptions o;
  o.factor = {1e-8, 1e-8};
  const PeakToPeak found = grain_means(maps, seen.grains, o);
  double sum = 0;
  for (std::size_t i = 0; i < found.size(); ++i)
    sum += std::pow(found.temperature[i] - disks.warming(seen.grains, i, seen.grains.centre[i].x), 2);
  return std::sqrt(sum / static_cast<double>(found.size()));
}

TEST(GrainMotion, IsFoundAndTakenOut) {
  test::MovingDisks disks;  // up to 3 pixels between the two loads
  const Seen seen = look(disks);
  ASSERT_GT(seen.grains.size(), 40u);
  EXPECT_LT(seen.rms_motion, 0.025);
  EXPECT_LT(seen.worst_motion, 0.08);
  const double before = error_of_means(disks, seen, seen.still), after = error_of_means(disks, seen, seen.moving);
  EXPECT_LT(after, 0.9e-3);  // noise alone: 20 mK sqrt(8/400) over some 30 pixels: 0.5 mK
  EXPECT_GT(before, 3 * after);
}

TEST(GrainMotion, AlongAContainersEdgesIsThatOfTheGrains) {
  test::MovingDisks disks;
  disks.edge = 3;     // twice the contrast of the grains: the edge of a container before a cold table
  disks.apart = 1.5;  // grains move along and away from walls that stand still
  const Seen seen = look(disks);
  EXPECT_LT(seen.rms_motion, 0.04);
  EXPECT_LT(seen.worst_motion, 0.15);
}

/// Root mean square of the errors made over those told, of all coordinates.
double made_over_told(const test::MovingDisks& disks) {
  const Seen seen = look(disks);
  double sum = 0;
  for (std::size_t i = 0; i < seen.grains.size(); ++i) {
    const Vec2 off = seen.motion.cosine[i] + disks.amplitude(seen.grains, i);
    sum += dot(off, off) / (0.5 * std::pow(error_of_way(seen.motion, i), 2));
  }
  return std::sqrt(sum / static_cast<double>(seen.grains.size()));
}

TEST(GrainMotion, ErrorsToldAreThoseMade) {
  test::MovingDisks still;
  still.noise = 0.1, still.travel = still.apart = 0, still.thermal = 0;
  EXPECT_NEAR(made_over_told(still), 1, 0.2);
  test::MovingDisks alone;  // what rims lose between pixels is as large as the noise makes it
  alone.gap = 3;
  EXPECT_NEAR(made_over_told(alone), 1, 0.2);
  test::MovingDisks apart;  // neighbours go their own ways, by more than the blur of their rims
  apart.travel = 6, apart.apart = 2, apart.gap = 2.5;
  EXPECT_NEAR(made_over_told(apart), 1, 0.2);
  test::MovingDisks crowd;  // residuals of its sectors alone tell less than half of it
  EXPECT_LT(made_over_told(crowd), 1.7);
}

TEST(GrainMotion, DriftIsTakenOutOfTheGrainsThatMove) {
  test::MovingDisks disks;
  disks.frames = 420;  // half a cycle more than eight: drift that is left is in some phases more than in others
  const Seen none = look(disks);
  const double without = error_of_means(disks, none, none.moving);
  disks.curve = 3;
  const Seen curved = look(disks);
  EXPECT_LT(error_of_means(disks, curved, curved.moving), 1.1 * without);
  disks.curve = 0, disks.warm_up = 0.5;
  const Seen warming = look(disks);
  EXPECT_LT(error_of_means(disks, warming, warming.moving), 1.15 * without);
  EXPECT_LT(error_of_means(disks, warming, warming.still), 1.05 * error_of_means(disks, none, none.still));
}

/// Root mean square error of the amplitude in pixels from 1 to 2 pixels below rims, K.
double error_below_rims(const test::MovingDisks& disks, const PictureGrains& grains, const LockinMaps& maps) {
  double sum = 0, n = 0;
  for (std::size_t i = 0; i < grains.size(); ++i)
    for (int row = 0; row < disks.height; ++row)
      for (int column = 0; column < disks.width; ++column) {
        const double below = disks.radius - std::hypot(column - grains.centre[i].x, row - grains.centre[i].y);
        if (below < 1 || below > 2) continue;
        const std::size_t p = static_cast<std::size_t>(row * disks.width + column);
        sum += std::pow(static_cast<double>(maps.in_phase[p]) - disks.warming(grains, i, column), 2);
        n += 1;
      }
  return std::sqrt(sum / n);
}

TEST(GrainMotion, LeavesLittleBelowRims) {
  test::MovingDisks disks;
  disks.travel = 6, disks.gap = 0.6;  // neighbours move by different amounts and shall not meet
  Film film = disks.draw();
  const PictureGrains grains = disks.grains();
  LockinOptions o;
  o.frequency = disks.frequency;
  o.convention = AmplitudeConvention::peak_to_peak;
  const LockinMaps maps = lock_in(film, o);
  GrainMotion motion;
  for (std::size_t i = 0; i < grains.size(); ++i) motion.cosine.push_back(-disks.amplitude(grains, i));
  motion.sine.resize(grains.size());
  motion.error.resize(grains.size());
  const LockinMaps followed = follow_grains(phase_pictures(film, maps, o), maps, grains, motion, grains, 1);
  EXPECT_LT(error_below_rims(disks, grains, followed),
            3.4e-3);  // noise alone: 2.8 mK; 10.5 mK if rims are resampled with the rest
}

TEST(GrainMotion, OfGrainsAtRestIsNone) {
  test::MovingDisks disks;
  disks.travel = disks.apart = 0;
  const Seen seen = look(disks);
  EXPECT_LT(seen.rms_motion, 0.012);
  EXPECT_NEAR(seen.moving.in_phase[35 * 90 + 45], seen.still.in_phase[35 * 90 + 45], 4e-3);
}

TEST(GrainMotion, GrainsWithoutContrastHaveNone) {
  test::MovingDisks disks;
  disks.contrast = 0, disks.thermal = 0.01;
  disks.frames = 200;
  const Seen seen = look(disks);
  for (std::size_t i = 0; i < seen.grains.size(); ++i) EXPECT_LT(norm(seen.motion.cosine[i]), 8.5);
  EXPECT_GT(seen.motion.error[5], 0.05);
}

TEST(PhasePictures, HoldAllFramesAtTheirPhases) {
  test::MovingDisks disks;
  disks.frames = 300;
  Film film = disks.draw();
  LockinOptions o;
  o.frequency = 3;
  const PhasePictures pictures = phase_pictures(film, lock_in(film, o), o, 24);
  double frames = 0;
  for (std::size_t k = 0; k < pictures.size(); ++k) {
    frames += pictures.frames[k];
    EXPECT_GT(std::hypot(pictures.phases[k][1], pictures.phases[k][2]), 0.99);
  }
  EXPECT_EQ(frames, 300);
}

}  // namespace
}  // namespace arenite::thermography

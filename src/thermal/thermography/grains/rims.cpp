#include "thermal/thermography/grains/rims.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "core/median.hpp"
#include "model/grain_motion.hpp"
#include "thermal/thermography/phase_pictures.hpp"

namespace arenite::thermography {
namespace {

/// Pixels inside and outside the rim that show where a grain is.
constexpr double rim_reach = 2.5;
/// Width of a rim that lens and pixels blur: the share inside falls off as erfc(distance/blur)/2.
constexpr double blur = 0.8;
/// Closer to another grain than this a pixel is left out; its rim is told apart up to the reach.
constexpr double margin = 0.6, reach_of_others = 2.2;

double share_inside(double out) { return 0.5 * std::erfc(out / blur); }

/// Lines along which the outermost grains end, as along the walls of a container. An edge there may stand out more than
/// any rim, and moves with none of the grains.
struct Borders {
  double left = std::numeric_limits<double>::infinity(), top = left, right = -left, bottom = -left;
  double left_way = 0, top_way = 0, right_way = 0, bottom_way = 0;  ///< amplitudes across, of the grains along them

  Borders(const PictureGrains& g, const GrainMotion& motion) {
    for (std::size_t i = 0; i < g.size(); ++i) {
      left = std::min(left, g.centre[i].x - g.radius[i]), right = std::max(right, g.centre[i].x + g.radius[i]);
      top = std::min(top, g.centre[i].y - g.radius[i]), bottom = std::max(bottom, g.centre[i].y + g.radius[i]);
    }
    std::vector<double> ways[4];
    for (std::size_t i = 0; i < g.size(); ++i) {
      const double r = g.radius[i] + 1;
      const auto [x, y] = amplitude(motion, i);
      if (g.centre[i].x - r < left) ways[0].push_back(x);
      if (g.centre[i].x + r > right) ways[1].push_back(x);
      if (g.centre[i].y - r < top) ways[2].push_back(y);
      if (g.centre[i].y + r > bottom) ways[3].push_back(y);
    }
    left_way = median(ways[0]), right_way = median(ways[1]), top_way = median(ways[2]), bottom_way = median(ways[3]);
  }

  /// Signed, in phase with the larger of both parts.
  static Vec2 amplitude(const GrainMotion& motion, std::size_t i) {
    const auto along = [](double c, double s) {
      return std::copysign(std::hypot(c, s), std::abs(c) > std::abs(s) ? c : s);
    };
    return {along(motion.cosine[i].x, motion.sine[i].x), along(motion.cosine[i].y, motion.sine[i].y)};
  }

  /// Whether a pixel that goes with a grain comes near none of them.
  bool keep_clear_of(Vec2 place, Vec2 way) const {
    constexpr double blurred = 1.2;
    return place.x - left > blurred + std::abs(way.x - left_way) &&
           right - place.x > blurred + std::abs(way.x - right_way) &&
           place.y - top > blurred + std::abs(way.y - top_way) &&
           bottom - place.y > blurred + std::abs(way.y - bottom_way);
  }
};

void add(const PictureGrains& g, std::size_t i, const std::vector<std::size_t>& neighbours, Vec2 place, Rim& own) {
  const Vec2 from_centre = place - g.centre[i];
  const double out = norm(from_centre) - g.radius[i];
  if (std::abs(out) > rim_reach) return;
  std::vector<OtherRim> others;
  for (const std::size_t j : neighbours) {
    const Vec2 from_other = place - g.centre[j];
    const double r = norm(from_other), away = r - g.radius[j];
    if (away < margin) return;
    if (away <= reach_of_others) others.push_back({own.pixels.size(), j, away, from_other / r});
  }
  own.others.insert(own.others.end(), others.begin(), others.end());
  own.pixels.push_back({place, from_centre / g.radius[i], share_inside(out), 1 - std::pow(out / (rim_reach + 0.5), 2)});
}

}  // namespace

SwingingShare::SwingingShare(double out, double amplitude) : mean(0), slope(0) {
  // Nodes of Chebyshev: exact up to the fifteenth harmonic of what erfc makes of a cosine.
  constexpr int nodes = 8;
  const double a = std::max(amplitude, 1e-3);
  for (int k = 0; k < nodes; ++k) {
    const double at = std::cos((k + 0.5) * std::numbers::pi / nodes), share = share_inside(out + a * at);
    mean += share / nodes;
    slope += 2 * share * at / (nodes * a);
  }
}

std::vector<Rim> rims_of(const PictureGrains& g, const GrainMotion& motion, int width, int height) {
  std::vector<Rim> rims(g.size());
  const Borders borders(g, motion);
  for (std::size_t i = 0; i < g.size(); ++i) {
    const double reach = g.radius[i] + rim_reach;
    std::vector<std::size_t> neighbours;
    for (std::size_t j = 0; j < g.size(); ++j)
      if (j != i && norm(g.centre[j] - g.centre[i]) < reach + g.radius[j] + reach_of_others) neighbours.push_back(j);
    const Vec2 way = Borders::amplitude(motion, i);
    each_pixel_near(g.centre[i], reach, width, height, [&](double column, double row, std::size_t) {
      if (borders.keep_clear_of({column, row}, way)) add(g, i, neighbours, {column, row}, rims[i]);
    });
  }
  return rims;
}

}  // namespace arenite::thermography

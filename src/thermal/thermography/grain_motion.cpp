#include "thermal/thermography/grain_motion.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "core/median.hpp"
#include "core/threads.hpp"

namespace arenite::thermography {
namespace {

using statistics::Matrix;

/// Rim of a grain that another grain's rim is seen beside.
struct OtherRim {
  std::size_t pixel = 0, grain = 0;  ///< of the list, and of the grains
  double inside = 0;                 ///< share of the pixel in that grain
  double slope_x = 0, slope_y = 0;   ///< of that share, a pixel
};

struct RimPixel {
  double x, y;            ///< pixels
  double from_x, from_y;  ///< the centre, over the radius
  double inside;          ///< share of the pixel in the grain, over the width of a blurred rim
  double weight;
};

/// Pixels on both sides of a grain's rim that are in no other grain.
struct Rim {
  std::vector<RimPixel> pixels;
  std::vector<OtherRim> others;  ///< blurred rims of neighbours that reach into these pixels
};

/// Width of a rim that lens and pixels blur: the share inside falls off as erfc(distance/blur)/2.
constexpr double blur = 0.8;
/// Closer to another grain than this a pixel is left out; its rim is told apart up to the reach.
constexpr double margin = 0.6, reach_of_others = 2.2;

double share_inside(double out) { return 0.5 * std::erfc(out / blur); }
double slope_of_share(double out) { return -std::exp(-out * out / (blur * blur)) / (blur * std::sqrt(std::numbers::pi)); }

void add(const PictureGrains& g, std::size_t i, const std::vector<std::size_t>& neighbours, double rim, double x, double y, Rim& own) {
  const double dx = x - g.centre[i].x, dy = y - g.centre[i].y, out = std::hypot(dx, dy) - g.radius[i];
  if (std::abs(out) > rim) return;
  std::vector<OtherRim> others;
  for (const std::size_t j : neighbours) {
    const double r = std::hypot(x - g.centre[j].x, y - g.centre[j].y), away = r - g.radius[j];
    if (away < margin) return;
    if (away > reach_of_others) continue;
    const double slope = slope_of_share(away) / r;
    others.push_back({own.pixels.size(), j, share_inside(away), slope * (x - g.centre[j].x), slope * (y - g.centre[j].y)});
  }
  own.others.insert(own.others.end(), others.begin(), others.end());
  own.pixels.push_back({x, y, dx / g.radius[i], dy / g.radius[i], share_inside(out), 1 - std::pow(out / (rim + 0.5), 2)});
}

std::vector<Rim> rims_of(const PictureGrains& g, int width, int height, double rim) {
  std::vector<Rim> rims(g.size());
  for (std::size_t i = 0; i < g.size(); ++i) {
    const double reach = g.radius[i] + rim;
    std::vector<std::size_t> neighbours;
    for (std::size_t j = 0; j < g.size(); ++j)
      if (j != i && std::hypot(g.centre[j].x - g.centre[i].x, g.centre[j].y - g.centre[i].y) < reach + g.radius[j] + reach_of_others) neighbours.push_back(j);
    each_pixel_near(g.centre[i], reach, width, height, [&](int column, int row, std::size_t) { add(g, i, neighbours, rim, column, row, rims[i]); });
  }
  return rims;
}

/// What the rim of one grain says about the motion that is still left of it and of those beside it: normal matrix and
/// right-hand sides (cosine, sine) with the smooth part eliminated; two unknowns a grain.
struct Left {
  std::vector<std::size_t> grains;
  Matrix normal, side;
  double squares = 0, freedom = 0;  ///< of what there is to explain
  double contrast = 0;              ///< of the grain to what is behind it

  /// Of all grains together.
  std::size_t unknown(std::size_t own) const { return 2 * grains[own / 2] + own % 2; }
};

/// Contrast of a grain from its mean picture, where the neighbours' are known.
double contrast_of(const Rim& rim, const std::vector<double>& mean, const std::vector<double>& contrast) {
  std::vector<double> value = mean;
  for (const OtherRim& o : rim.others) value[o.pixel] -= contrast[o.grain] * o.inside;
  double n = 0, x = 0, y = 0, xx = 0, xy = 0;
  for (std::size_t p = 0; p < value.size(); ++p) {
    const double in = rim.pixels[p].inside;
    n += 1, x += in, y += value[p], xx += in * in, xy += in * value[p];
  }
  const double spread = xx - x * x / n;
  return spread > 0 ? (xy - x * y / n) / spread : 0;
}

/// `motion` and `contrast` are those found so far. Seen from the grain, neighbours that move otherwise oscillate.
Left motion_left(const PhasePictures& pictures, const Rim& rim, std::size_t grain, const GrainMotion& motion, const std::vector<double>& contrast) {
  constexpr std::size_t smooth = 6;
  Left left;
  left.grains = {grain};
  for (const OtherRim& o : rim.others)
    if (std::find(left.grains.begin(), left.grains.end(), o.grain) == left.grains.end()) left.grains.push_back(o.grain);
  const std::size_t n = rim.pixels.size(), unknowns = 2 * left.grains.size();
  left.normal = Matrix(unknowns, unknowns);
  left.side = Matrix(unknowns, 2);
  if (n < smooth + unknowns) return left;
  const PixelHarmonics fit(pictures, motion, grain);
  Matrix part(n, smooth), rest(n, unknowns + 2);
  std::vector<double> mean;
  for (std::size_t p = 0; p < n; ++p) {
    const RimPixel& pixel = rim.pixels[p];
    const Followed f = fit.follow(pictures, pixel.x, pixel.y);
    mean.push_back(f.harmonics[0]);
    const double in = pixel.inside, x = pixel.from_x, y = pixel.from_y;
    const double shape[smooth] = {in, in * x, in * y, in * x * x, in * x * y, in * y * y};
    for (std::size_t k = 0; k < smooth; ++k) part(p, k) = shape[k];
    rest(p, 0) = -f.slope_x, rest(p, 1) = -f.slope_y;
    rest(p, unknowns) = f.harmonics[1], rest(p, unknowns + 1) = f.harmonics[2];
  }
  for (const OtherRim& o : rim.others) {
    const std::size_t row = o.pixel, column = 2 * static_cast<std::size_t>(std::find(left.grains.begin(), left.grains.end(), o.grain) - left.grains.begin());
    const double x = contrast[o.grain] * o.slope_x, y = contrast[o.grain] * o.slope_y;
    rest(row, 0) += x, rest(row, 1) += y;
    rest(row, column) -= x, rest(row, column + 1) -= y;
    rest(row, unknowns) += x * (motion.cos_x[o.grain] - motion.cos_x[grain]) + y * (motion.cos_y[o.grain] - motion.cos_y[grain]);
    rest(row, unknowns + 1) += x * (motion.sin_x[o.grain] - motion.sin_x[grain]) + y * (motion.sin_y[o.grain] - motion.sin_y[grain]);
  }
  for (std::size_t p = 0; p < n; ++p) {
    const double w = std::sqrt(rim.pixels[p].weight);
    for (std::size_t k = 0; k < smooth; ++k) part(p, k) *= w;
    for (std::size_t k = 0; k < unknowns + 2; ++k) rest(p, k) *= w;
  }
  left.contrast = contrast_of(rim, mean, contrast);
  const Matrix q = statistics::orthonormal(part).q;
  rest -= q * transposed_times(q, rest);
  const Matrix slopes = rest.part(0, unknowns), signal = rest.part(unknowns, 2);
  left.normal = transposed_times(slopes, slopes);
  left.side = transposed_times(slopes, signal);
  left.squares = squares(signal);
  left.freedom = static_cast<double>(2 * (n - smooth - 2));
  return left;
}

/// All grains' unknowns together: x of grain i at 2 i, y at 2 i + 1.
struct Together {
  std::vector<statistics::Entry> normal;
  Matrix side;
};

Together assemble(const std::vector<Left>& left) {
  const std::size_t size = 2 * left.size();
  Together all{{}, Matrix(size, 2)};
  for (const Left& each : left)
    for (std::size_t a = 0; a < each.side.rows(); ++a) {
      const std::size_t row = each.unknown(a);
      for (std::size_t k = 0; k < 2; ++k) all.side(row, k) += each.side(a, k);
      for (std::size_t b = 0; b < each.side.rows(); ++b) all.normal.push_back({row, each.unknown(b), each.normal(a, b)});
    }
  double trace = 0;
  for (const auto& e : all.normal) trace += e.row == e.column ? e.value : 0;
  for (std::size_t k = 0; k < size; ++k) all.normal.push_back({k, k, 1e-7 * trace / static_cast<double>(size) + 1e-300});
  return all;
}

/// Steps of all grains that are linear in the place.
Matrix affine_step(const PictureGrains& grains, const Together& all) {
  double span = 1;
  for (std::size_t i = 0; i < grains.size(); ++i) span = std::max({span, std::abs(grains.centre[i].x), std::abs(grains.centre[i].y)});
  Matrix shape(all.side.rows(), 6), sums = shape;
  for (std::size_t i = 0; i < grains.size(); ++i)
    for (std::size_t k = 0; k < 2; ++k)
      shape(2 * i + k, 3 * k) = 1, shape(2 * i + k, 3 * k + 1) = grains.centre[i].x / span - 0.5, shape(2 * i + k, 3 * k + 2) = grains.centre[i].y / span - 0.5;
  for (const auto& e : all.normal)
    for (std::size_t k = 0; k < 6; ++k) sums(e.row, k) += e.value * shape(e.column, k);
  Matrix normal = transposed_times(shape, sums);
  double trace = 0;
  for (std::size_t k = 0; k < 6; ++k) trace += normal(k, k);
  for (std::size_t k = 0; k < 6; ++k) normal(k, k) += 1e-9 * trace + 1e-300;
  return shape * solve_symmetric(normal, transposed_times(shape, all.side));
}

/// Adds the steps, none longer than a pixel; returns the longest.
double move(const Matrix& step, double largest, GrainMotion& motion) {
  double longest = 0;
  for (std::size_t i = 0; i < motion.size(); ++i)
    for (std::size_t k = 0; k < 2; ++k) {
      double& x = k == 0 ? motion.cos_x[i] : motion.sin_x[i];
      double& y = k == 0 ? motion.cos_y[i] : motion.sin_y[i];
      const double dx = step(2 * i, k), dy = step(2 * i + 1, k), length = std::hypot(dx, dy);
      const double part = length > 1 ? 1 / length : 1;
      if (!std::isfinite(length) || std::hypot(x + part * dx, y + part * dy) > largest) continue;
      x += part * dx, y += part * dy;
      longest = std::max(longest, part * length);
    }
  return longest;
}

/// From what the fit leaves on the rim, and the grain's own part of the normal matrix.
double error_of(const Left& left, const Matrix& step) {
  const Matrix& own = left.normal;
  const double trace = own(0, 0) + own(1, 1), determinant = own(0, 0) * own(1, 1) - own(0, 1) * own(1, 0);
  if (!(left.freedom > 0) || !(determinant > 1e-12 * trace * trace)) return std::numeric_limits<double>::infinity();
  Matrix local(own.rows(), 2), unexplained = left.side;
  for (std::size_t a = 0; a < local.rows(); ++a)
    for (std::size_t k = 0; k < 2; ++k) local(a, k) = step(left.unknown(a), k);
  (unexplained += left.side) -= own * local;
  const double rest = left.squares - statistics::dot(local.column(0), unexplained.column(0), local.size());
  return std::sqrt(std::max(rest, 0.0) / left.freedom * 0.5 * trace / determinant);
}

}  // namespace

std::vector<std::uint8_t> lost_grains(const GrainMotion& motion) {
  const double usual = median_of_finite(motion.error);
  std::vector<std::uint8_t> lost;
  for (const double error : motion.error) lost.push_back(std::isfinite(error) && error > 6 * usual ? 1 : 0);
  return lost;
}

GrainMotion grain_motion(const PhasePictures& pictures, const PictureGrains& grains, const GrainMotionOptions& options) {
  constexpr int affine_turns = 3;
  const std::size_t n = grains.size();
  GrainMotion motion;
  for (auto* each : {&motion.cos_x, &motion.sin_x, &motion.cos_y, &motion.sin_y}) each->assign(n, 0);
  motion.error.assign(n, std::numeric_limits<double>::infinity());
  if (n == 0) return motion;
  const std::vector<Rim> rims = rims_of(grains, pictures.width, pictures.height, options.rim);
  std::vector<double> contrast(n, 0);
  const ThreadPool pool(options.threads);
  for (int turn = 0; turn < options.iterations; ++turn) {
    std::vector<Left> left(n);
    pool.for_each(n, [&](std::size_t i) { left[i] = motion_left(pictures, rims[i], i, motion, contrast); });
    for (std::size_t i = 0; i < n; ++i) contrast[i] = left[i].contrast;
    const Together all = assemble(left);
    const Matrix step = turn < affine_turns ? affine_step(grains, all) : solve_sparse(all.normal, all.side);
    const double longest = move(step, options.largest, motion);
    if (turn < affine_turns) continue;
    for (std::size_t i = 0; i < n; ++i) motion.error[i] = error_of(left[i], step);
    if (longest < 2e-3) break;
  }
  return motion;
}

}  // namespace arenite::thermography

#include "thermal/thermography/grains/grain_motion.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <set>

#include "core/mapped.hpp"
#include "core/median.hpp"
#include "core/threads.hpp"
#include "model/grain_motion.hpp"
#include "statistics/correlation.hpp"
#include "thermal/thermography/grains/rims.hpp"

namespace arenite::thermography {
namespace {

using statistics::Matrix;

/// Of a neighbour's rim, seen from the grain.
SwingingShare share_of(const OtherRim& o, std::size_t grain, const GrainMotion& motion) {
  return {o.away, std::hypot(dot(o.outwards, motion.cosine[o.grain] - motion.cosine[grain]),
                             dot(o.outwards, motion.sine[o.grain] - motion.sine[grain]))};
}

/// What the rim of one grain says about the motion that is still left of it and of those beside it: normal matrix and
/// right-hand sides (cosine, sine) with the smooth part eliminated; two unknowns a grain.
struct Left {
  std::vector<std::size_t> grains;
  Matrix slopes, signal;            ///< of every pixel
  std::vector<std::size_t> sector;  ///< of the rim, in which every pixel lies
  Matrix normal, side;
  double freedom = 0;   ///< of what there is to explain
  double contrast = 0;  ///< of the grain to what is behind it
  double warming = 0;   ///< root mean square amplitude in pixels that show nothing but the grain

  /// Of all grains together.
  std::size_t unknown(std::size_t own) const { return 2 * grains[own / 2] + own % 2; }
  /// The first of a grain's two unknowns here.
  std::size_t own(std::size_t grain) const {
    return 2 * static_cast<std::size_t>(std::find(grains.begin(), grains.end(), grain) - grains.begin());
  }
};

/// What a model of rims leaves out (paint, neighbours, travel that is not small beside the blur) is alike along a part
/// of a rim: parts of 45 degrees are taken for independent of each other, pixels are not.
constexpr std::size_t sectors = 8;

std::size_t sector_of(Vec2 from_centre) {
  const double turn = std::atan2(from_centre.y, from_centre.x) / (2 * std::numbers::pi) + 0.5;
  return static_cast<std::size_t>(turn * sectors) % sectors;
}

/// Contrast of a grain from its mean picture, where the neighbours' are known.
double contrast_of(const Rim& rim, std::size_t grain, const GrainMotion& motion, const std::vector<double>& mean,
                   const std::vector<double>& contrast) {
  std::vector<double> value = mean;
  for (const OtherRim& o : rim.others) value[o.pixel] -= contrast[o.grain] * share_of(o, grain, motion).mean;
  const auto m = statistics::second_moments(mapped(rim.pixels, &RimPixel::inside), value);
  return m.xx > 0 ? m.xy / m.xx : 0;
}

/// `motion` and `contrast` are those found so far. Seen from the grain, neighbours that move otherwise oscillate.
Left motion_left(const PhasePictures& pictures, const Rim& rim, std::size_t grain, const GrainMotion& motion,
                 const std::vector<double>& contrast) {
  constexpr std::size_t smooth = 6;
  Left left;
  left.grains = {grain};
  for (const OtherRim& o : rim.others)
    if (left.own(o.grain) == 2 * left.grains.size()) left.grains.push_back(o.grain);
  const std::size_t n = rim.pixels.size(), unknowns = 2 * left.grains.size();
  left.normal = Matrix(unknowns, unknowns);
  left.side = Matrix(unknowns, 2);
  if (n < smooth + unknowns) return left;
  const PixelHarmonics fit(pictures, motion, grain);
  Matrix part(n, smooth), rest(n, unknowns + 2);
  std::vector<double> mean;
  double warming = 0, inner = 0;
  const auto weight = [&](std::size_t p) { return std::sqrt(rim.pixels[p].weight); };
  for (std::size_t p = 0; p < n; ++p) {
    const RimPixel& pixel = rim.pixels[p];
    const Followed f = fit.follow(pictures, pixel.place);
    mean.push_back(f.harmonics[0]);
    const double w = weight(p), in = w * pixel.inside;
    const auto [x, y] = pixel.from_centre;
    const double shape[smooth] = {in, in * x, in * y, in * x * x, in * x * y, in * y * y};
    for (std::size_t k = 0; k < smooth; ++k) part(p, k) = shape[k];
    rest(p, 0) = -w * f.slope.x, rest(p, 1) = -w * f.slope.y;
    rest(p, unknowns) = w * f.harmonics[1], rest(p, unknowns + 1) = w * f.harmonics[2];
    if (pixel.inside > 0.98) warming += f.harmonics[1] * f.harmonics[1] + f.harmonics[2] * f.harmonics[2], inner += 1;
  }
  left.warming = inner > 0 ? std::sqrt(warming / inner) : 0;
  for (const OtherRim& o : rim.others) {
    const std::size_t row = o.pixel, column = left.own(o.grain);
    const Vec2 slope = weight(row) * contrast[o.grain] * share_of(o, grain, motion).slope * o.outwards;
    rest(row, 0) += slope.x, rest(row, 1) += slope.y;
    rest(row, column) -= slope.x, rest(row, column + 1) -= slope.y;
    rest(row, unknowns) += dot(slope, motion.cosine[o.grain] - motion.cosine[grain]);
    rest(row, unknowns + 1) += dot(slope, motion.sine[o.grain] - motion.sine[grain]);
  }
  left.contrast = contrast_of(rim, grain, motion, mean, contrast);
  const Matrix q = statistics::orthonormal(part).q;
  rest -= q * transposed_times(q, rest);
  left.slopes = rest.part(0, unknowns), left.signal = rest.part(unknowns, 2);
  left.sector = mapped(rim.pixels, [](const RimPixel& pixel) { return sector_of(pixel.from_centre); });
  left.freedom = static_cast<double>(2 * (n - smooth - 2));
  left.normal = transposed_times(left.slopes, left.slopes);
  left.side = transposed_times(left.slopes, left.signal);
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
      for (std::size_t b = 0; b < each.side.rows(); ++b)
        all.normal.push_back({row, each.unknown(b), each.normal(a, b)});
    }
  double trace = 0;
  for (const auto& e : all.normal) trace += e.row == e.column ? e.value : 0;
  for (std::size_t k = 0; k < size; ++k)
    all.normal.push_back({k, k, 1e-7 * trace / static_cast<double>(size) + 1e-300});
  return all;
}

/// Steps of all grains that are linear in the place.
Matrix affine_step(const PictureGrains& grains, const Together& all) {
  double span = 1;
  for (std::size_t i = 0; i < grains.size(); ++i)
    span = std::max({span, std::abs(grains.centre[i].x), std::abs(grains.centre[i].y)});
  Matrix shape(all.side.rows(), 6), sums = shape;
  for (std::size_t i = 0; i < grains.size(); ++i)
    for (std::size_t k = 0; k < 2; ++k)
      shape(2 * i + k, 3 * k) = 1, shape(2 * i + k, 3 * k + 1) = grains.centre[i].x / span - 0.5,
                           shape(2 * i + k, 3 * k + 2) = grains.centre[i].y / span - 0.5;
  for (const auto& e : all.normal)
    for (std::size_t k = 0; k < 6; ++k) sums(e.row, k) += e.value * shape(e.column, k);
  Matrix normal = transposed_times(shape, sums);
  double trace = 0;
  for (std::size_t k = 0; k < 6; ++k) trace += normal(k, k);
  for (std::size_t k = 0; k < 6; ++k) normal(k, k) += 1e-9 * trace + 1e-300;
  return shape * solve_symmetric(normal, transposed_times(shape, all.side));
}

/// Adds the steps, none longer than a pixel; returns the longest.
double move(const Matrix& step, GrainMotion& motion) {
  constexpr double largest = 8;  // pixels; a larger amplitude is not believed
  double longest = 0;
  for (std::size_t i = 0; i < motion.size(); ++i)
    for (std::size_t k = 0; k < 2; ++k) {
      Vec2& at = k == 0 ? motion.cosine[i] : motion.sine[i];
      const Vec2 way{step(2 * i, k), step(2 * i + 1, k)};
      const double size = norm(way), part = size > 1 ? 1 / size : 1;
      if (!std::isfinite(size) || norm(at + part * way) > largest) continue;
      at += part * way;
      longest = std::max(longest, part * size);
    }
  return longest;
}

struct WayErrors {
  double by_sector = std::numeric_limits<double>::infinity(), by_pixel = by_sector;
};

/// Of a coordinate, from what the fit leaves on the rim and the grain's own part of the normal matrix; by sector that
/// of cosine and sine that is less sure.
WayErrors errors_of(const Left& left, const Matrix& step) {
  const Matrix& own = left.normal;
  const double trace = own(0, 0) + own(1, 1), determinant = own(0, 0) * own(1, 1) - own(0, 1) * own(1, 0);
  if (!(left.freedom > 0) || !(determinant > 1e-12 * trace * trace)) return {};
  Matrix local(own.rows(), 2), rest = left.signal;
  for (std::size_t a = 0; a < local.rows(); ++a)
    for (std::size_t k = 0; k < 2; ++k) local(a, k) = step(left.unknown(a), k);
  rest -= left.slopes * local;
  const auto seen = static_cast<double>(std::set(left.sector.begin(), left.sector.end()).size());
  double error = 0;
  for (std::size_t k = 0; k < 2; ++k) {
    std::array<Vec2, sectors> pull{};
    for (std::size_t p = 0; p < left.sector.size(); ++p)
      pull[left.sector[p]] += rest(p, k) * Vec2{left.slopes(p, 0), left.slopes(p, 1)};
    double sum = 0;
    for (const Vec2 g : pull) {
      const Vec2 moved{own(1, 1) * g.x - own(0, 1) * g.y, own(0, 0) * g.y - own(0, 1) * g.x};
      sum += dot(moved, moved) / (determinant * determinant);
    }
    error = std::max(error, 0.5 * sum * seen / std::max(seen - 2, 1.0));  // the fit makes two sums 0
  }
  return {std::sqrt(error), std::sqrt(squares(rest) / left.freedom * 0.5 * trace / determinant)};
}

/// Whether rims as a whole stand out of what warms and cools beside them: otherwise that passes for motion.
bool have_contrast(const std::vector<Left>& left) {
  constexpr double least = 3;
  const auto size = mapped(left, [](const Left& l) { return std::abs(l.contrast); });
  return median(size) > least * median(mapped(left, &Left::warming));
}

GrainMotion unseen(std::size_t grains) {
  const std::vector<double> unknown(grains, std::numeric_limits<double>::infinity());
  return {std::vector<Vec2>(grains), std::vector<Vec2>(grains), unknown, unknown};
}

}  // namespace

GrainMotion grain_motion(const PhasePictures& pictures, const PictureGrains& grains, int threads) {
  constexpr int affine_turns = 3, most_turns = 12;
  const std::size_t n = grains.size();
  GrainMotion motion = unseen(n);
  if (n == 0) return motion;
  std::vector<Rim> rims;
  std::vector<double> contrast(n, 0);
  std::vector<Left> left(n);
  Matrix step(0, 0);
  const ThreadPool pool(threads);
  for (int turn = 0; turn < most_turns; ++turn) {
    if (turn == 0 || turn == affine_turns || turn == affine_turns + 2)
      rims = rims_of(grains, motion, pictures.width, pictures.height);
    pool.for_each(n, [&](std::size_t i) { left[i] = motion_left(pictures, rims[i], i, motion, contrast); });
    for (std::size_t i = 0; i < n; ++i) contrast[i] = left[i].contrast;
    const Together all = assemble(left);
    step = turn < affine_turns ? affine_step(grains, all) : solve_sparse(all.normal, all.side);
    if (turn == affine_turns && !have_contrast(left)) return unseen(n);
    const double longest = move(step, motion);
    if (turn < affine_turns) continue;
    if (longest < 2e-3) break;
  }
  for (std::size_t i = 0; i < n; ++i) {
    const WayErrors errors = errors_of(left[i], step);
    motion.error[i] = errors.by_sector, motion.by_pixel[i] = errors.by_pixel;
  }
  return motion;
}

}  // namespace arenite::thermography

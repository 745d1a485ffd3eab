#include "thermal/thermography/grains/halo.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "model/lockin_maps.hpp"
#include "thermal/imaging/blur.hpp"

namespace arenite::thermography {
namespace {

constexpr std::array widths{2.0, 2.8, 4.0, 5.6, 8.0, 11.0};  // pixels
constexpr double rim_depth = 2.5;                            // pixels inside the rim that lens and motion reach
constexpr double most_halo = 0.4, least_errors = 5, least_halo = 0.005;  // shares of the light
constexpr int halo_turns = 8;

/// The picture without a halo: what it adds is taken off until nothing changes (the share is below a half).
FloatImage without(const Halo& halo, const FloatImage& seen) {
  FloatImage bare = seen;
  const auto kept = static_cast<float>(1 / (1 - halo.share)), share = static_cast<float>(halo.share);
  for (int turn = 0; turn < halo_turns; ++turn) {
    const FloatImage spread = imaging::blurred(bare, halo.width);
    for (std::size_t p = 0; p < bare.size(); ++p) bare.value[p] = kept * (seen.value[p] - share * spread.value[p]);
  }
  return bare;
}

/// Values of the pixels of one grain about their mean.
using Differences = std::vector<double>;

class InnerPixels {
 public:
  InnerPixels(const PictureGrains& grains, int width, int height) {
    for (std::size_t i = 0; i < grains.size(); ++i) {
      const double inner = grains.radius[i] - rim_depth;
      std::vector<std::size_t> own;
      each_pixel_near(grains.centre[i], std::max(inner, 0.0), width, height, [&](int x, int y, std::size_t p) {
        if (std::hypot(x - grains.centre[i].x, y - grains.centre[i].y) <= inner) own.push_back(p);
      });
      if (own.size() >= 5) grains_.push_back(std::move(own));
    }
  }
  std::size_t grains() const { return grains_.size(); }

  /// Of one grain.
  Differences differences(std::size_t grain, const FloatImage& of) const {
    Differences d;
    double mean = 0;
    for (const std::size_t p : grains_[grain]) d.push_back(static_cast<double>(of.value[p])), mean += d.back();
    mean /= static_cast<double>(d.size());
    for (double& v : d) v -= mean;
    return d;
  }

 private:
  std::vector<std::vector<std::size_t>> grains_;
};

double product(const Differences& a, const Differences& b) {
  double sum = 0;
  for (std::size_t k = 0; k < a.size(); ++k) sum += a[k] * b[k];
  return sum;
}

struct Trial {
  Halo halo;
  double left = 0;  ///< sum of squares
};

/// seen - warming pattern = even + share (blurred - seen) within every grain, by least squares.
Trial regressed(const InnerPixels& inner, const FloatImage& seen, const FloatImage& spread, const FloatImage& warming,
                double width) {
  double xx = 0, xw = 0, ww = 0, xy = 0, wy = 0;
  std::vector<std::array<Differences, 3>> all;
  for (std::size_t g = 0; g < inner.grains(); ++g) {
    const auto& [x, w, y] = all.emplace_back(
        std::array{inner.differences(g, spread), inner.differences(g, warming), inner.differences(g, seen)});
    xx += product(x, x), xw += product(x, w), ww += product(w, w), xy += product(x, y), wy += product(w, y);
  }
  Trial trial{{0, width, 0}, 0};
  const double determinant = xx * ww - xw * xw;
  if (!(determinant > 1e-9 * xx * ww)) return trial;
  const double share = (xy * ww - wy * xw) / determinant, pattern = (wy * xx - xy * xw) / determinant;
  double squares = 0;
  for (const auto& [x, w, y] : all) {
    double slope = 0;  // of this grain's own sum of squares: grains agree on the share as far as these scatter
    for (std::size_t k = 0; k < x.size(); ++k) {
      const double off = y[k] - share * x[k] - pattern * w[k];
      trial.left += off * off;
      slope += off * (x[k] - xw / ww * w[k]);
    }
    squares += slope * slope;
  }
  trial.halo = {share, width, std::sqrt(squares) * ww / determinant};
  return trial;
}

Trial tried(const InnerPixels& inner, const FloatImage& seen, const FloatImage& warming, double width) {
  Trial trial{{0, width, 0}, 0};
  FloatImage bare = seen;
  for (int turn = 0; turn < 4; ++turn) {
    FloatImage spread = imaging::blurred(bare, width);
    for (std::size_t p = 0; p < bare.size(); ++p) spread.value[p] -= bare.value[p];
    trial = regressed(inner, seen, spread, warming, width);
    trial.halo.share = std::clamp(trial.halo.share, 0.0, most_halo);
    bare = without(trial.halo, seen);
  }
  return trial;
}

FloatImage mean_of(const PhasePictures& pictures) {
  FloatImage mean{pictures.width, pictures.height, std::vector<float>(pictures.pixels(), 0.0f)};
  for (std::size_t k = 0; k < pictures.size(); ++k) {
    const std::vector<float> one = picture_of(pictures, k);
    for (std::size_t p = 0; p < one.size(); ++p) mean.value[p] += one[p] / static_cast<float>(pictures.size());
  }
  return mean;
}

/// What varies with the load: half the difference between its largest and its smallest value.
FloatImage warming_of(const PhasePictures& pictures, double largest) {
  FloatImage warming{pictures.width, pictures.height, std::vector<float>(pictures.pixels(), 0.0f)};
  for (std::size_t k = 0; k < pictures.size(); ++k) {
    const auto along =
        static_cast<float>(pictures.phases[k][1] * std::cos(largest) + pictures.phases[k][2] * std::sin(largest));
    const std::vector<float> one = picture_of(pictures, k);
    for (std::size_t p = 0; p < one.size(); ++p)
      warming.value[p] += 2 * along * one[p] / static_cast<float>(pictures.size());
  }
  return warming;
}

}  // namespace

Halo halo_of(const PhasePictures& pictures, const PictureGrains& grains, double largest_load_phase) {
  if (pictures.size() == 0) return {};
  const InnerPixels inner(grains, pictures.width, pictures.height);
  if (inner.grains() < 3) return {};
  const FloatImage seen = mean_of(pictures), warming = warming_of(pictures, largest_load_phase);
  Trial best = tried(inner, seen, warming, widths.front());
  for (const double width : widths)
    if (const Trial trial = tried(inner, seen, warming, width); trial.left < best.left) best = trial;
  const Halo& halo = best.halo;
  return halo.share > std::max(least_halo, least_errors * halo.error) ? halo : Halo{0, halo.width, halo.error};
}

void remove_halo(const Halo& halo, PhasePictures& pictures) {
  if (halo.share <= 0) return;
  for (std::size_t k = 0; k < pictures.size(); ++k) {
    const auto at = pictures.spline.begin() + static_cast<std::ptrdiff_t>(k * pictures.pixels());
    const FloatImage bare =
        without(halo, {pictures.width, pictures.height, {at, at + static_cast<std::ptrdiff_t>(pictures.pixels())}});
    std::copy(bare.value.begin(), bare.value.end(), at);
  }
}

void remove_halo(const Halo& halo, LockinMaps& maps) {
  if (halo.share <= 0) return;
  for (auto* map : {&maps.mean, &maps.in_phase, &maps.quadrature})
    *map = without(halo, {maps.width, maps.height, *map}).value;
  for (std::size_t p = 0; p < maps.size(); ++p) {
    maps.amplitude[p] = std::hypot(maps.in_phase[p], maps.quadrature[p]);
    maps.phase[p] = static_cast<float>(maps.reference_phase) + std::atan2(maps.quadrature[p], maps.in_phase[p]);
  }
}

}  // namespace arenite::thermography

#include "thermal/thermography/grain_scene.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "core/median.hpp"
#include "core/threads.hpp"
#include "thermal/imaging/lens.hpp"
#include "thermal/thermography/phase_pictures.hpp"

namespace arenite::thermography {
namespace {

constexpr int fine = 4;  ///< points a pixel, along each axis

struct Canvas {
  int width, height, margin;
  std::vector<float> light;
  double place(int point) const { return (point - margin + 0.5) / fine - 0.5; }
  int first(double pixel) const { return static_cast<int>(std::ceil((pixel + 0.5) * fine - 0.5)) + margin; }
};

/// Half-planes that neighbours leave to a disk: inside where x nx + y ny < reach, from its centre.
struct Chord {
  double nx, ny, reach;
};

double cover(double out) { return std::clamp(0.5 - out * fine, 0.0, 1.0); }

void paint(Canvas& canvas, double x, double y, double r, double step, const std::vector<Chord>& chords) {
  const double reach = r + 1.0 / fine;
  const int r0 = std::max(0, canvas.first(y - reach)), r1 = std::min(canvas.height, canvas.first(y + reach));
  for (int row = r0; row < r1; ++row) {
    const double dy = canvas.place(row) - y, half = std::sqrt(std::max(0.0, reach * reach - dy * dy));
    const int c0 = std::max(0, canvas.first(x - half)), c1 = std::min(canvas.width, canvas.first(x + half));
    float* line = canvas.light.data() + static_cast<std::ptrdiff_t>(row) * canvas.width;
    for (int column = c0; column < c1; ++column) {
      const double dx = canvas.place(column) - x;
      double share = cover(std::sqrt(dx * dx + dy * dy) - r);
      for (const Chord& c : chords) share *= cover(dx * c.nx + dy * c.ny - c.reach);
      line[column] += static_cast<float>(share * step);
    }
  }
}

std::vector<Chord> chords_of(const PictureGrains& g, std::size_t i) {
  std::vector<Chord> chords;
  for (std::size_t j = 0; j < g.size(); ++j) {
    const double dx = g.x[j] - g.x[i], dy = g.y[j] - g.y[i], d2 = dx * dx + dy * dy, both = g.radius[i] + g.radius[j];
    if (j == i || d2 >= both * both || d2 <= 0) continue;
    const double d = std::sqrt(d2);
    chords.push_back({dx / d, dy / d, (d2 + g.radius[i] * g.radius[i] - g.radius[j] * g.radius[j]) / (2 * d)});
  }
  return chords;
}

/// Mean over the grain's inner pixels, at least the one in its middle.
double inner_level(const PhasePictures& pictures, const PictureGrains& g, const GrainMotion& m, std::size_t i) {
  const PixelHarmonics fit(pictures, m.cos_x[i], m.sin_x[i], m.cos_y[i], m.sin_y[i]);
  const double inner = std::max(0.5, std::min(0.8 * g.radius[i], g.radius[i] - 2.5));
  double sum = 0, n = 0;
  const int reach = static_cast<int>(inner);
  for (int dy = -reach; dy <= reach; ++dy)
    for (int dx = -reach; dx <= reach; ++dx) {
      if (dx * dx + dy * dy > inner * inner) continue;
      sum += fit.follow(pictures, g.x[i] + dx, g.y[i] + dy).mean;
      n += 1;
    }
  return sum / n;
}

/// Grains where they are in picture `k`.
PictureGrains grains_in(const PhasePictures& p, std::size_t k, const PictureGrains& grains, const GrainMotion& m) {
  PictureGrains there = grains;
  for (std::size_t i = 0; i < grains.size(); ++i) {
    there.x[i] += m.cos_x[i] * p.cosine[k] + m.sin_x[i] * p.sine[k];
    there.y[i] += m.cos_y[i] * p.cosine[k] + m.sin_y[i] * p.sine[k];
  }
  return there;
}

/// Disks whose `level` is given, through a lens that spreads a point by `blur` (standard deviation, pixels) and the mean over
/// each pixel. Disks that overlap are parted by the chord of their rims.
std::vector<float> draw_disks(const PictureGrains& g, const std::vector<double>& level, double background, double blur, int width, int height) {
  const imaging::Lens lens = imaging::make_lens(blur, fine, 4);
  Canvas canvas{width * fine + 2 * lens.margin, height * fine + 2 * lens.margin, lens.margin, {}};
  canvas.light.assign(static_cast<std::size_t>(canvas.width) * static_cast<std::size_t>(canvas.height), 0.0f);
  for (std::size_t i = 0; i < g.size(); ++i) paint(canvas, g.x[i], g.y[i], g.radius[i], level[i] - background, chords_of(g, i));
  std::vector<float> picture = imaging::through_lens(lens, canvas.light, width, height);
  for (float& v : picture) v += static_cast<float>(background);
  return picture;
}

/// Most pixels between grains show some grain too: what is left of them without the grains, over their open share. Pixels far
/// from any grain may show the frame.
double background_level(const PhasePictures& pictures, const GrainScene& scene, const PictureGrains& grains, const GrainMotion& motion, double blur) {
  constexpr float least = 0.5f, most = 0.98f;
  const PictureGrains there = grains_in(pictures, 0, grains, motion);
  const std::vector<float> open = draw_disks(there, std::vector<double>(grains.size(), 0.0), 1, blur, pictures.width, pictures.height);
  const std::vector<float> disks = draw_disks(there, scene.grain, 0, blur, pictures.width, pictures.height);
  const std::vector<float> seen = picture_of(pictures, 0);
  std::vector<std::pair<double, double>> pores;  // level and weight
  for (std::size_t p = 0; p < seen.size(); ++p)
    if (open[p] > least && open[p] < most) pores.emplace_back(static_cast<double>((seen[p] - disks[p]) / open[p]), static_cast<double>(open[p] * open[p]));
  return weighted_median(std::move(pores), scene.grain.empty() ? 0 : scene.grain.front());
}

/// Least mean distance between picture and drawing, by golden section; it has one minimum.
template <class Distance> double nearest(double low, double high, const Distance& distance) {
  const double golden = 0.5 * (std::sqrt(5.0) - 1);
  double a = high - golden * (high - low), b = low + golden * (high - low), at_a = distance(a), at_b = distance(b);
  while (high - low > 0.02) {
    if (at_a < at_b) {
      high = b, b = a, at_b = at_a;
      a = high - golden * (high - low), at_a = distance(a);
    } else {
      low = a, a = b, at_a = at_b;
      b = low + golden * (high - low), at_b = distance(b);
    }
  }
  return 0.5 * (low + high);
}

}  // namespace

GrainScene grain_scene(const PhasePictures& pictures, const PictureGrains& grains, const GrainMotion& motion, double blur, int threads) {
  GrainScene scene;
  scene.grain.resize(grains.size());
  Team(threads).for_each(grains.size(), [&](std::size_t i) { scene.grain[i] = inner_level(pictures, grains, motion, i); });
  scene.background = background_level(pictures, scene, grains, motion, blur);
  return scene;
}

PhasePictures without_scene(const PhasePictures& pictures, const GrainScene& scene, const PictureGrains& grains, const GrainMotion& motion, double blur,
                            int threads) {
  PhasePictures rest = pictures;
  Team(threads).for_each(rest.size(), [&](std::size_t k) {
    std::vector<float> drawn = draw_disks(grains_in(rest, k, grains, motion), scene.grain, scene.background, blur, rest.width, rest.height);
    spline_coefficients(drawn.data(), rest.width, rest.height);
    float* coefficient = rest.spline.data() + k * rest.pixels();
    for (std::size_t p = 0; p < drawn.size(); ++p) coefficient[p] -= drawn[p];
  });
  return rest;
}

double rim_blur(const PhasePictures& pictures, const PictureGrains& grains, const GrainMotion& motion, int threads) {
  if (grains.size() == 0 || pictures.size() == 0) return std::numeric_limits<double>::quiet_NaN();
  constexpr double least = 0.15, most = 1.6, middle = 0.6;
  constexpr float inside = 0.03f, outside = 0.97f;
  const PictureGrains there = grains_in(pictures, 0, grains, motion);
  const std::vector<float> seen = picture_of(pictures, 0);
  // Rims are where a lens of middling blur shows grain and background at once.
  const std::vector<float> open = draw_disks(there, std::vector<double>(grains.size(), 0.0), 1, middle, pictures.width, pictures.height);
  return nearest(least, most, [&](double blur) {
    const GrainScene scene = grain_scene(pictures, grains, motion, blur, threads);
    const std::vector<float> drawn = draw_disks(there, scene.grain, scene.background, blur, pictures.width, pictures.height);
    double sum = 0, count = 0;
    for (std::size_t p = 0; p < seen.size(); ++p)
      if (open[p] > inside && open[p] < outside) sum += std::abs(static_cast<double>(seen[p] - drawn[p])), ++count;
    return count > 0 ? sum / count : 0;
  });
}

}  // namespace arenite::thermography

#include "thermal/thermography/grain_motion.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "core/median.hpp"
#include "core/threads.hpp"
#include "thermal/optics/lens.hpp"

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
    const double dx = g.centre[j].x - g.centre[i].x, dy = g.centre[j].y - g.centre[i].y, d2 = dx * dx + dy * dy, both = g.radius[i] + g.radius[j];
    if (j == i || d2 >= both * both || d2 <= 0) continue;
    const double d = std::sqrt(d2);
    chords.push_back({dx / d, dy / d, (d2 + g.radius[i] * g.radius[i] - g.radius[j] * g.radius[j]) / (2 * d)});
  }
  return chords;
}

/// Mean over the grain's inner pixels, at least the one in its middle.
double inner_level(const PhasePictures& pictures, const PictureGrains& g, const GrainMotion& m, std::size_t i) {
  const PixelHarmonics fit(pictures, m, i);
  const double inner = std::max(0.5, std::min(0.8 * g.radius[i], g.radius[i] - 2.5));
  double sum = 0, n = 0;
  const int reach = static_cast<int>(inner);
  for (int dy = -reach; dy <= reach; ++dy)
    for (int dx = -reach; dx <= reach; ++dx) {
      if (dx * dx + dy * dy > inner * inner) continue;
      sum += fit.follow(pictures, g.centre[i].x + dx, g.centre[i].y + dy).harmonics[0];
      n += 1;
    }
  return sum / n;
}

/// Grains where they are in picture `k`.
PictureGrains grains_in(const PhasePictures& p, std::size_t k, const PictureGrains& grains, const GrainMotion& m) {
  PictureGrains there = grains;
  for (std::size_t i = 0; i < grains.size(); ++i) {
    const Vec2 moved = p.moved(m, i, k);
    there.centre[i] += moved;
  }
  return there;
}

/// Disks whose `level` is given, through a lens that spreads a point by `blur` (standard deviation, pixels) and the mean over
/// each pixel. Disks that overlap are parted by the chord of their rims.
std::vector<float> draw_disks(const PictureGrains& g, const std::vector<double>& level, double background, double blur, int width, int height) {
  const optics::Lens lens = optics::make_lens(blur, fine, 4);
  Canvas canvas{width * fine + 2 * lens.margin, height * fine + 2 * lens.margin, lens.margin, {}};
  canvas.light.assign(static_cast<std::size_t>(canvas.width) * static_cast<std::size_t>(canvas.height), 0.0f);
  for (std::size_t i = 0; i < g.size(); ++i) paint(canvas, g.centre[i].x, g.centre[i].y, g.radius[i], level[i] - background, chords_of(g, i));
  std::vector<float> picture = optics::through_lens(lens, canvas.light, width, height);
  for (float& v : picture) v += static_cast<float>(background);
  return picture;
}

/// Levels of evenly bright disks before an even background: what a film would show if nothing warmed under the load.
struct GrainScene {
  std::vector<double> grain;  ///< mean of every grain over its inner pixels
  double background = 0;      ///< where no grain reaches
};

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

GrainScene grain_scene(const PhasePictures& pictures, const PictureGrains& grains, const GrainMotion& motion, double blur, int threads) {
  GrainScene scene;
  scene.grain.resize(grains.size());
  ThreadPool(threads).for_each(grains.size(), [&](std::size_t i) { scene.grain[i] = inner_level(pictures, grains, motion, i); });
  scene.background = background_level(pictures, scene, grains, motion, blur);
  return scene;
}

/// The pictures less the scene with its grains where they are in each. Rims of grains are too sharp for the pixels to be
/// resampled; what is left here is smooth.
PhasePictures without_scene(const PhasePictures& pictures, const GrainScene& scene, const PictureGrains& grains, const GrainMotion& motion, double blur,
                            int threads) {
  PhasePictures rest = pictures;
  ThreadPool(threads).for_each(rest.size(), [&](std::size_t k) {
    std::vector<float> drawn = draw_disks(grains_in(rest, k, grains, motion), scene.grain, scene.background, blur, rest.width, rest.height);
    spline_coefficients(drawn.data(), rest.width, rest.height);
    float* coefficient = rest.spline.data() + k * rest.pixels();
    for (std::size_t p = 0; p < drawn.size(); ++p) coefficient[p] -= drawn[p];
  });
  return rest;
}

void put(LockinMaps& maps, std::size_t p, const Followed& f, double factor, double spread) {
  const auto [mean, cosine, sine, cosine2, sine2] = f.harmonics;
  maps.mean[p] = static_cast<float>(mean);
  maps.amplitude[p] = static_cast<float>(factor * std::hypot(cosine, sine));
  maps.phase[p] = static_cast<float>(std::atan2(sine, cosine));
  if (!maps.second_harmonic.empty()) maps.second_harmonic[p] = static_cast<float>(factor * std::hypot(cosine2, sine2));
  const double noise = std::sqrt(f.variance);
  maps.residual[p] = static_cast<float>(noise);
  maps.standard_error[p] = static_cast<float>(spread * noise);
  maps.noise_floor[p] = static_cast<float>(std::sqrt(std::numbers::pi / 2) * spread * noise);
}

/// Amplitudes in phase with the load and a quarter of a cycle off. Where rims sweep over a pixel it shows their motion and no warming.
void project(LockinMaps& maps, const std::vector<std::int32_t>& owner) {
  for (std::size_t p = 0; p < maps.size(); ++p) {
    const double angle = static_cast<double>(maps.phase[p]) - maps.reference_phase, a = static_cast<double>(maps.amplitude[p]);
    maps.in_phase[p] = static_cast<float>(a * std::cos(angle));
    maps.quadrature[p] = static_cast<float>(a * std::sin(angle));
    if (owner[p] >= 0) continue;
    for (auto* map : {&maps.amplitude, &maps.phase, &maps.in_phase, &maps.quadrature, &maps.second_harmonic, &maps.standard_error, &maps.residual})
      if (!map->empty()) (*map)[p] = std::numeric_limits<float>::quiet_NaN();
  }
}

/// The grain whose rim is furthest out of a pixel: neighbours may overlap in a picture, but each pixel follows one grain.
std::vector<std::int32_t> owners(const PictureGrains& grains, int width, int height) {
  std::vector<std::int32_t> owner(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), -1);
  std::vector<double> depth(owner.size(), 0);
  for (std::size_t i = 0; i < grains.size(); ++i) {
    const double x = grains.centre[i].x, y = grains.centre[i].y, r = grains.radius[i];
    each_pixel_near({x, y}, r, width, height, [&](int column, int row, std::size_t p) {
      const double inside = r - std::hypot(column - x, row - y);
      if (inside < 0 || (owner[p] >= 0 && inside <= depth[p])) return;
      owner[p] = static_cast<std::int32_t>(i);
      depth[p] = inside;
    });
  }
  return owner;
}

std::vector<double> joined(const std::vector<std::vector<double>>& parts) {
  std::vector<double> all;
  for (const auto& part : parts) all.insert(all.end(), part.begin(), part.end());
  return all;
}

}  // namespace

LockinMaps follow_grains(const PhasePictures& pictures, const LockinMaps& maps, const PictureGrains& grains, const GrainMotion& motion,
                         const PictureGrains& shown, std::optional<double> given_phase, int threads, double blur) {
  LockinMaps result = maps;
  const double factor = 2 / to_peak_to_peak(maps.convention), spread = factor * std::sqrt(2 * maps.noise_ratio / static_cast<double>(maps.frames));
  const GrainScene scene = grain_scene(pictures, grains, motion, blur, threads);
  const PhasePictures rest = without_scene(pictures, scene, grains, motion, blur, threads);
  const std::vector<std::int32_t> owner = owners(shown, maps.width, maps.height);
  std::vector<std::vector<double>> cosine(grains.size()), sine(grains.size());
  const auto follow = [&](std::size_t i) {
    const PixelHarmonics fit(rest, motion, i);
    const double x = shown.centre[i].x, y = shown.centre[i].y, r = shown.radius[i];
    each_pixel_near({x, y}, r, maps.width, maps.height, [&](int column, int row, std::size_t p) {
      const double out = std::hypot(column - x, row - y);
      if (out > r || owner[p] != static_cast<std::int32_t>(i)) return;
      Followed f = fit.follow(rest, column + grains.centre[i].x - x, row + grains.centre[i].y - y);
      f.harmonics[0] += scene.grain[i];
      put(result, p, f, factor, spread);
      if (out > 0.7 * r) return;
      cosine[i].push_back(f.harmonics[1]);
      sine[i].push_back(f.harmonics[2]);
    });
  };
  ThreadPool(threads).for_each(grains.size(), follow);
  if (given_phase) result.reference_phase = *given_phase;
  else if (grains.size() > 0) result.reference_phase = reference_phase(joined(cosine), joined(sine));
  project(result, owner);
  return result;
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

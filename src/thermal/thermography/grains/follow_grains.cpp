#include "thermal/thermography/grains/follow_grains.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "core/mapped.hpp"
#include "core/median.hpp"
#include "core/threads.hpp"
#include "model/grain_motion.hpp"
#include "model/lockin_maps.hpp"
#include "thermal/optics/lens.hpp"

namespace arenite::thermography {
namespace {

constexpr int fine = 4;  ///< points a pixel, along each axis

/// Half-plane that a neighbour leaves to a disk: inside where dot(normal, place) < reach, from its centre.
struct Chord {
  Vec2 normal;
  double reach;
};

double cover(double out) { return std::clamp(0.5 - out * fine, 0.0, 1.0); }

void paint(optics::Canvas& canvas, Vec2 centre, double r, double step, const std::vector<Chord>& chords) {
  canvas.each_point(centre, r + 1.0 / fine, [&](std::size_t at, Vec2 away) {
    double share = cover(norm(away) - r);
    for (const Chord& c : chords) share *= cover(dot(away, c.normal) - c.reach);
    canvas.light[at] += static_cast<float>(share * step);
  });
}

std::vector<Chord> chords_of(const PictureGrains& g, std::size_t i) {
  std::vector<Chord> chords;
  for (std::size_t j = 0; j < g.size(); ++j) {
    const Vec2 apart = g.centre[j] - g.centre[i];
    const double d2 = dot(apart, apart), both = g.radius[i] + g.radius[j];
    if (j == i || d2 >= both * both || d2 <= 0) continue;
    const double d = std::sqrt(d2);
    chords.push_back({apart / d, (d2 + g.radius[i] * g.radius[i] - g.radius[j] * g.radius[j]) / (2 * d)});
  }
  return chords;
}

/// Evenly bright disks that move before an even background: what a film would show if nothing warmed under the load.
class GrainScene {
 public:
  GrainScene(const PhasePictures& pictures, const PictureGrains& grains, const GrainMotion& motion,
             const ThreadPool& pool)
      : pictures_(pictures),
        grains_(grains),
        motion_(motion),
        level_(grains.size()) {
    pool.for_each(grains.size(), [&](std::size_t i) { level_[i] = inner_level(i); });
  }

  /// Mean of a grain over its inner pixels.
  double level(std::size_t grain) const { return level_[grain]; }

  /// Share of every pixel of picture k in which no grain is seen, through a lens that spreads a point by `blur`
  /// (standard deviation, pixels).
  std::vector<float> open(std::size_t k, double blur) const {
    return draw(k, std::vector<double>(level_.size(), 0.0), 1, blur);
  }
  std::vector<float> drawn(std::size_t k, double background, double blur) const {
    return draw(k, level_, background, blur);
  }

  /// Level where no grain reaches. Most pixels between grains show some grain too: what is left of them without the
  /// grains, over their open share. Pixels far from any grain may show the frame.
  double background(double blur) const {
    constexpr float least = 0.5f, most = 0.98f;
    const std::vector<float> share = open(0, blur), disks = drawn(0, 0, blur), seen = picture_of(pictures_, 0);
    std::vector<std::pair<double, double>> pores;  // level and weight
    for (std::size_t p = 0; p < seen.size(); ++p)
      if (share[p] > least && share[p] < most)
        pores.emplace_back(static_cast<double>((seen[p] - disks[p]) / share[p]),
                           static_cast<double>(share[p] * share[p]));
    return weighted_median(std::move(pores), level_.empty() ? 0 : level_.front());
  }

 private:
  /// At least the pixel in its middle.
  double inner_level(std::size_t i) const {
    const PixelHarmonics fit(pictures_, motion_, i);
    const double inner = std::max(0.5, std::min(0.8 * grains_.radius[i], grains_.radius[i] - 2.5));
    double sum = 0, n = 0;
    const int reach = static_cast<int>(inner);
    for (int dy = -reach; dy <= reach; ++dy)
      for (int dx = -reach; dx <= reach; ++dx) {
        if (dx * dx + dy * dy > inner * inner) continue;
        sum += fit.follow(pictures_, {grains_.centre[i].x + dx, grains_.centre[i].y + dy}).harmonics[0];
        n += 1;
      }
    return sum / n;
  }

  /// Disks of these levels where the grains are in picture k. Those that overlap are parted by the chord of their rims.
  std::vector<float> draw(std::size_t k, const std::vector<double>& level, double background, double blur) const {
    const optics::Lens lens = optics::make_lens(blur, fine, 4);
    optics::Canvas canvas(lens, pictures_.width, pictures_.height,
                          {0.5 * (pictures_.width - 1), 0.5 * (pictures_.height - 1)}, {1.0 / fine, 1.0 / fine});
    PictureGrains there = grains_;
    for (std::size_t i = 0; i < there.size(); ++i) there.centre[i] += pictures_.moved(motion_, i, k);
    for (std::size_t i = 0; i < there.size(); ++i)
      paint(canvas, there.centre[i], there.radius[i], level[i] - background, chords_of(there, i));
    std::vector<float> picture = optics::through_lens(lens, canvas.light, pictures_.width, pictures_.height);
    for (float& v : picture) v += static_cast<float>(background);
    return picture;
  }

  const PhasePictures& pictures_;
  const PictureGrains& grains_;
  const GrainMotion& motion_;
  std::vector<double> level_;
};

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

/// The pictures less the scene with its grains where they are in each. Rims of grains are too sharp for the pixels to
/// be resampled; what is left here is smooth.
PhasePictures without_scene(const PhasePictures& pictures, const GrainScene& scene, double blur,
                            const ThreadPool& pool) {
  PhasePictures rest = pictures;
  const double background = scene.background(blur);
  pool.for_each(rest.size(), [&](std::size_t k) {
    std::vector<float> drawn = scene.drawn(k, background, blur);
    spline_coefficients(drawn.data(), rest.width, rest.height);
    float* coefficient = rest.spline.data() + k * rest.pixels();
    for (std::size_t p = 0; p < drawn.size(); ++p) coefficient[p] -= drawn[p];
  });
  return rest;
}

/// Amplitudes in phase with the load and a quarter of a cycle off. Where rims sweep over a pixel it shows their motion
/// and no warming.
void project(LockinMaps& maps, const std::vector<std::int32_t>& owner) {
  for (std::size_t p = 0; p < maps.size(); ++p) {
    const double angle = static_cast<double>(maps.phase[p]) - maps.reference_phase,
                 a = static_cast<double>(maps.amplitude[p]);
    maps.in_phase[p] = static_cast<float>(a * std::cos(angle));
    maps.quadrature[p] = static_cast<float>(a * std::sin(angle));
    if (owner[p] >= 0) continue;
    for (auto* map : {&maps.amplitude, &maps.phase, &maps.in_phase, &maps.quadrature, &maps.second_harmonic,
                      &maps.standard_error, &maps.residual})
      if (!map->empty()) (*map)[p] = std::numeric_limits<float>::quiet_NaN();
  }
}

}  // namespace

std::vector<std::uint8_t> lost_grains(const GrainMotion& motion) {
  const auto& errors = motion.by_pixel.empty() ? motion.error : motion.by_pixel;
  const double usual = median_of_finite(errors);
  return mapped<std::uint8_t>(errors, [&](double error) { return std::isfinite(error) && error > 6 * usual; });
}

bool is_seen(const GrainMotion& motion) {
  return std::ranges::any_of(motion.error, [](double error) { return std::isfinite(error); });
}

std::vector<std::int32_t> owners(const PictureGrains& grains, int width, int height, double beyond) {
  std::vector<std::int32_t> owner(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), -1);
  std::vector<double> outside(owner.size(), 0);
  for (std::size_t i = 0; i < grains.size(); ++i) {
    const Vec2 centre = grains.centre[i];
    each_pixel_near(centre, grains.radius[i] + beyond, width, height, [&](int column, int row, std::size_t p) {
      const double out = std::hypot(column - centre.x, row - centre.y) - grains.radius[i];
      if (out > beyond || (owner[p] >= 0 && out >= outside[p])) return;
      owner[p] = static_cast<std::int32_t>(i);
      outside[p] = out;
    });
  }
  return owner;
}

LockinMaps follow_grains(const PhasePictures& pictures, const LockinMaps& maps, const PictureGrains& grains,
                         const GrainMotion& motion, const PictureGrains& shown, int threads,
                         std::optional<double> given_phase, double blur) {
  LockinMaps result = maps;
  const double own = maps.shared_cosine.empty() ? 1 : maps.own_share;
  const double spread = std::sqrt(2 * maps.noise_ratio * own / static_cast<double>(maps.frames));
  const ThreadPool pool(threads);
  const GrainScene scene(pictures, grains, motion, pool);
  const PhasePictures rest = without_scene(pictures, scene, blur, pool);
  const std::vector<std::int32_t> owner = owners(shown, maps.width, maps.height, 0);
  std::vector<double> cosine(maps.size(), std::numeric_limits<double>::quiet_NaN()),
      sine = cosine;  // of the inner pixels of grains
  pool.for_each(grains.size(), [&](std::size_t i) {
    const PixelHarmonics fit(rest, motion, i);
    const Vec2 centre = shown.centre[i];
    const double r = shown.radius[i];
    each_pixel_near(centre, r, maps.width, maps.height, [&](double column, double row, std::size_t p) {
      const double out = std::hypot(column - centre.x, row - centre.y);
      if (out > r || owner[p] != static_cast<std::int32_t>(i)) return;
      Followed f = fit.follow(rest, Vec2{column, row} + grains.centre[i] - centre);
      f.harmonics[0] += scene.level(i);
      if (!maps.shared_cosine.empty()) {
        const double factor = 2 / to_peak_to_peak(maps.convention);
        const std::size_t at = p % static_cast<std::size_t>(maps.width);
        f.harmonics[1] -= maps.shared_cosine[at] / factor, f.harmonics[2] -= maps.shared_sine[at] / factor;
      }
      put(result, p, f.harmonics, std::sqrt(f.variance), spread);
      if (out <= 0.7 * r) cosine[p] = f.harmonics[1], sine[p] = f.harmonics[2];
    });
  });
  if (given_phase) result.reference_phase = *given_phase;
  else if (grains.size() > 0) result.reference_phase = reference_phase(cosine, sine);
  project(result, owner);
  return result;
}

double rim_blur(const PhasePictures& pictures, const PictureGrains& grains, const GrainMotion& motion, int threads) {
  if (grains.size() == 0 || pictures.size() == 0) return std::numeric_limits<double>::quiet_NaN();
  constexpr double least = 0.15, most = 1.6, middle = 0.6;
  constexpr float inside = 0.03f, outside = 0.97f;
  const std::vector<float> seen = picture_of(pictures, 0);
  const GrainScene scene(pictures, grains, motion, ThreadPool(threads));
  // Rims are where a lens of middling blur shows grain and background at once.
  const std::vector<float> open = scene.open(0, middle);
  return nearest(least, most, [&](double blur) {
    const std::vector<float> drawn = scene.drawn(0, scene.background(blur), blur);
    double sum = 0, count = 0;
    for (std::size_t p = 0; p < seen.size(); ++p)
      if (open[p] > inside && open[p] < outside) sum += std::abs(static_cast<double>(seen[p] - drawn[p])), ++count;
    return count > 0 ? sum / count : 0;
  });
}

}  // namespace arenite::thermography

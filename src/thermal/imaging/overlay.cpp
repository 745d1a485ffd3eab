#include "thermal/imaging/overlay.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/mapped.hpp"
#include "core/median.hpp"
#include "core/problems.hpp"
#include "geometry/rectangle.hpp"
#include "model/domain.hpp"
#include "thermal/imaging/disk_model.hpp"
#include "thermal/imaging/registration.hpp"

namespace arenite::imaging {
namespace {

constexpr double rim = 0.8;   // pixels: blur of lens and pixel in the cover, roughly
constexpr double beyond = 3;  // pixels round the grains that count
constexpr double usual_blur = 0.7, overlay_outlier = 3;
constexpr double radius_known = 0.01;  // share: radii are those of the circles
constexpr int rounds = 3;

/// What circles cover, in a window that reaches a little beyond them.
struct Cover : FloatImage {
  int x0, y0;  ///< of the window's first pixel
};

Cover cover_of(const PictureGrains& g) {
  const geometry::Rectangle box = geometry::bounds(g.centre, g.radius);
  Cover c{{}, static_cast<int>(std::floor(box.x_min - beyond)), static_cast<int>(std::floor(box.y_min - beyond))};
  c.width = static_cast<int>(std::ceil(box.x_max + beyond)) - c.x0 + 1;
  c.height = static_cast<int>(std::ceil(box.y_max + beyond)) - c.y0 + 1;
  c.value.resize(c.size());
  for (std::size_t i = 0; i < g.size(); ++i) {
    const Vec2 centre = g.centre[i] - Vec2{1.0 * c.x0, 1.0 * c.y0};
    each_pixel_near(centre, g.radius[i] + 3, c.width, c.height, [&](int x, int y, std::size_t at) {
      const double deep = g.radius[i] - std::hypot(x - centre.x, y - centre.y);
      c.value[at] = std::min(1.0f, c.value[at] + static_cast<float>(0.5 * std::erfc(-deep / (rim * std::sqrt(2.0)))));
    });
  }
  return c;
}

double correlation(const Cover& c, const FloatImage& picture, int dx, int dy) {
  const int x0 = std::max(0, -c.x0 - dx), x1 = std::min(c.width, picture.width - c.x0 - dx);
  const int y0 = std::max(0, -c.y0 - dy), y1 = std::min(c.height, picture.height - c.y0 - dy);
  if (x1 <= x0 || y1 <= y0) return 0;
  double n = 0, a = 0, b = 0, aa = 0, bb = 0, ab = 0;
  const auto level = static_cast<double>(picture.value[picture.value.size() / 2]);
  for (int y = y0; y < y1; ++y) {
    const float* u = c.value.data() + c.index(0, y);
    const float* v = picture.value.data() + picture.index(0, y + c.y0 + dy);
    for (int x = x0; x < x1; ++x) {
      const auto p = static_cast<double>(u[x]), q = static_cast<double>(v[x + c.x0 + dx]) - level;
      a += p, b += q, aa += p * p, bb += q * q, ab += p * q;
    }
    n += x1 - x0;
  }
  const double spread = (aa - a * a / n) * (bb - b * b / n);
  return spread > 0 ? (ab - a * b / n) / std::sqrt(spread) : 0;
}

/// t, then turned about a place and shifted.
Similarity turned(Similarity t, double angle, Vec2 about, Vec2 shift) {
  t.shift = about + shift + Similarity{1, angle, {}}(t.shift - about);
  t.rotation += angle;
  return t;
}

/// By whole pixels, and by turns that move the outermost grain by one.
void search(const PictureGrains& circles, const FloatImage& picture, const OverlayOptions& options, Overlay& found) {
  const PictureGrains at = apply(found.transform, circles);
  const Vec2 middle = mean_point(at.centre);
  double farthest = 1;
  for (const Vec2 centre : at.centre) farthest = std::max(farthest, norm(centre - middle));
  const double step = 1 / farthest;
  const int turns = static_cast<int>(std::ceil(options.turn / step)),
            reach = static_cast<int>(std::ceil(options.reach));
  const Similarity first = found.transform;
  for (int k = -turns; k <= turns; ++k) {
    const Cover cover = cover_of(apply(turned(first, k * step, middle, {}), circles));
    for (int dy = -reach; dy <= reach; ++dy)
      for (int dx = -reach; dx <= reach; ++dx) {
        const double here = correlation(cover, picture, dx, dy);
        if (std::abs(here) <= std::abs(found.correlation)) continue;
        found.correlation = here;
        found.transform = turned(first, k * step, middle, {static_cast<double>(dx), static_cast<double>(dy)});
      }
  }
}

/// Fits every circle to the picture from where the transform has it, and the transform to where they went.
void refine(const PictureGrains& circles, const FloatImage& picture, Overlay& found) {
  const PictureGrains at = apply(found.transform, circles);
  DiskModel model(picture, usual_blur, found.correlation > 0);
  for (std::size_t i = 0; i < at.size(); ++i) {
    model.add({at.centre[i], at.radius[i], 1});
    model.disks().back().prior_radius = at.radius[i];
    model.disks().back().prior_error = radius_known * at.radius[i];
  }
  model.refresh();
  model.fit(10);
  const std::vector<Vec2> fitted = mapped(model.disks(), &DiskModel::Disk::centre);
  std::vector<double> away(fitted.size());
  const auto measure = [&] {
    for (std::size_t i = 0; i < fitted.size(); ++i) away[i] = norm(found.transform(circles.centre[i]) - fitted[i]);
    found.rms = median(away) / median_of_plane_distance;
  };
  measure();
  for (int pass = 0; pass < rounds; ++pass) {
    std::vector<Vec2> from, to;
    for (std::size_t i = 0; i < at.size(); ++i)
      if (away[i] <= overlay_outlier * found.rms * 1.2 + 1e-9)
        from.push_back(circles.centre[i]), to.push_back(fitted[i]);
    if (from.size() < 3) return;
    found.transform = fit_similarity(from, to, false);
    measure();
  }
}

}  // namespace

Overlay lay_over(const PictureGrains& circles, const Similarity& first, const FloatImage& picture,
                 const OverlayOptions& options) {
  if (circles.size() < 3)
    throw refusal("there are {} grains to register with the picture; three are needed", circles.size());
  Overlay found{first, 0, 0, 0, 0};
  search(circles, picture, options, found);
  for (int round = 0; round < rounds; ++round) refine(circles, picture, found);
  found.shift_error = found.rms / std::sqrt(static_cast<double>(circles.size()));
  const PictureGrains at = apply(found.transform, circles);
  const Vec2 middle = mean_point(at.centre);
  double squares = 0;
  for (const Vec2 centre : at.centre) squares += dot(centre - middle, centre - middle);
  found.turn_error = squares > 0 ? found.rms / std::sqrt(squares) : 0;
  return found;
}

}  // namespace arenite::imaging

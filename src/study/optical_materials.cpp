#include "study/optical_materials.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numeric>

#include "core/error.hpp"
#include "io/image.hpp"
#include "statistics/clusters.hpp"

namespace arenite::study {
namespace {

/// How the film's pixels lie in the optical picture.
struct Overlay {
  const Image& image;
  double finer;                     ///< pixels of the picture along one of the film
  double middle_column, middle_row; ///< of the film

  /// Mean and variance of the inner half (by area) of a grain; variance -1 outside the picture.
  std::pair<double, double> look(const PictureGrains& grains, std::size_t i, double shift_x, double shift_y) const {
    const double x = 0.5 * (image.width - 1) + (grains.x[i] + shift_x - middle_column) * finer;
    const double y = 0.5 * (image.height - 1) + (grains.y[i] + shift_y - middle_row) * finer;
    const double inner = std::sqrt(0.5) * grains.radius[i] * finer;
    double n = 0, sum = 0, squares = 0;
    for (int r = static_cast<int>(std::ceil(y - inner)); r <= y + inner; ++r) {
      for (int c = static_cast<int>(std::ceil(x - inner)); c <= x + inner; ++c) {
        if (std::hypot(c - x, r - y) > inner || c < 0 || r < 0 || c >= image.width || r >= image.height) continue;
        const double v = image.value[image.index(c, r)];
        ++n, sum += v, squares += v * v;
      }
    }
    if (n < 1) return {0, -1};
    return {sum / n, std::max(0.0, squares / n - sum * sum / n / n)};
  }

  double unevenness(const PictureGrains& grains, double shift_x, double shift_y) const {
    double sum = 0;
    for (std::size_t i = 0; i < grains.size(); ++i) sum += std::max(0.0, look(grains, i, shift_x, shift_y).second);
    return sum;
  }
};

/// The shift of least unevenness within `reach` film pixels of (x, y), on a grid of `step`.
void search(const Overlay& overlay, const PictureGrains& grains, double reach, double step, double& x, double& y) {
  double best = overlay.unevenness(grains, x, y);
  const double x0 = x, y0 = y;
  for (double dy = -reach; dy <= reach + 1e-9; dy += step) {
    for (double dx = -reach; dx <= reach + 1e-9; dx += step) {
      const double here = overlay.unevenness(grains, x0 + dx, y0 + dy);
      if (here < best) best = here, x = x0 + dx, y = y0 + dy;
    }
  }
}

}  // namespace

std::vector<std::int32_t> by_brightness(const std::vector<FilmMaterial>& materials) {
  std::vector<std::int32_t> order(materials.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](std::int32_t a, std::int32_t b) {
    return materials[static_cast<std::size_t>(a)].brightness < materials[static_cast<std::size_t>(b)].brightness;
  });
  return order;
}

void take_optical_materials(const FilmRecipe& recipe, int film_width, int film_height, PictureGrains& grains, std::vector<std::string>& notes) {
  const auto file = std::filesystem::path(recipe.source_file).parent_path() / recipe.picture.optical;
  const Image image = io::read_image(file);
  const double fine = recipe.picture.optical_pixel > 0 ? recipe.picture.optical_pixel : recipe.picture.pixel;
  const Overlay overlay{image, recipe.picture.pixel / fine, 0.5 * (film_width - 1), 0.5 * (film_height - 1)};
  double x = 0, y = 0;
  search(overlay, grains, 2, 0.5, x, y);
  search(overlay, grains, 0.4, 0.1, x, y);
  std::vector<double> brightness;
  for (std::size_t i = 0; i < grains.size(); ++i) brightness.push_back(overlay.look(grains, i, x, y).first);
  statistics::ClusterOptions options;
  options.most = recipe.materials.size();
  const auto classes = statistics::cluster(brightness, options);
  if (classes.size() != recipe.materials.size())
    throw InputError(file.string(), 0, fmt::format("shows grains of {} {} of brightness where the recipe has {} materials; give a list of the grains (picture.grains)",
                                                   classes.size(), classes.size() == 1 ? "kind" : "kinds", recipe.materials.size()));
  const auto order = by_brightness(recipe.materials);
  grains.material.clear();
  for (const auto k : classes.of) grains.material.push_back(order[static_cast<std::size_t>(k)]);
  grains.brightness = std::move(brightness);
  notes.push_back(fmt::format("the optical picture lies {:.1f} pixels to the right of the film and {:.1f} below it", x, y));
}

}  // namespace arenite::study

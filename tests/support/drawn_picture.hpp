#pragma once
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string>
#include <vector>

#include "core/random.hpp"
#include "geometry/union_area.hpp"
#include "io/disk/file.hpp"
#include "io/sample/formats.hpp"
#include "io/sample/layout.hpp"
#include "model/image.hpp"
#include "thermal/imaging/blur.hpp"

/// Pictures of disks whose truth is known: every pixel holds the exact share that disks cover.
namespace arenite::test {

struct DrawnDisk {
  double x = 0, y = 0, radius = 0;  ///< pixels, y down
  double level = 1;
  int material = 0;
};

struct Drawing {
  int width = 320, height = 240;
  double background = 0, blur = 0.5, noise = 0;  ///< level, pixels, level
  double slope = 0;                              ///< light falls off by this share from the left to the right edge
  std::uint64_t seed = 1;
};

/// Grains of a packing kept in tests/data/packings as a camera with pixels of this width (m) sees them; "POM" is
/// material 0.
inline std::vector<DrawnDisk> packing_in_pixels(const std::string& name, double pixel, double left, double floor_row) {
  const std::filesystem::path path =
      std::filesystem::path(ARENITE_SOURCE_DIR) / "tests/data/packings" / (name + ".csv");
  Problems problems(path.string());
  const std::string text = io::read_file(path);
  std::vector<DrawnDisk> disks;
  const io::SampleOptions options;
  io::RawGrains grains = io::samples::csv.grains({text, 0, options, problems});
  io::lay_out(grains, 2, problems);
  for (const io::RawGrain& row : grains.rows)
    disks.push_back({left + row.place.x / pixel, floor_row - row.place.y / pixel, row.radius / pixel, 1,
                     row.material == "POM" ? 0 : 1});
  problems.raise();
  return disks;
}

inline FloatImage draw(const std::vector<DrawnDisk>& disks, const Drawing& how) {
  FloatImage covered{how.width, how.height, {}};
  covered.value.assign(covered.size(), 0.0F);
  FloatImage image = covered;
  for (const DrawnDisk& d : disks) {
    const int reach = static_cast<int>(std::ceil(d.radius)) + 1;
    const int cx = static_cast<int>(std::lround(d.x)), cy = static_cast<int>(std::lround(d.y));
    for (int y = std::max(0, cy - reach); y <= std::min(how.height - 1, cy + reach); ++y)
      for (int x = std::max(0, cx - reach); x <= std::min(how.width - 1, cx + reach); ++x) {
        const double area = geometry::disk_window_area({d.x, d.y}, d.radius, {x - 0.5, x + 0.5, y - 0.5, y + 0.5});
        covered.value[covered.index(x, y)] += static_cast<float>(area);
        image.value[image.index(x, y)] += static_cast<float>(area * d.level);
      }
  }
  for (std::size_t i = 0; i < image.size(); ++i) {
    const float over = std::max(1.0F, covered.value[i]);  // overlaps count once
    image.value[i] = image.value[i] / over + std::max(0.0F, 1 - covered.value[i]) * static_cast<float>(how.background);
    image.value[i] *=
        static_cast<float>(1 - how.slope * static_cast<double>(i % static_cast<std::size_t>(how.width)) / how.width);
  }
  image = imaging::blurred(image, how.blur);
  RandomStream random(how.seed, Purpose::test);
  for (float& v : image.value) v += static_cast<float>(how.noise * random.normal());
  return image;
}

}  // namespace arenite::test

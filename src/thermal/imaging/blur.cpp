#include "thermal/imaging/blur.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "core/median.hpp"
#include "thermal/optics/lens.hpp"

namespace arenite::imaging {
namespace {

/// to[x] += sum over k of kernel[k] from[x + k].
void add_weighted(const std::vector<float>& kernel, const float* from, float* to, int n) {
  for (std::size_t k = 0; k < kernel.size(); ++k) {
    const float weight = kernel[k];
    for (int x = 0; x < n; ++x) to[x] += weight * from[static_cast<std::size_t>(x) + k];
  }
}

/// The open pixels of a picture so many times smaller, with those beside them.
Mask widened(const Mask& open, int width, int height, int times) {
  Mask wide{width, height, std::vector<char>(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), 0)};
  for (int y = 0; y < open.height; ++y)
    for (int x = 0; x < open.width; ++x)
      if (open.value[open.index(x, y)] != 0)
        each_pixel_near({1.0 * (x / times), 1.0 * (y / times)}, 1, width, height,
                        [&](int, int, std::size_t at) { wide.value[at] = 1; });
  return wide;
}

}  // namespace

FloatImage blurred(const FloatImage& image, double sigma) {
  if (!(sigma > 0)) return image;
  const std::vector<float> kernel = optics::make_lens(sigma, 1, 3.5).taps;
  const int reach = static_cast<int>(kernel.size() / 2), w = image.width, h = image.height;
  FloatImage rows{w, h, std::vector<float>(image.size())}, result = rows;
  std::vector<float> row(static_cast<std::size_t>(w + 2 * reach));  // continued by its ends
  for (int y = 0; y < h; ++y) {
    const float* from = image.value.data() + image.index(0, y);
    for (int x = 0; x < w + 2 * reach; ++x) row[static_cast<std::size_t>(x)] = from[std::clamp(x - reach, 0, w - 1)];
    add_weighted(kernel, row.data(), rows.value.data() + rows.index(0, y), w);
  }
  for (int y = 0; y < h; ++y)
    for (int i = -reach; i <= reach; ++i) {
      const float k = kernel[static_cast<std::size_t>(i + reach)];
      const float* from = rows.value.data() + rows.index(0, std::clamp(y + i, 0, h - 1));
      float* to = result.value.data() + result.index(0, y);
      for (int x = 0; x < w; ++x) to[x] += k * from[x];
    }
  return result;
}

FloatImage halved(const FloatImage& image) {
  FloatImage half{image.width / 2, image.height / 2, {}};
  half.value.resize(half.size());
  for (int y = 0; y < half.height; ++y)
    for (int x = 0; x < half.width; ++x) {
      const float* a = image.value.data() + image.index(2 * x, 2 * y);
      const float* b = a + image.width;
      half.value[half.index(x, y)] = 0.25F * (a[0] + a[1] + b[0] + b[1]);
    }
  return half;
}

double noise_level(const FloatImage& image) {
  std::vector<float> size;
  for (int y = 0; y + 2 < image.height; ++y)
    for (int x = 0; x + 2 < image.width; ++x) {
      const float* a = image.value.data() + image.index(x, y);
      const float* b = a + image.width;
      const float* c = b + image.width;
      size.push_back(std::abs(a[0] - 2 * a[1] + a[2] - 2 * (b[0] - 2 * b[1] + b[2]) + c[0] - 2 * c[1] + c[2]));
    }
  return median(std::move(size)) / (6 * median_of_normal_size);  // 6: the weights' root sum of squares
}

std::vector<Run> runs_of(const Mask& open) {
  const Mask wanted = widened(open, open.width, open.height, 1);
  std::vector<Run> runs;
  for (int y = 0; y < open.height; ++y)
    for (int x = 0; x < open.width; ++x) {
      if (wanted.value[open.index(x, y)] == 0) continue;
      if (!runs.empty() && runs.back().y == y && runs.back().last == x - 1) runs.back().last = x;
      else runs.push_back({y, x, x});
    }
  return runs;
}

Mask halved_open(const Mask& open) { return widened(open, open.width / 2, open.height / 2, 2); }

}  // namespace arenite::imaging

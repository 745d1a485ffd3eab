#include "thermal/optics/lens.hpp"

namespace arenite::optics {

Lens make_lens(double blur, int fine, double reach) {
  const double sigma = blur * fine;
  Lens lens{fine, static_cast<int>(std::ceil(reach * sigma)), {}};
  std::vector<double> taps(static_cast<std::size_t>(2 * lens.margin + fine), 0.0);
  double sum = 0;
  for (int point = 0; point < fine; ++point)
    for (int k = -lens.margin; k <= lens.margin; ++k) {
      const double g = sigma > 0 ? std::exp(-0.5 * k * k / (sigma * sigma)) : 1.0;
      taps[static_cast<std::size_t>(point + k + lens.margin)] += g;
      sum += g;
    }
  for (const double t : taps) lens.taps.push_back(static_cast<float>(t / sum));
  return lens;
}

Canvas::Canvas(const Lens& lens, int pixels_across, int pixels_down, Vec2 middle, Vec2 from_point_to_point)
    : width(pixels_across * lens.fine + 2 * lens.margin),
      height(pixels_down * lens.fine + 2 * lens.margin),
      first{middle.x - 0.5 * (width - 1) * from_point_to_point.x,
            middle.y - 0.5 * (height - 1) * from_point_to_point.y},
      step(from_point_to_point),
      light(static_cast<std::size_t>(width) * static_cast<std::size_t>(height)) {}

std::vector<float> through_lens(const Lens& lens, const std::vector<float>& scene, int width, int height) {
  const std::ptrdiff_t across = static_cast<std::ptrdiff_t>(width) * lens.fine + 2 * lens.margin;
  const std::ptrdiff_t down = static_cast<std::ptrdiff_t>(height) * lens.fine + 2 * lens.margin;
  std::vector<float> rows(static_cast<std::size_t>(down * width));
  for (std::ptrdiff_t r = 0; r < down; ++r)
    for (int c = 0; c < width; ++c) {
      const float* at = scene.data() + r * across + static_cast<std::ptrdiff_t>(c) * lens.fine;
      float sum = 0;
      for (std::size_t k = 0; k < lens.taps.size(); ++k) sum += lens.taps[k] * at[k];
      rows[static_cast<std::size_t>(r * width + c)] = sum;
    }
  std::vector<float> picture(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), 0.0f);
  for (int r = 0; r < height; ++r) {
    float* out = picture.data() + static_cast<std::ptrdiff_t>(r) * width;
    for (std::size_t k = 0; k < lens.taps.size(); ++k) {
      const float* in =
          rows.data() + (static_cast<std::ptrdiff_t>(r) * lens.fine + static_cast<std::ptrdiff_t>(k)) * width;
      for (int c = 0; c < width; ++c) out[c] += lens.taps[k] * in[c];
    }
  }
  return picture;
}

}  // namespace arenite::optics

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "report/found_grains.hpp"

namespace arenite::report {
namespace {

using Colour = std::array<std::uint8_t, 3>;
constexpr std::array<Colour, 5> colours{Colour{230, 85, 13}, Colour{0, 150, 220}, Colour{60, 170, 60}, Colour{200, 60, 180}, Colour{220, 190, 0}};

/// Grey values from the darkest to the brightest hundredth, so that a hot pixel does not blacken the rest.
std::pair<float, float> shown_range(const FloatImage& picture) {
  std::vector<float> sorted = picture.value;
  const std::size_t n = sorted.size(), low = n / 200, high = n - 1 - n / 200;
  std::nth_element(sorted.begin(), sorted.begin() + static_cast<std::ptrdiff_t>(low), sorted.end());
  const float least = sorted[low];
  std::nth_element(sorted.begin(), sorted.begin() + static_cast<std::ptrdiff_t>(high), sorted.end());
  return {least, std::max(sorted[high], std::nextafter(least, INFINITY))};
}

void draw_circle(io::ColourPicture& out, Vec2 centre, double radius, const Colour& colour) {
  const int steps = std::max(16, static_cast<int>(4 * std::numbers::pi * radius));
  for (int k = 0; k < steps; ++k) {
    const double a = 2 * std::numbers::pi * k / steps;
    const auto x = std::lround(centre.x + radius * std::cos(a)), y = std::lround(centre.y + radius * std::sin(a));
    if (x < 0 || y < 0 || x >= out.width || y >= out.height) continue;
    std::copy(colour.begin(), colour.end(), out.rgb.begin() + 3 * (y * out.width + x));
  }
}

}  // namespace

io::ColourPicture grains_overlay(const FloatImage& picture, const PictureGrains& grains) {
  const int times = std::clamp(1280 / std::max(1, picture.width), 1, 4);
  io::ColourPicture out{times * picture.width, times * picture.height, {}};
  const auto [low, high] = shown_range(picture);
  out.rgb.reserve(3 * static_cast<std::size_t>(out.width) * static_cast<std::size_t>(out.height));
  for (int y = 0; y < out.height; ++y)
    for (int x = 0; x < out.width; ++x) {
      const float share = std::clamp((picture.value[picture.index(x / times, y / times)] - low) / (high - low), 0.0F, 1.0F);
      out.rgb.insert(out.rgb.end(), 3, static_cast<std::uint8_t>(std::lround(255 * share)));
    }
  for (std::size_t k = 0; k < grains.size(); ++k) {
    const auto colour = static_cast<std::size_t>(std::max(0, grains.material[k])) % colours.size();
    draw_circle(out, {(grains.x[k] + 0.5) * times - 0.5, (grains.y[k] + 0.5) * times - 0.5}, grains.radius[k] * times, colours[colour]);
  }
  return out;
}

}  // namespace arenite::report

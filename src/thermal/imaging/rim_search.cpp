#include "thermal/imaging/rim_search.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/ranks.hpp"
#include "thermal/imaging/blur.hpp"

namespace arenite::imaging {
namespace {

constexpr double step = 1.05, coarse = 8;  // ratio of radii; radius from which half the pixels suffice, pixels
constexpr double half_width = 0.7;         // of the ring, pixels
constexpr float texture = 0.3F;            // share of the clear edges' slope that a weak edge is held against, too
constexpr float most_against = -0.3F;      // what an edge of the wrong sign takes off

/// Slope of a picture, by central differences; zero on its border.
struct Slope {
  FloatImage x, y, square;
};

Slope slope_of(const FloatImage& image, bool bright) {
  FloatImage zero{image.width, image.height, std::vector<float>(image.size())};
  Slope slope{zero, zero, zero};
  const float factor = bright ? -0.5F : 0.5F;  // uphill to the centre counts as positive outward fall
  for (int y = 1; y + 1 < image.height; ++y)
    for (int x = 1; x + 1 < image.width; ++x) {
      const std::size_t at = image.index(x, y);
      const float gx = factor * (image.value[at + 1] - image.value[at - 1]);
      const float gy = factor * (image.value[at + static_cast<std::size_t>(image.width)] -
                                 image.value[at - static_cast<std::size_t>(image.width)]);
      slope.x.value[at] = gx;
      slope.y.value[at] = gy;
      slope.square.value[at] = gx * gx + gy * gy;
    }
  return slope;
}

/// Slope that counts as none: of the noise, and a share of what one pixel in a hundred exceeds, the picture's clear
/// edges.
float no_slope(const FloatImage& image, const Slope& slope) {
  const float clear = of_rank(slope.square.value, slope.square.value.size() * 99 / 100);
  return static_cast<float>(noise_level(image)) + texture * std::sqrt(clear) + 1e-30F;
}

struct RingPixel {
  int x, y;
  float ux, uy, weight;
};

std::vector<RingPixel> ring_of(double radius) {
  constexpr double far = 2.45 * half_width;  // beyond it the weight is below 0.05
  const double outer = radius + far, inner = std::max(0.0, radius - far);
  const auto chord = [](double r, int j) { return static_cast<int>(std::sqrt(std::max(0.0, r * r - 1.0 * j * j))); };
  const int reach = static_cast<int>(outer);
  std::vector<RingPixel> ring;
  double sum = 0;
  for (int j = -reach; j <= reach; ++j) {
    const int end = chord(outer, j), hole = std::abs(j) < inner ? chord(inner, j) : 0;
    for (int i = -end; i <= end; ++i) {
      if (i > -hole && i < hole) i = hole;
      const double q = std::sqrt(1.0 * i * i + 1.0 * j * j), away = (q - radius) / half_width,
                   weight = std::exp(-0.5 * away * away);
      if (weight < 0.05 || q == 0) continue;
      ring.push_back({i, j, static_cast<float>(i / q), static_cast<float>(j / q), static_cast<float>(weight)});
      sum += weight;
    }
  }
  for (RingPixel& pixel : ring) pixel.weight /= static_cast<float>(sum);
  return ring;
}

/// What a pixel's slope along the normal says of a rim. Only as such a choice of values, and with -fno-trapping-math,
/// does the compiler take several pixels of a row at a time, which is where a search spends its time.
inline float edge_share(float along) {
  const float least = along > most_against ? along : most_against;
  return least < 1.0F ? least : 1.0F;
}

FloatImage scores_at(const Slope& slope, double radius, float noise, const std::vector<Run>& runs) {
  const std::vector<RingPixel> ring = ring_of(radius);
  const int w = slope.x.width, h = slope.x.height;
  FloatImage usual = blurred(slope.square, 1.5 * radius), score{w, h, std::vector<float>(slope.x.size())};
  for (float& v : usual.value) v = 1 / (1.5F * std::sqrt(v) + noise);
  for (const Run& run : runs) {
    float* sum = score.value.data() + score.index(0, run.y);
    const float* scale = usual.value.data() + usual.index(0, run.y);
    for (const RingPixel& pixel : ring) {
      if (run.y + pixel.y < 0 || run.y + pixel.y >= h) continue;  // no slope outside the picture
      const std::size_t row = slope.x.index(0, run.y + pixel.y);
      const float *gx = slope.x.value.data() + row, *gy = slope.y.value.data() + row;
      const int from = std::max(run.first, -pixel.x), to = std::min(run.last + 1, w - pixel.x);
      const float ux = pixel.ux, uy = pixel.uy, weight = pixel.weight;
      for (int x = from; x < to; ++x)
        sum[x] += weight * edge_share((gx[x + pixel.x] * ux + gy[x + pixel.x] * uy) * scale[x]);
    }
  }
  return score;
}

/// The score of one circle, its centre on a pixel; -1 if that lies outside.
float score_of(const Slope& slope, const FloatImage& square, int x, int y, const std::vector<RingPixel>& ring,
               float noise) {
  if (x < 0 || y < 0 || x >= slope.x.width || y >= slope.x.height) return -1;
  const float scale = 1 / (1.5F * std::sqrt(square.value[square.index(x, y)]) + noise);
  float sum = 0;
  for (const RingPixel& pixel : ring) {
    const int px = x + pixel.x, py = y + pixel.y;
    if (px < 0 || py < 0 || px >= slope.x.width || py >= slope.x.height) continue;
    const std::size_t at = slope.x.index(px, py);
    sum += pixel.weight * edge_share((slope.x.value[at] * pixel.ux + slope.y.value[at] * pixel.uy) * scale);
  }
  return sum;
}

/// Climbs from a circle to the best one nearby, a pixel or half a pixel of radius at a time.
void climb(const Slope& slope, const FloatImage& square, float noise, int& x, int& y, double& radius) {
  struct Move {
    int x, y;
    double radius;
  };
  constexpr Move moves[] = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 0.5}, {0, 0, -0.5}};
  std::vector<RingPixel> ring = ring_of(radius);
  float best = score_of(slope, square, x, y, ring, noise);
  for (int i = 0, failed = 0; i < 60 && failed < 6; ++i, ++failed) {
    const Move& to = moves[i % 6];
    std::vector<RingPixel> there = to.radius != 0 ? ring_of(radius + to.radius) : ring;
    const float score = score_of(slope, square, x + to.x, y + to.y, there, noise);
    if (score <= best) continue;
    failed = -1;
    best = score;
    x += to.x, y += to.y, radius += to.radius;
    ring = std::move(there);
  }
}

bool is_summit(const FloatImage& before, const FloatImage& here, const FloatImage& after, int x, int y) {
  const float v = here.value[here.index(x, y)];
  for (int j = -1; j <= 1; ++j)
    for (int i = -1; i <= 1; ++i) {
      const std::size_t at = here.index(x + i, y + j);
      if (here.value[at] > v || before.value[at] > v || after.value[at] > v) return false;
    }
  return true;
}

/// Summits at one level of the pyramid, whose pixels are `scale` wide.
void search_level(const FloatImage& image, double first, double last, double scale, const Mask& open,
                  const RimOptions& options, std::vector<Circle>& found) {
  const std::vector<Run> runs = runs_of(open);
  const Slope slope = slope_of(image, options.bright);
  const float noise = no_slope(image, slope);
  std::vector<double> radii;
  for (double r = first / step; r < last * step * step; r *= step) radii.push_back(r);
  FloatImage before = scores_at(slope, radii[0], noise, runs), here = scores_at(slope, radii[1], noise, runs);
  for (std::size_t k = 1; k + 1 < radii.size(); ++k) {
    FloatImage after = scores_at(slope, radii[k + 1], noise, runs);
    for (int y = 1; y + 1 < image.height; ++y)
      for (int x = 1; x + 1 < image.width; ++x)
        if (open.value[here.index(x, y)] != 0 && here.value[here.index(x, y)] > static_cast<float>(options.least) &&
            is_summit(before, here, after, x, y))
          found.push_back(
              {{(x + 0.5) * scale - 0.5, (y + 0.5) * scale - 0.5}, radii[k] * scale, here.value[here.index(x, y)]});
    before = std::move(here);
    here = std::move(after);
  }
}

/// Circles found on a coarse picture, moved to where they fit best on one twice as fine.
void refine(const FloatImage& image, double scale, bool bright, std::vector<Circle>& found) {
  const Slope slope = slope_of(image, bright);
  const float noise = no_slope(image, slope);
  FloatImage square = slope.square;
  double blur = 0;
  for (Circle& circle : found) {
    if (circle.radius < coarse * scale) continue;
    if (1.5 * circle.radius / scale > 1.5 * blur || blur == 0)
      square = blurred(slope.square, blur = 1.5 * circle.radius / scale);
    int x = static_cast<int>(std::lround((circle.centre.x + 0.5) / scale - 0.5)),
        y = static_cast<int>(std::lround((circle.centre.y + 0.5) / scale - 0.5));
    double radius = circle.radius / scale;
    climb(slope, square, noise, x, y, radius);
    circle = {{(x + 0.5) * scale - 0.5, (y + 0.5) * scale - 0.5}, radius * scale, circle.score};
  }
}

/// Whether a large circle holds less structure inside than its rim shows; a heap of small grains is no grain.
bool is_plain(const Slope& slope, double noise, const Circle& circle) {
  if (circle.radius < coarse) return true;
  double inside = 0, rim = 0, inside_pixels = 1e-9, rim_pixels = 1e-9;
  const auto squared = [](double r) { return r * r; };
  const double core = squared(0.75 * circle.radius), inner = squared(circle.radius - 1.5),
               outer = squared(circle.radius + 1.5);
  each_pixel_near(circle.centre, circle.radius + 1.5, slope.x.width, slope.x.height, [&](int x, int y, std::size_t at) {
    const double away = squared(x - circle.centre.x) + squared(y - circle.centre.y),
                 square = static_cast<double>(slope.square.value[at]);
    if (away < core) inside += square, ++inside_pixels;
    else if (away > inner && away < outer) rim += square, ++rim_pixels;
  });
  return inside / inside_pixels - noise * noise < 0.5 * (rim / rim_pixels - noise * noise);
}

}  // namespace

std::vector<Circle> search_rims(const FloatImage& image, const RimOptions& options) {
  std::vector<FloatImage> levels{image};
  for (double r = options.largest; r >= coarse && std::min(levels.back().width, levels.back().height) >= 2 * coarse;
       r /= 2)
    levels.push_back(halved(levels.back()));
  std::vector<Circle> found;
  double first = options.smallest;
  std::vector<std::vector<Circle>> of_level(levels.size());
  Mask open = options.open ? *options.open : Mask{image.width, image.height, std::vector<char>(image.size(), 1)};
  for (std::size_t k = 0; k < levels.size(); ++k) {
    if (k > 0) open = halved_open(open);
    const double scale = std::ldexp(1.0, static_cast<int>(k)), last = std::min(options.largest / scale, coarse);
    if (first < last) search_level(levels[k], first, last, scale, open, options, of_level[k]);
    first = std::max(last, first) / 2;
  }
  for (std::size_t k = levels.size(); k-- > 0;) {
    if (k + 1 < levels.size()) refine(levels[k], std::ldexp(1.0, static_cast<int>(k)), options.bright, found);
    found.insert(found.end(), of_level[k].begin(), of_level[k].end());
  }
  const Slope slope = slope_of(image, options.bright);
  const double noise = noise_level(image);
  std::erase_if(found, [&](const Circle& circle) { return !is_plain(slope, noise, circle); });
  std::stable_sort(found.begin(), found.end(), [](const Circle& a, const Circle& b) { return a.score > b.score; });
  return found;
}

}  // namespace arenite::imaging

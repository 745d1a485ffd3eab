#include <cmath>
#include <numbers>
#include <vector>

#include "grains/texture/oscillation.hpp"
#include "grains/texture/view.hpp"
#include "model/shapes.hpp"

namespace arenite::texture {
namespace {

/// exp(2 i theta) of a grain's long axis, as cosine and sine; both 0 for a grain without one.
Vec2 doubled_axis(const Grains& grains, std::size_t g) {
  const Shape shape = shape_of(grains, g);
  const double n = static_cast<double>(shape.place.size());
  Vec2 mean;
  for (const Vec2& p : shape.place) mean += p / n;
  double difference = 0, product = 0, size = 0;
  for (const Vec2& p : shape.place) {
    const Vec2 q = p - mean;
    difference += q.x * q.x - q.y * q.y;
    product += 2 * q.x * q.y;
    size += dot(q, q);
  }
  const double apart = std::hypot(difference, product);
  if (!(apart > 1e-6 * size)) return {};
  const Vec2 by = direction(grains.angle[g]);
  return turned(Vec2{difference, product} / apart, turned(by, by));
}

}  // namespace

/// The fabric of the grains' own directions: the modulus and the phase of <exp(2 i theta)>, by which the tensor <a (x)
/// a> is known. The modulus is half the difference of the principal values of <2 a (x) a>.
void long_axes(const View& view, Texture& texture) {
  const Grains& grains = view.packing.grains;
  if (grains.shapes.empty()) return;
  std::vector<Vec2> axis(grains.size());
  Items longish;
  for (const std::size_t g : view.grains) {
    axis[g] = doubled_axis(grains, g);
    if (axis[g] != Vec2{}) longish.push_back(g);
  }
  if (longish.empty()) return;
  const auto add = [&](std::size_t g, double* sums) {
    sums[0] += axis[g].x;
    sums[1] += axis[g].y;
    sums[2] += 1;
  };
  const auto of_sums = [](const std::vector<double>& s) { return std::vector<double>{s[0] / s[2], s[1] / s[2]}; };
  const auto both = jackknife_of_sums(longish, view.grain_block, 3, add, of_sums);
  const Oscillation order = oscillation(both[0], both[1], 2);
  Numbers& j = texture.numbers["long_axes"];
  put(j, "grains", longish.size(), "", "Grains with a long axis");
  put(j, "noise", 0.886 / std::sqrt(static_cast<double>(longish.size())), "",
      "Order for the same number of random orientations");
  put(j, "order", order.amplitude, "", "|<exp(2 i theta)>| of long axes; 0 at random, 1 all alike");
  put_angle(j, "direction_deg", order.direction_deg, half_turn, "Preferred direction of the long axes, from x");
}

}  // namespace arenite::texture

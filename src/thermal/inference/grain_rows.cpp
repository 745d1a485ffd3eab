#include "thermal/inference/grain_rows.hpp"

#include "thermal/inference/grain_field.hpp"

namespace arenite::inference {
namespace {

/// What a pixel sees of a neighbour, Pa.
double seen_of(const GrainField& field, double radius, Vec2 from_centre, const Footprint& footprint) {
  if (norm(from_centre) >= radius + footprint.reach) return 0;
  double sum = 0;
  for (const Footprint::Point& p : footprint.points) {
    const Vec2 x = from_centre + p.place;
    if (dot(x, x) < radius * radius) sum += p.weight * field.value(x);
  }
  return sum;
}

GrainField field_of(const Placed& placed, std::size_t g) {
  return {placed.radius[g], placed.length, placed.touches[g], placed.force};
}

/// One pixel of the grain itself: a pixel that sees nothing else sees a harmonic field as in its centre. The centre moves
/// by d: a point of the grain is then seen at a place d farther, where the pixel's weight is slope.d larger.
void fill_row(const GrainField& field, double radius, Vec2 x, const Footprint& footprint, double* row, double* turn, Vec2& shift) {
  if (norm(x) + footprint.reach <= radius) {
    field.add(x, 1, row, turn);
    shift = -field.gradient(x);
    return;
  }
  for (const Footprint::Point& p : footprint.points) {
    const Vec2 y = x + p.place;
    if (dot(y, y) < radius * radius) shift += field.add(y, p.weight, row, turn) * p.slope;
  }
}

}  // namespace

GrainRows rows_of_grain(const Placed& placed, std::size_t g, const std::vector<GrainPixel>& pixels, const Footprint& footprint) {
  const GrainField field = field_of(placed, g);
  std::vector<GrainField> others;
  for (const Near& n : placed.near[g]) others.push_back(field_of(placed, n.grain));
  const std::size_t z = field.size();
  const double factor = -placed.factor[g];
  GrainRows rows{std::vector<double>(2 * z * pixels.size()), std::vector<double>(pixels.size()), std::vector<double>(2 * pixels.size()),
                 std::vector<double>(z * pixels.size())};
  for (std::size_t q = 0; q < pixels.size(); ++q) {
    const Vec2 x = pixels[q].place + placed.found[g] - placed.centre[g];
    double *row = &rows.response[2 * z * q], *turn = &rows.turn[z * q];
    Vec2 shift;
    fill_row(field, placed.radius[g], x, footprint, row, turn, shift);
    for (std::size_t k = 0; k < 2 * z; ++k) row[k] *= factor;
    for (std::size_t k = 0; k < z; ++k) turn[k] *= factor;
    rows.shift[2 * q] = factor * shift.x, rows.shift[2 * q + 1] = factor * shift.y;
    for (std::size_t o = 0; o < others.size(); ++o) {
      const Near& n = placed.near[g][o];
      const Vec2 from_other = x + placed.centre[g] - placed.centre[n.grain] - n.cells;
      rows.spill[q] -= placed.factor[n.grain] * seen_of(others[o], placed.radius[n.grain], from_other, footprint);
    }
  }
  return rows;
}

}  // namespace arenite::inference

#pragma once
#include "model/result.hpp"
#include "support/numbers_of.hpp"
#include "support/sample_results.hpp"

namespace arenite::test {

/// A result on a small grid with numbers that distinguish every field from every other: two grains with a bridge
/// between them.
inline FieldResult small_field(int width = 12, int height = 9) {
  FieldResult r;
  r.provenance = {"0.1.0", "tension",  "0123456789abcdef", "title = \"field\"\n",
                  5,       "portable", {{"key", "value"}}, "field"};
  r.name = "tension";
  r.outcome = "equilibrium";
  r.packing = row_of_grains(2);
  r.cement.coating = 1.5e-5;
  r.cement.bridges = {{0, 1, 2e-4, 3e-4}};
  r.cement.menisci = {{1, 0, 4e-4}};
  r.map = make_phase_map(width, height, 25e-6);
  r.map.grain_class = {GrainClass::large, GrainClass::small};
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const auto i = r.map.index(x, y);
      if (x == width / 2) r.map.phase[i] = y == 0 ? Phase::empty : Phase::matrix;
      else r.map.phase[i] = Phase::particle, r.map.grain[i] = x < width / 2 ? 0 : 1;
    }
  StressField& f = r.field;
  f.width = width;
  f.height = height;
  f.dx = r.map.dx;
  double k = 0;
  for (auto* component : {&f.ux, &f.uy, &f.xx, &f.yy, &f.xy})
    for (std::size_t i = 0; i < r.map.size(); ++i) component->push_back(static_cast<float>(1e3 * std::sin(++k)));
  r.convergence.columns = {{"iteration", "1", {0, 1, 2}}, {"residual", "1", {1, 0.1, 1e-7}}};
  r.curve.columns = {{"strain", "1", {1e-4, 2e-4}}, {"stress", "Pa", {10, 20}}};
  r.cracks = {{1e-4f, 2e-4f, 2, 1.5e-4}, {3e-4f, 4e-4f, 1, 2e-4}};
  r.numbers = test::numbers_of("{\"S_m\": 0.5}");
  return r;
}

}  // namespace arenite::test

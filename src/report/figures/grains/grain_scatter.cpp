#include "report/figures/grains/grain_scatter.hpp"

#include <algorithm>
#include <cstddef>
#include <functional>
#include <initializer_list>
#include <iterator>
#include <string>
#include <utility>

#include "grains/texture/grain_quantities.hpp"
#include "report/figures/grains/grain_values.hpp"

namespace arenite::report::figures {
namespace {

constexpr std::size_t most_points = 6000;  // that a drawing holds

/// The first that is not the same of all grains, or else the last.
std::string first_that_differs(const GrainNumbers& numbers, std::initializer_list<const char*> names) {
  const auto* at = std::ranges::find_if(names, [&](const char* name) {
    const std::vector<double> values = numbers(name);
    return std::ranges::adjacent_find(values, std::ranges::not_equal_to{}) != values.end();
  });
  return at == names.end() ? *std::prev(names.end()) : *at;
}

}  // namespace

const Head& grain_scatter_head() {
  static const Head head{
      "grain-scatter", "grain-scatter", "Grains",
      "One point per grain of the state shown, in the colour of its material; a click marks the grain in the picture "
      "and in the table."};
  return head;
}

Drawings grain_scatter(const GrainNumbers& last) {
  Scatter scatter{};
  std::size_t grains = 0;
  for (const texture::GrainQuantity& quantity : texture::grain_quantities()) {
    const std::vector<double> values = last(quantity.name);
    if (values.empty()) continue;
    grains = values.size();
    const Scale scale = scale_of(most_of(values), std::string(quantity.unit));
    scatter.axes.push_back({std::string(quantity.name),
                            std::string(quantity.label),
                            {.label = std::string(quantity.symbol), .unit = scale.unit},
                            scale.factor});
  }
  if (grains < 2) return {};
  scatter.across = first_that_differs(last, {"size", "coordination", "x"});
  scatter.up = first_that_differs(last, {"stress", "pressure", "y"});
  scatter.every = (grains + most_points - 1) / most_points;
  return {{.scatter = std::move(scatter)}};
}

}  // namespace arenite::report::figures

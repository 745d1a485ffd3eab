#include "report/colour_ends.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "statistics/estimate.hpp"
#include "statistics/histogram.hpp"

namespace arenite::report {
namespace {

/// Ends that are no two places part by as much as the value, or 1.
ColourEnds parted(ColourEnds ends) {
  const auto half = [](double end) { return end == 0 ? 0.5 : 0.5 * std::abs(end); };
  return ends.second > ends.first ? ends : ColourEnds{ends.first - half(ends.first), ends.second + half(ends.second)};
}

}  // namespace

ColourEnds ends_of(std::vector<double> values, double share) {
  std::erase_if(values, [](double value) { return !std::isfinite(value); });
  if (values.empty()) return {0, 0};
  const std::vector<double> ends = statistics::exact_quantiles(std::move(values), {share, 1 - share});
  return {ends.front(), ends.back()};
}

template <int D>
ColourEnds ends_of(const fields::CoarseLayerIn<D>& layer, const fields::CoarseFieldsIn<D>& fields,
                   std::vector<double> values) {
  for (std::size_t k = 0; k < values.size(); ++k)
    if (!(fields.solid_fraction[k] > 0)) values[k] = statistics::unknown;
  const auto [low, high] = ends_of(std::move(values), cells_beyond);
  if (layer.colours == ColourScale::diverging) {
    const double most = std::max(std::abs(low), std::abs(high));
    return most > 0 ? ColourEnds{-most, most} : ColourEnds{-1, 1};
  }
  return parted({layer.from_least ? low : std::min(0.0, low), high});
}

template ColourEnds ends_of(const fields::CoarseLayerIn<2>&, const fields::CoarseFieldsIn<2>&, std::vector<double>);
template ColourEnds ends_of(const fields::CoarseLayerIn<3>&, const fields::CoarseFieldsIn<3>&, std::vector<double>);

Numbers numbers_of(const ColourEnds& ends) { return Numbers::list({ends.first, ends.second}); }

}  // namespace arenite::report

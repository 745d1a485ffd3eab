#pragma once
#include <cstddef>
#include <vector>

#include "core/mapped.hpp"
#include "report/figures/figure_document.hpp"
#include "report/number_block.hpp"
#include "report/page.hpp"

namespace arenite::report {

/// Which nodes of a large map the page draws: every `stride`-th in both directions, from the middle of the first block.
/// A map of up to about a million nodes is drawn whole.
struct Thinning {
  int stride = 1;
  int width = 0, height = 0;      ///< nodes that are left
  std::vector<std::size_t> node;  ///< their indices in the map

  explicit Thinning(const PhaseMap& map, std::size_t most = 1'200'000);

  template <class T> std::vector<T> of(const std::vector<T>& values) const {
    if (stride == 1) return values;
    return mapped(node, [&](std::size_t at) { return values[at]; });
  }
};

/// Adds "maps" (every phase map once) and "fields" (one a result) to the page's document. Densities of stresses that
/// are not known are measured as those in the result's numbers were; all components are shown, whichever these name.
void add_fields(Numbers& document, const PageData& data, NumberBlock& block, const figures::WriteList& write);
/// Those densities of a field, as stress::numbers gives them.
Numbers densities_of(const FieldResult& result);

}  // namespace arenite::report

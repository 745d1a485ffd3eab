#pragma once
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "io/sample/sample.hpp"

namespace arenite::io {

/// Places of the columns that a file of contacts needs.
struct PairColumns {
  std::size_t i = 0, j = 0, fx = 0, fy = 0, p1 = 0, p2 = 0;
};

/// Which columns these are, from what they hold, where their names do not say: the two grains are neighbouring columns of whole numbers that are
/// grains; the normal force is the first pair of neighbouring columns along the line between their centres that is not the line itself, the tangential force the first behind it
/// that is across (one place further than fy where a force along z follows). `candidates`: the columns that may be meant, in their order; rows with
/// another number of cells are passed over. Nothing where the numbers do not tell.
std::optional<PairColumns> find_pair_columns(const std::vector<std::vector<std::string_view>>& rows, const std::vector<std::size_t>& candidates,
                                             const RawGrains& grains);

}  // namespace arenite::io

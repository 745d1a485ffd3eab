#pragma once
#include <cstddef>
#include <string_view>
#include <vector>

#include "io/sample/formats.hpp"

namespace arenite::io {

/// Which columns are the two grains and the components of normal and tangential force along the axes of the sample, in
/// this order, of a file of contacts, from what they hold, where their names do not say: the two grains are
/// neighbouring columns of whole numbers that are grains; the normal force are the columns along the line between their
/// centres that are not the line itself, the tangential force the first behind them that is across (one place further
/// than fy where a force along z follows). `candidates`: the columns that may be meant, in their order; rows with
/// another number of cells are passed over. Nothing where the numbers do not tell.
std::vector<std::size_t> find_pair_columns(const std::vector<std::vector<std::string_view>>& rows,
                                           const std::vector<std::size_t>& candidates, const RawGrains& grains);

}  // namespace arenite::io

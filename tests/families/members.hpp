#pragma once
#include <vector>

#include "grains/dem/laws/laws.hpp"

namespace arenite::dem {

/// Members of a family, in the order of their list.
template <class... Law> std::vector<OneOf<Law...>> members(const OneOf<Law...>&) { return {Law{}...}; }

}  // namespace arenite::dem

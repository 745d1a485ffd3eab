#pragma once
#include <cstdint>
#include <vector>

#include "model/packing.hpp"

namespace arenite {

/// Of each grain of a state its place among the grains of another, by their ids; -1 of one that is not there. Grains
/// without a fellow of their id are in one state only: they came in or left between.
std::vector<std::int32_t> places_in(const Grains& other, const Grains& grains);

}  // namespace arenite

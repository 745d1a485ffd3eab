#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/vec.hpp"
#include "model/packing.hpp"

namespace arenite {

/// Of each grain of a state its place among the grains of another, by their ids; -1 of one that is not there. Grains
/// without a fellow of their id are in one state only: they came in or left between.
std::vector<std::int32_t> places_in(const Grains& other, const Grains& grains);

/// Of each of these places the grain whose centre is nearest to it. `others` is not empty.
std::vector<std::size_t> nearest_grains(const std::vector<Vec2>& places, const std::vector<Vec2>& others);

}  // namespace arenite

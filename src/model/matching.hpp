#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/vec.hpp"
#include "model/packing.hpp"

namespace arenite {

/// Of each id its place among others; -1 of one that is not there.
std::vector<std::int32_t> places_in(const std::vector<std::int64_t>& others, const std::vector<std::int64_t>& ids);
/// The same of the grains of two states. Grains without a fellow of their id are in one state only: they came in or
/// left between.
template <int D> std::vector<std::int32_t> places_in(const GrainsIn<D>& other, const GrainsIn<D>& grains) {
  return places_in(other.id, grains.id);
}

/// Of each of these places the grain whose centre is nearest to it. `others` is not empty.
std::vector<std::size_t> nearest_grains(const std::vector<Vec2>& places, const std::vector<Vec2>& others);

}  // namespace arenite

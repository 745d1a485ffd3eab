#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "model/packing.hpp"

namespace arenite::texture {

/// That a side was taken away, or never stood there, and what is told of the box nevertheless; empty where all stand.
template <int D> std::string note_of_sides_away(const DomainIn<D>& domain);

/// Solid fraction of windows of the box's shape with `area_share` of its area, one for each of so many random places in
/// the whole box (T Fig. 3.6b); over the box's sides the places are the same for every packing. Empty where the box is
/// not known.
std::vector<double> window_fractions(const Packing& packing, double area_share, int places, std::uint64_t seed = 1);

}  // namespace arenite::texture

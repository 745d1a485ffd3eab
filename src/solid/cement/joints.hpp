#pragma once
#include <cstddef>
#include <vector>

#include "geometry/close_pairs.hpp"
#include "model/cement.hpp"
#include "model/packing.hpp"

namespace arenite::cement {

/// Pairs of grains with a surface gap of at most `gap`, periodic sides included, sorted.
std::vector<geometry::Pair> joined_pairs(const Packing& packing, double gap);

/// Bridges whose half bases are `half_width` times the radii of their grains (P II.B).
std::vector<Bridge> make_bridges(const Packing& packing, const std::vector<geometry::Pair>& pairs, double half_width);

struct Menisci {
  std::vector<Meniscus> menisci;
  std::size_t ruptured = 0, capped = 0;
};

/// A meniscus of one volume (area, m^2) at every pair. Where it is less than the arcs enclose when they meet in the middle
/// of the gap there is none; where it is more than straight tangents enclose the arcs are straight.
Menisci make_menisci(const Packing& packing, const std::vector<geometry::Pair>& pairs, double volume);

/// The largest volume that a meniscus between two straight tangents holds at any pair, m^2.
double largest_meniscus_volume(const Packing& packing, const std::vector<geometry::Pair>& pairs);

}  // namespace arenite::cement

#pragma once
#include <cstdint>
#include <vector>

#include "model/packing.hpp"

namespace arenite::texture {

/// Windows of the REV study: sizes, and random places of each.
struct RevWindows {
  int sizes = 20, places = 50;
};

/// Solid fraction of windows of growing size and random place (T Fig. 3.6); all arrays have one length.
struct Rev {
  std::vector<double> share;                   ///< of the box's area, in space of its volume
  std::vector<double> mean, deviation, error;  ///< over places; error = standard error of the mean
};

template <int D> struct ViewIn;
template <int D> struct TextureIn;

/// Windows from a twentieth of the box's side to 0.98 of it in equal steps of side, which keep the border (T Fig. 3.6),
/// and show its effect at the largest windows. Large windows overlap and know one sample only: to the error of the
/// finite number of places that of the sample itself is added.
template <int D> void rev(const ViewIn<D>& view, TextureIn<D>& texture);

/// Solid fraction of windows of the box's shape with `area_share` of its area, one for each of so many random places in
/// the whole box (T Fig. 3.6b); over the box's sides the places are the same for every packing. Empty where the box is
/// not known.
std::vector<double> window_fractions(const Packing& packing, double area_share, int places, std::uint64_t seed = 1);

}  // namespace arenite::texture

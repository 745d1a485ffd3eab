#pragma once
#include <cstddef>
#include <vector>

#include "thermal/inference/contact_forces.hpp"
#include "thermal/inference/touching.hpp"

namespace arenite::inference {

/// A pixel that belongs to a grain.
struct GrainPixel {
  Vec2 place;           ///< centre of the pixel, m, seen from the grain's centre as it was found
  float value, error;   ///< K
  double to_contact;    ///< distance from the nearest contact point, m
  std::size_t number;   ///< in the picture
};

/// The pixels of every grain whose centres are farther from the rim than its margin, and from all its contact points than
/// half of theirs (margins in pixels). In a periodic direction images of a grain count, too.
std::vector<std::vector<GrainPixel>> pixels_of_grains(const SwingPicture& picture, const Packing& packing,
                                                      const std::vector<std::vector<Touch>>& touches, double rim_margin, double contact_margin);

}  // namespace arenite::inference

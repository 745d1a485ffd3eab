#pragma once
#include <cstddef>
#include <vector>

#include "core/vec.hpp"
#include "model/grain_motion.hpp"
#include "model/image.hpp"

namespace arenite::thermography {

/// Rim of a grain that another grain's rim is seen beside.
struct OtherRim {
  std::size_t pixel = 0, grain = 0;  ///< of the list, and of the grains
  double away = 0;                   ///< of the pixel from that rim, pixels
  Vec2 outwards;                     ///< unit vector from that grain's centre to the pixel
};

struct RimPixel {
  Vec2 place;        ///< pixels
  Vec2 from_centre;  ///< over the radius
  double inside;     ///< share of the pixel in the grain, over the width of a blurred rim
  double weight;
};

/// Pixels on both sides of a grain's rim that are in no other grain.
struct Rim {
  std::vector<RimPixel> pixels;
  std::vector<OtherRim> others;  ///< blurred rims of neighbours that reach into these pixels
};

/// Share of a pixel in a grain whose rim swings about `out` with an amplitude: its mean, and by how much a unit of the
/// amplitude makes it swing. Amplitudes are not small beside the blur, so that the slope at rest would not do.
struct SwingingShare {
  double mean, slope;

  SwingingShare(double out, double amplitude);
};

/// Of every grain at its mean place, in pictures of this size, those pixels that show where it is: near lines along
/// which the outermost grains end only those that these never reach. `motion` is that found so far.
std::vector<Rim> rims_of(const PictureGrains& grains, const GrainMotion& motion, int width, int height);

}  // namespace arenite::thermography

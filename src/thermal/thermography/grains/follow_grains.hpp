#pragma once
#include <cstdint>
#include <optional>
#include <vector>

#include "model/grain_motion.hpp"
#include "model/image.hpp"
#include "model/lockin_maps.hpp"
#include "thermal/thermography/phase_pictures.hpp"

namespace arenite::thermography {

/// Grains that were not followed: what their motion leaves on their rims is so much that its error is beyond six times
/// the median of all grains, as that of a loose grain which goes another way than its neighbours. 1 for each of these.
std::vector<std::uint8_t> lost_grains(const GrainMotion& motion);

/// Whether rims showed the motion of any grain.
bool is_seen(const GrainMotion& motion);

/// Of every pixel the grain whose rim is furthest out of it, or nearest, for those no further than `beyond` from it; -1
/// for all others. Neighbours may overlap in a picture, but each pixel belongs to one grain.
std::vector<std::int32_t> owners(const PictureGrains& grains, int width, int height, double beyond);

/// Lock-in maps whose pixels inside a grain follow it: the pictures are resampled where the grain is at every phase,
/// and mean, amplitude and second harmonic fitted anew. Rims are too sharp for pixels to be resampled beside them: a
/// drawing of even disks before an even background, seen through a lens of this `blur` (standard deviation, pixels), is
/// taken off before and the grain's own mean added after. `grains` are at their mean places; `shown` are the same
/// grains where the maps are to show them, there or, say, where they are at the largest load. Of pixels in no grain
/// mean and drift stay, amplitudes have no value. The reference phase is found anew on the inner pixels of grains
/// unless `reference_phase` gives it. Standard errors are those of a resting pixel.
LockinMaps follow_grains(const PhasePictures& pictures, const LockinMaps& maps, const PictureGrains& grains,
                         const GrainMotion& motion, const PictureGrains& shown, int threads,
                         std::optional<double> reference_phase = {}, double blur = 0.5);

/// Standard deviation of a Gaussian lens, pixels, with which a drawing of even disks comes nearest to the rims of one
/// of the pictures: the film's own word on its blur. `grains` are at their mean places. No number without grains.
double rim_blur(const PhasePictures& pictures, const PictureGrains& grains, const GrainMotion& motion, int threads);

}  // namespace arenite::thermography

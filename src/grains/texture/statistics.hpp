#pragma once
#include "grains/texture/texture.hpp"
#include "grains/texture/view.hpp"

namespace arenite::texture {

// One function a statistic, one file a function. Each fills its own part of the texture; what it cannot compute it
// leaves unknown, with a note that says why.
void measure_grain_stress(const View& view, Texture& texture);
void measure_solid_fraction(const View& view, Texture& texture);
void measure_rev(const View& view, Texture& texture);
void measure_coordination(const View& view, Texture& texture);
void measure_fabric(const View& view, Texture& texture);
void measure_threshold(const View& view, Texture& texture);
void measure_forces(const View& view, Texture& texture);
void measure_stress(const View& view, Texture& texture);
void measure_sigma_norm(const View& view, Texture& texture);
void measure_local_order(const View& view, Texture& texture);
void measure_quality(const View& view, Texture& texture);

}  // namespace arenite::texture

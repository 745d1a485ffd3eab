#pragma once
#include <cstdint>
#include <vector>

#include "model/image.hpp"
#include "thermal/camera/camera.hpp"
#include "thermal/camera/scene.hpp"

namespace arenite::camera {

/// The picture of the scene at load fraction s: photons over those of a black body at the reference, pixel by pixel,
/// from the top. Where emissivities scatter, those of the grains follow from the seed.
std::vector<float> expose(const Scene& scene, const Parameters& parameters, double s, std::uint64_t seed = 1);

/// What the ordinary camera sees of the sample at the smallest load: one grey a material, of `brightness` 0 to 1, half
/// of the way between the grains. Levels from 0 to 1 with noise, rows from the top; as wide and high on the sample as
/// the film.
FloatImage optical_picture(const Scene& scene, const Parameters& parameters, const std::vector<double>& brightness,
                           std::uint64_t seed);

}  // namespace arenite::camera

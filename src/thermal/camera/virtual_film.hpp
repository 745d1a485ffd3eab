#pragma once
#include <cstdint>
#include <memory>
#include <numbers>

#include "model/film.hpp"
#include "thermal/camera/camera.hpp"
#include "thermal/camera/scene.hpp"

namespace arenite::camera {

/// Phase of the load at the first frame of a film, which starts at the smallest load, as a lock-in tells it (largest
/// where it is 0), rad.
inline constexpr double phase_at_first_frame = std::numbers::pi;

/// A film of the scene; frames are drawn when they are read, and the same seed draws the same film.
std::unique_ptr<FilmSource> film(const Scene& scene, const Parameters& parameters, std::uint64_t seed);

/// The same camera (same pattern of gains, offsets and bad pixels) before a black-body reference of that temperature,
/// K.
std::unique_ptr<FilmSource> uniform_film(const Parameters& parameters, double temperature, std::int64_t frames,
                                         std::uint64_t seed);

}  // namespace arenite::camera

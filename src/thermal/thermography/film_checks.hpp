#pragma once
#include <optional>
#include <string>
#include <string_view>

#include "model/lockin_maps.hpp"

/// Whether maps can be those of a load, and what to say where they cannot.
namespace arenite::thermography {

/// Why a film without any change is refused.
inline constexpr const char* without_change =
    "every pixel of the film is constant in time (or not a number) in the single precision in which levels are kept; "
    "give a film of a loaded sample, and subtract a constant first from levels of eight digits and more";

/// What to say of maps that show no load, a film without one or at a wrong frequency; `given_by` is the key or option
/// that gives it.
std::string no_load_sentence(const LockinMaps& maps, double frequency, std::string_view given_by);

/// Adds a sentence to the disturbances of maps that show a load more than a hundredth, and five errors, off the
/// frequency that was given.
void tell_far_frequency(double given, LockinMaps& maps);

/// Throws InputError if the maps hold nothing but noise, or a line of the camera.
void refuse_without_load(const LockinMaps& maps, double given_frequency);

/// When the film itself says that the load is largest, against what the recipe gives, in cycles from -0.5 to 0.5. A
/// signal that heat does not blur is in phase with the load everywhere; of the two ends the film takes that at which
/// pixels warm.
double phase_off(const LockinMaps& maps, double given_cycles);

/// Throws InputError for maps that cannot be those of a load: values that are no temperatures, amplitudes of kelvins.
void refuse_impossible(const LockinMaps& maps);

/// Throws InputError where the phase that is given (rad) is off by an eighth of a cycle or more. Judged where grains
/// have been followed: before that, rims that move past pixels speak louder than the load.
void refuse_wrong_phase(const LockinMaps& maps, std::optional<double> given_phase);

}  // namespace arenite::thermography

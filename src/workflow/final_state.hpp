#pragma once
#include <filesystem>
#include <string>

#include "model/packing.hpp"
#include "statistics/numbers.hpp"
#include "grains/texture/texture.hpp"

namespace arenite::study {

/// The last state of a run, measured as its recipe asks.
struct FinalState {
  Packing packing;
  texture::Texture texture;
};
/// From the file of the run's last stage, or of the `stage` of that name; `rev` says whether the REV study is wanted, which takes
/// longest, and `sectors` into how many directions of contacts are counted. Throws InputError if the run's files are not there,
/// or none is of that stage.
FinalState final_state(const std::filesystem::path& run, bool rev = false, const std::string& stage = "", int sectors = 18);

/// Texture of that state with another strip left out along the walls, in mean diameters; without the REV study.
Numbers texture_with_border(const std::filesystem::path& run, double border);

/// Its texture with histograms and distributions, without values by grain.
Numbers curves_of(FinalState state);

}  // namespace arenite::study

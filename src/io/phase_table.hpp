#pragma once
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "model/image.hpp"
#include "model/phase_map.hpp"

namespace arenite::io {

/// Which phase a value of a picture is.
using PhaseTable = std::map<std::int32_t, Phase>;

/// "0=void,85=particle,170=matrix". Throws InputError for another form, an unknown name, a value given twice.
PhaseTable parse_phase_table(std::string_view text);

/// "void", "matrix" or "particle".
std::string_view name_of(Phase phase);

/// Phase of every pixel, in the picture's order. Without a table (an empty one) a picture of exactly two values is
/// guessed: the lower is void, the higher particle, and `notes` says so. Every other picture without a table, a value
/// that the table lacks, and a picture of one phase only (unless it is particle and `several_grains`) is an InputError
/// that lists the values with their shares.
std::vector<Phase> assign_phases(const Image& image, const PhaseTable& table, bool several_grains, const std::string& file,
                                 std::vector<std::string>& notes);

}  // namespace arenite::io

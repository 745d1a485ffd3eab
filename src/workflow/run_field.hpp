#pragma once
#include <filesystem>
#include <string>

#include "model/field_result.hpp"

namespace arenite::study {

/// The cemented sample of a run, or with `load` the load of that name ("*": its first). Where its file was dropped it is made
/// again from the packing that was kept: the same recipe gives the same bytes, after as long as the load took. Throws InputError
/// for a run without its packing or without such a load.
FieldResult field_of(const std::filesystem::path& run, const std::string& load = "");

}  // namespace arenite::study

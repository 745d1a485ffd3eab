#pragma once
#include <filesystem>
#include <string>

#include "model/field_result.hpp"

namespace arenite::study {

/// The cemented sample of a run, or with `load` the load of that name ("*": its first). Where its file was dropped it is made
/// again from the packing that was kept: the same recipe gives the same bytes. Throws InputError for a run without its packing,
/// without such a load, or whose load is a pull to failure that was dropped.
FieldResult field_of(const std::filesystem::path& run, const std::string& load = "");

}  // namespace arenite::study

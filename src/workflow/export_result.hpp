#pragma once
#include <filesystem>
#include <vector>

#include "io/export/export.hpp"

namespace arenite::workflow {

/// Writes the states of a result (a stage file, a film's result or a run's folder) into `folder`, which is made if its
/// parent exists, and returns the files written. A state that two stages share is written once; `left_out`: files of a
/// run that this format does not hold. Throws InputError for an unreadable result or where writing fails; what was
/// written before is whole.
std::vector<std::filesystem::path> export_result(const std::filesystem::path& result, const io::ExportFormat& format,
                                                 const std::filesystem::path& folder, bool last_only,
                                                 std::vector<std::filesystem::path>* left_out = nullptr);

}  // namespace arenite::workflow

#pragma once
#include <filesystem>
#include <vector>

#include "io/export/export.hpp"
#include "model/film_result.hpp"

namespace arenite::workflow {

/// What texture knows of every grain, as columns for exports: contacts, rattler, sigma_norm, psi6, and with a known
/// length sigma_hyd and the components of sigma (Pa, tension positive).
std::vector<io::GrainField> derived_fields(const Packing& packing);

/// What a film says of every grain: contacts, sigma_norm, and the peak-to-peak sigma_hyd (Pa, tension positive) with its error.
std::vector<io::GrainField> derived_fields(const FilmResult& film);

/// What a film says of every contact beside its forces: their standard errors and the probability that it is there.
std::vector<io::GrainField> fields_of_contacts(const FilmResult& film);

/// The same of the grains of a map: nodes, whole (no node on the edge), centre and, under load, mean stresses.
std::vector<io::GrainField> derived_fields(const FieldResult& result);

/// Writes the states of a result (a stage file, a film's result or a run's folder) into `folder`, which is made if its parent exists, and
/// returns the files written. A state that two stages share is written once. Throws InputError for an unreadable result
/// or where writing fails; what was written before is whole.
std::vector<std::filesystem::path> export_result(const std::filesystem::path& result, const io::ExportFormat& format, const std::filesystem::path& folder,
                                                 bool last_only);

}  // namespace arenite::workflow

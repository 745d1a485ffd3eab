#pragma once
#include <vector>

#include "io/export_frame.hpp"
#include "model/film_result.hpp"

namespace arenite::study {

/// What texture knows of every grain, as columns for exports: contacts, rattler, sigma_norm, psi6, and with a known
/// length sigma_hyd and the components of sigma (Pa, tension positive).
std::vector<io::GrainField> derived_fields(const Packing& packing);

/// What a film says of every grain: contacts, sigma_norm, and the swing of sigma_hyd (Pa, tension positive) with its error.
std::vector<io::GrainField> derived_fields(const FilmResult& film);

/// What a film says of every contact beside its forces: their standard errors and the probability that it is there.
std::vector<io::GrainField> fields_of_contacts(const FilmResult& film);

/// The same of the grains of a map: nodes, whole (no node on the edge), centre and, under load, mean stresses.
std::vector<io::GrainField> derived_fields(const FieldResult& result);

}  // namespace arenite::study

#pragma once
#include <vector>

#include "io/export/export.hpp"
#include "model/film_result.hpp"
#include "model/packing.hpp"
#include "model/result.hpp"

namespace arenite::workflow {

/// What texture knows of every grain; tension is positive.
std::vector<io::GrainField> derived_fields(const Packing& packing);
std::vector<io::GrainField> derived_fields(const PackingIn<3>& packing);
/// What a film says of every grain, peak to peak, with its error.
std::vector<io::GrainField> derived_fields(const FilmResult& film);
/// Of the grains of a map: nodes, whole (no node on the edge), centre and, under load, mean stresses.
std::vector<io::GrainField> derived_fields(const FieldResult& result);

/// What a film says of every contact beside its forces.
std::vector<io::GrainField> fields_of_contacts(const FilmResult& film);

}  // namespace arenite::workflow

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

/// Coarse-grained fields of a state over its whole box, smeared over a mean diameter, two points a diameter; of spheres
/// fewer where they would be more than a million, and smeared over their spacing where that is wider. `shear_rate`,
/// 1/s: of a cell that is sheared. Throws InputError without a box.
template <int D> io::GridFieldsIn<D> grid_fields(const PackingIn<D>& packing, double shear_rate);

}  // namespace arenite::workflow

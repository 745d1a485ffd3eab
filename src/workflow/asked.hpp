#pragma once
#include <filesystem>

#include "io/results/results.hpp"
#include "model/film_result.hpp"
#include "model/result.hpp"
#include "recipe/recipe.hpp"

namespace arenite::workflow {

/// Notes in the result of a stage, 0 the packing, what its recipe asked of it (model/result.hpp), and beside the rows
/// of its history what it drove (grains/fields/driven.hpp).
template <int D> void note_asked(StageResultIn<D>& made, const recipe::Recipe& recipe, std::size_t place);

/// A result as its file has it. One of a version that noted nothing, or no title, gets it now by the recipe in its
/// provenance, which nothing else reads; where that is of another version it stays unknown.
template <int D = 2> StageResultIn<D> read_stage(const std::filesystem::path& path);
FieldResult read_field(const std::filesystem::path& path);
FilmResult read_film_result(const std::filesystem::path& path);
io::AnyResult read_result(const std::filesystem::path& path);

/// Whether a result was made by version 0.1, which named results otherwise: they can be shown and exported, but nothing
/// goes on with them.
bool is_of_version_0_1(const std::filesystem::path& file);

}  // namespace arenite::workflow

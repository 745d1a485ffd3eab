#pragma once
#include <memory>
#include <optional>
#include <vector>

#include "arguments.hpp"
#include "keywords.hpp"
#include "model/film.hpp"
#include "recipe/film_recipe.hpp"

namespace arenite::python {

/// Keywords of a function that opens films: its own, and what films do not say themselves, as [film] of their recipe.
std::vector<Keyword> with_film_keywords(std::vector<Keyword> own = {});

/// Those of a function that has no others, and what a call gives of them.
const Keywords& film_keywords();
recipe::FilmSection film_said(const char* function, const py::kwargs& more);

/// A film of a file, or of an array, which is looked at and not copied; what `said` tells of it, and the `time` (s) of
/// every frame of an array. What a file does not say, or says otherwise than is taken, is warned of.
std::unique_ptr<FilmSource> film_of(const FilmLike& film, const recipe::FilmSection& said = {},
                                    const std::optional<ArrayLike>& time = std::nullopt);

}  // namespace arenite::python

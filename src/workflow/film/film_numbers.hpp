#pragma once
#include "grains/texture/texture.hpp"
#include "model/film_result.hpp"
#include "statistics/numbers.hpp"

namespace arenite::workflow {

/// Texture of a film's grains and contacts, with the stresses that the film gives; `rev` says whether the REV study is
/// wanted, which takes longest.
texture::Texture texture_of(const FilmResult& film, bool rev = true);

/// Statistics of what a film gave, as `arenite film --json` prints them: frequency, noise, grains by material, motion,
/// sigma_norm (by the code that measures simulated packings), contact forces, contact orientations, stresses of grains
/// by source, and how they agree. `texture` is the film's (texture_of), `simulation` that of the companion simulation
/// at the largest load.
Numbers film_numbers(const FilmResult& result, const texture::Texture& texture,
                     const texture::Texture* simulation = nullptr);

}  // namespace arenite::workflow

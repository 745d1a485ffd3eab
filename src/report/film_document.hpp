#pragma once
#include "grains/texture/texture.hpp"
#include "report/figures/figure_document.hpp"
#include "report/number_block.hpp"

namespace arenite::report {

/// Adds a film to "films" of the page's document: maps, grains in pixels, contacts and, where there are any, the
/// stresses of grains beside those of the companion simulation. `texture` is the film's (workflow::texture_of), if it
/// has grains.
void add_film(Numbers& document, const FilmResult& film, const texture::Texture* texture, NumberBlock& block,
              const figures::WriteList& write);

}  // namespace arenite::report

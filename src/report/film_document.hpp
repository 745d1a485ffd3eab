#pragma once
#include <vector>

#include "report/document_parts.hpp"
#include "report/page.hpp"

namespace arenite::report {

/// Adds "films" (one a result) to the page's document: maps, grains in pixels, contacts and, where there are any, the
/// statistics of grain stresses and what relates them to the twin's.
void add_films(Numbers& document, const std::vector<FilmPageData>& films, NumberBlock& block);

}  // namespace arenite::report

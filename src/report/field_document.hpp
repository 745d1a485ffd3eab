#pragma once
#include <vector>

#include "report/document_parts.hpp"
#include "report/page.hpp"

namespace arenite::report {

/// Adds "maps" (every phase map once) and "fields" (one a result) to the page's document.
void add_fields(Numbers& document, const std::vector<FieldPageData>& fields, NumberBlock& block);

}  // namespace arenite::report

#pragma once
#include "validation/checks.hpp"
#include "validation/family.hpp"
#include "validation/results.hpp"

namespace arenite::validation {

Value value_of(const Point& point);

/// Last mean minus first.
Value rise(const Series& points);
/// Slope of a least-squares line through the means, its error from those of the means where all are known, otherwise
/// from their scatter about the line. Needs three points, or two with errors.
Value slope(const Series& points);
/// R^2 of that line.
double line_r2(const Series& points);
/// Rank correlation of x and mean.
double spearman(const Series& points);

/// From each point to the next: "from 2 to 3".
Family steps(const Series& points);
/// Each point against the last, last less it: "10 less 2".
Family leads_of_last(const Series& points);
/// The slope goes this way and no step goes the other way beyond chance.
Check monotone(const std::string& what, const std::string& source, const Series& points, int direction);

}  // namespace arenite::validation

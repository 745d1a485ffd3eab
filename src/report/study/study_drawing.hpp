#pragma once
#include <vector>

#include "report/figures/drawing.hpp"
#include "report/study/study_page.hpp"

namespace arenite::report {

/// What a figure of a study shows of its curves: a panel, outlines of a rose or the cells of a map. Without series
/// where there is nothing to draw.
figures::Drawing drawing_of(const Figure& figure, const std::vector<FigureCurve>& curves,
                            const campaign::CollectedTable& table);

}  // namespace arenite::report

#pragma once
#include "model/result.hpp"
#include "statistics/numbers.hpp"

namespace arenite::report::figures {

/// What the page of a run under way shows of its stage, as figures of a page of figures (study_page.hpp): its grains
/// with their forces now, and its first two figures by the list of a stage's.
Numbers live_figures(const StageResult& now, const Packing* before);

}  // namespace arenite::report::figures

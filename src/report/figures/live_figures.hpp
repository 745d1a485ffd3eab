#pragma once
#include "model/result.hpp"
#include "statistics/numbers.hpp"

namespace arenite::report::figures {

/// What the page of a run under way shows of its stage, as figures of a page of figures (study_page.hpp): its grains
/// with their forces now, and its first two figures by the list of a stage's.
Numbers live_figures(const StageResult& now, const Packing* before);
/// Of spheres "spheres", a state as the page of a result has it, whose arrays lie in "block".
Numbers live_figures(const SphereResult& now);

}  // namespace arenite::report::figures

#pragma once
#include "thermal/inference/contact_forces.hpp"
#include "thermal/inference/grain_pixels.hpp"

namespace arenite::inference {

/// Throws InputError with everything that is wrong with grains, contacts, walls and options; `factors` where those count.
void check_problem(const ForceProblem& problem, const ForceOptions& options, bool factors);

void check_picture(const SwingPicture& picture);

/// Throws InputError for contacts that no pixel of either grain sees.
void check_pixels(const Packing& packing, const std::vector<std::vector<GrainPixel>>& pixels);

}  // namespace arenite::inference

#include "solid/elements/kernels/couple.hpp"
#include "solid/elements/kernels/plane_sweep.hpp"
#include "solid/elements/kernels/space_sweep.hpp"

namespace arenite::elements {

constinit const Compiled<2> avx2_plane = compiled<2, PlaneSweep>();
constinit const Compiled<3> avx2_space = compiled<3, SpaceSweep>();

}  // namespace arenite::elements

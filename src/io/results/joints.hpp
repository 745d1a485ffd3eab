#pragma once
#include "io/results/groups.hpp"

namespace arenite::io {

/// Bonds and pairs that a cohesion joins, of which most packings have none: files without them have no such group.
/// Those of grains that do not exist are refused.
template <int D> void transfer_joints(const Hdf5Group& at, PackingIn<D>& packing);

}  // namespace arenite::io

#pragma once
#include "core/tensor.hpp"
#include "core/vec.hpp"
#include "statistics/numbers.hpp"

namespace arenite::texture::spheres {

/// {{xx, xy, xz}, {yx, ..}, ..}
Numbers rows_of(const Tensor3& tensor);

/// Eigenvalues of the symmetric part, the largest first, with their directions, whose z (else y, else x) is not below
/// 0.
struct Principal {
  Vec3 value;
  Vec3 direction[3];
};
Principal principal(const Tensor3& tensor);

}  // namespace arenite::texture::spheres

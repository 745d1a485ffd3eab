#pragma once
#include <optional>

#include "core/vec.hpp"
#include "grains/dem/stage.hpp"

namespace arenite::fields {

/// Along which a stage compresses its sample, rad from x, to which signed anisotropies refer. Simple shear du_x/dy >
/// 0, of a cell or between walls that slide, compresses along 135 degrees, the opposite along 45; sides that move in
/// compress along their axis, sides that move out leave compression to the other one; else it is the axis along
/// which sides press alone, or under the higher pressure. Of cycles and of what follows a table the way of their
/// beginning counts. Nothing where the stage does none of these, or several at once, so that the sample has to say.
std::optional<double> loading_axis(const dem::Stage& stage);

/// The same in space: a unit vector. Bottom, top, back and front slide along x, left and right along y. Of sides that
/// move out two leave compression to the third axis; one alone leaves it to neither of the others.
std::optional<Vec3> loading_direction(const dem::Stage& stage);

}  // namespace arenite::fields

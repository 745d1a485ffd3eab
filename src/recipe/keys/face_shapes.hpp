#pragma once
#include "core/parameters.hpp"
#include "model/domain.hpp"

namespace arenite::recipe {

struct ContainerParameters;

/// The faces of a boundary in space: by their corners, or as a plate, with an opening perhaps, a cone or a
/// ball.
void declare_faces(ParameterVisitor& visitor, BoundaryIn<3>& boundary, const ContainerParameters& container);

}  // namespace arenite::recipe

#pragma once
#include <array>

#include "model/voxel_map.hpp"
#include "solid/elements/elements.hpp"

namespace arenite::elements {

/// A uniform strain, or a stress: components in Voigt's order, strains of shear doubled.
template <int D> using Voigt = std::array<double, voigt_count<D>>;

/// Displacement and stress in the middle of every pixel or voxel of a map, zero in the void; the stress there is the
/// mean of the element's. `strain` is added to what the displacements of a periodic sample leave.
template <int D>
StressIn<D> element_stress(const MapIn<D>& map, const ElementsIn<D>& elements, const FieldIn<D, double>& u,
                           const Voigt<D>& strain = {});

/// Mean of that stress over the whole sample, void included, Pa; `dx` is the side of an element, m.
template <int D>
Voigt<D> mean_stress(const ElementsIn<D>& elements, const FieldIn<D, double>& u, const Voigt<D>& strain, double dx);

}  // namespace arenite::elements

#pragma once
#include "model/stress_field.hpp"
#include "solid/peridynamics/buffer.hpp"
#include "solid/peridynamics/bonds.hpp"

namespace arenite::peridynamics {

/// Displacements and node stresses sigma_i = 1/(2 V_i) sum f_ij (x) xi_ij, V_i = dx^2 (P II.C), in the map's order,
/// with the linearised stretch or P's.
StressField node_stress(const Bonds& bonds, double dx, const Field<double>& u, bool exact_stretch);

/// f := force of the bonds on every node per unit thickness, N/m, with P's stretch along the turned bond (P eq. 4 and
/// 6).
void exact_force(const Bonds& bonds, double dx, const Field<double>& u, Field<double>& f);

}  // namespace arenite::peridynamics

#pragma once
#include <cstdint>
#include <vector>

#include "solid/peridynamics/kernels/kernels.hpp"

namespace arenite::peridynamics {

/// sum a . a over the nodes of the sample.
template <class T>
double square_norm(const Grid& grid, const Field<T>& a);

/// What residuals are relative to: |f(u)| of the sample strained uniformly between its clamps. (The displaced row alone
/// would give some fifty times more, and a tolerance that says little about stresses.) `u` holds the prescribed
/// displacements, `work` and `f` are overwritten. Zero only where nothing is displaced or no strain leaves a force.
template <class T>
double residual_reference(const Bonds& bonds, const std::vector<std::uint8_t>& prescribed, const Field<double>& u,
                          Field<T>& work, Field<T>& f);

}  // namespace arenite::peridynamics

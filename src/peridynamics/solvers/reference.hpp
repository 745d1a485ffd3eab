#pragma once
#include <cstdint>
#include <vector>

#include "peridynamics/kernels/kernels.hpp"

namespace arenite::peridynamics {

/// sum a . a over the nodes of the sample.
double square_norm(const Grid& grid, const Field<double>& a);

void set_zero(Field<double>& a);

/// What residuals are relative to: |f(u)| with u zero but where it is prescribed. `work` and `f` are overwritten.
double residual_reference(const Bonds& bonds, const std::vector<std::uint8_t>& prescribed, const Field<double>& u, Field<double>& work, Field<double>& f);

}  // namespace arenite::peridynamics

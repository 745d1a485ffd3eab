#pragma once
#include "report/figures/field_figures.hpp"

/// Tests to failure.
namespace arenite::report::figures {

Drawings stress_strain(const FieldData& data);
Drawings broken_bonds(const FieldData& data);
Drawings energy_balance(const FieldData& data);

}  // namespace arenite::report::figures

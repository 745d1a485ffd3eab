#pragma once
#include <string_view>
#include <vector>

#include "core/vec.hpp"
#include "model/phase_map.hpp"

namespace arenite {

/// A number that every node of a loaded sample has, and by its mean stress perhaps every grain: pictures are painted by
/// it, on the page and in print. Its formula (core/formula.hpp) is of the stored ones, by their ids.
struct FieldQuantity {
  std::string_view id, name;  ///< "hydrostatic", as it is chosen on the page; "sigma_hyd", as in files and Python
  std::string_view symbol, unit, formula;
  bool is_offered = true;     ///< where one chooses what is painted
  bool is_magnitude = false;  ///< never below 0, so that no scale is centred

  bool is_stored() const { return formula == id; }
};

/// A stress against that of the whole sample: of "yy" and of "mean", the mean of sigma_yy that its
/// statistics state.
inline constexpr FieldQuantity relative_stress{"relative", "sigma_yy_relative", "\u03c3_{yy}/\u27e8\u03c3_{yy}\u27e9",
                                               "",         "yy mean /",         false};

/// All, in the order of the page; a new one is one more row.
const std::vector<FieldQuantity>& field_quantities();

/// The one of this id or name. Throws InputError for another.
const FieldQuantity& field_quantity(std::string_view name);

/// Whether a field has all that a quantity follows from.
bool has(const StressField& field, const FieldQuantity& quantity);

/// Of every node; nothing where the field has it not.
std::vector<double> values_of(const FieldQuantity& quantity, const StressField& field);
/// By symmetric stresses, as of grains. Throws std::logic_error for a quantity of displacements.
std::vector<double> values_of(const FieldQuantity& quantity, const std::vector<Tensor2>& stresses);

}  // namespace arenite

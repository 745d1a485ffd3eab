#pragma once
#include <string>
#include <vector>

#include "report/figures/drawing.hpp"
#include "report/figures/state_figures.hpp"

/// Distributions of forces and stresses.
namespace arenite::report::figures {

/// Of the stresses of grains.
Drawings grain_stresses(const StateData& state);
/// Of the normal forces of contacts.
Drawings contact_forces(const StateData& state);

/// A distribution of the whole or of a part, and how it is drawn.
struct Set {
  std::string name, colour;
  const Numbers* of = nullptr;
};
/// Survival functions with their exponential tails (T figures 3.12, 6.4), linear and, with `logarithmic`, logarithmic.
Panel survival(const std::vector<Set>& sets, const std::string& x, const std::string& y, bool logarithmic);
/// What each set's tail is: the share at its foot, by this name, and its exponent.
std::vector<KeyEntry> tails_key(const std::vector<Set>& sets, const char* share);

/// Colour of contacts between two materials, "A-B" or "B-A"; of a material.
std::string colour_of_pair(const std::string& key, const std::vector<std::string>& materials);
std::string colour_of_material(std::size_t place);

}  // namespace arenite::report::figures

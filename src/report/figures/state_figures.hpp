#pragma once
#include <string>
#include <vector>

#include "model/packing.hpp"
#include "report/figures/drawing.hpp"

namespace arenite::report::figures {

/// A state of a packing: its texture with curves (texture::numbers), and its materials' names.
struct StateData {
  const Numbers& texture;
  std::vector<std::string> materials;
};

/// Figures of one state, in their order on the page.
const std::vector<Row<StateData>>& state_figures();

/// Those of distributions.
Drawings grain_stresses(const StateData& state);
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

/// The rose of a set of directions; `inner`: of a part of it.
Rose rose_of(std::string name, std::string colour, const Numbers& set, const Numbers* inner = nullptr);

/// Colour of contacts between two materials, "A-B" or "B-A"; of a material.
std::string colour_of_pair(const std::string& key, const std::vector<std::string>& materials);
std::string colour_of_material(std::size_t place);

}  // namespace arenite::report::figures

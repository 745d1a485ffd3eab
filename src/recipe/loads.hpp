#pragma once
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/error.hpp"
#include "core/parameters.hpp"
#include "recipe/cemented.hpp"
#include "solid/elements/options.hpp"
#include "solid/peridynamics/options.hpp"
#include "solid/stress/options.hpp"

/// Loads on a cemented packing or on a map.
namespace arenite::recipe {

struct Recipe;

/// Moduli of the bonds, Pa; what is not given follows P Table I.
struct StiffnessSection {
  double matrix = 1e9;
  std::optional<double> interface, particle;
  bool calibrated = true;
  bool operator==(const StiffnessSection&) const = default;
  peridynamics::Stiffness resolved() const;
};

/// Poisson's ratio of elements; what is not given is as in the lattice, 1/3.
struct PoissonSection {
  double matrix = 1.0 / 3;
  std::optional<double> interface, particle;  ///< as the matrix
  bool operator==(const PoissonSection&) const = default;
};

/// Fracture toughness of the bonds, Pa m^0.5; what is not given follows P Table I.
struct ToughnessSection {
  double matrix = 1e5;
  std::optional<double> interface, particle;
  bool operator==(const ToughnessSection&) const = default;
  peridynamics::Toughness resolved() const;
};

/// Tensile strength of the bonds, Pa: none is given, or the matrix's with what follows from it.
struct StrengthSection {
  std::optional<double> matrix, interface, particle;
  bool operator==(const StrengthSection&) const = default;
  peridynamics::Strength resolved() const;
};

/// What joins the nodes of a sample, and how its field is found: bonds (peridynamics::Method), or elements.
enum class LoadMethod { peridynamics, elements, relaxation, damped };

/// One loading of the cemented sample.
struct Load : peridynamics::LoadCase, peridynamics::FieldChoices, peridynamics::FailureChoices {
  enum class Axis { y, x };
  Load() { max_strain = 0.1; }
  std::string name;
  Axis axis = Axis::y;
  bool moduli = false;               ///< load it along both axes and in shear, too
  bool effective_stiffness = false;  ///< of the sample as a period, by elements
  bool failure = false;              ///< pull until it breaks
  LoadMethod method = LoadMethod::peridynamics;
  elements::Element element = elements::Element::wilson;
  elements::PlaneState plane = elements::PlaneState::stress;
  PoissonSection poisson;
  StiffnessSection stiffness;
  ToughnessSection toughness;
  StrengthSection strength;
  stress::StressOptions statistics;
  bool by_elements() const { return !failure && method == LoadMethod::elements; }
  peridynamics::Method bond_method() const;
  elements::Material material() const;
  /// Sentences on its keys of bonds, which have no effect on elements.
  std::vector<std::string> idle_keys() const;
  /// What keeps it from a sample in space, in a sentence; empty where nothing does.
  std::string not_in_space() const;
  bool operator==(const Load&) const = default;
};

/// Of a load all but its name, which must differ from others.
void declare(ParameterVisitor& visitor, Load& load);
/// All sections of these, and the map.
void declare_field(ParameterVisitor& visitor, Recipe& recipe);

/// The words that a recipe, a command line and Python share for a choice, in the order of its enumeration.
std::vector<Word> words(peridynamics::Loading);
std::vector<Word> words(peridynamics::LowerEdge);
std::vector<Word> words(LoadMethod);
std::vector<Word> words(elements::Element);
std::vector<Word> words(elements::PlaneState);
std::vector<Word> words(Load::Axis);

/// The word for a value.
template <class Enum> std::string word_of(Enum value) {
  return std::string(words(value)[static_cast<std::size_t>(value)].word);
}

/// The value that a word stands for. Throws InputError, which calls the choice `what`, for a word that is not among
/// them.
template <class Enum> Enum chosen(std::string_view word, std::string_view what) {
  const auto known = words(Enum{});
  std::string list;
  for (std::size_t k = 0; k < known.size(); ++k) {
    if (known[k].word == word) return static_cast<Enum>(k);
    list.append(k > 0 ? ", " : "").append(known[k].word);
  }
  throw InputError(std::string(what) + " \"" + std::string(word) + "\" is not known; there are " + list);
}

}  // namespace arenite::recipe

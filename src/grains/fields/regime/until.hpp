#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/units.hpp"
#include "grains/dem/stage.hpp"
#include "model/result.hpp"

namespace arenite::fields {

/// A number of a stage's history or of its curves (loading.hpp) by which the stage may end.
struct HistoryNumber {
  std::string name;
  Dimension dimension;
};

/// Those that such a stage has, in a container with these boundaries: curves first.
std::vector<HistoryNumber> history_numbers(const dem::Stage& stage, const Domain& domain, bool bonded, bool cohesive);

/// Those of a stage of spheres in such a container.
std::vector<HistoryNumber> history_numbers_in_space(const dem::Stage& stage, const DomainIn<3>& domain, bool bonded,
                                                    bool cohesive);

/// A condition that ends a stage: "axial_strain > 20 %", "q < 0.5*max(q)". A number is compared with an expression of
/// numbers, quantities and the largest values so far; "or" joins conditions of which one suffices, "and" those that all
/// must hold. What is to be below its limit must have been as large before: it falls below.
class Until {
 public:
  /// Throws InputError without place for what it cannot read.
  explicit Until(std::string_view text);
  /// Throws InputError without place for a number that is not known, or is compared with another kind of quantity.
  void check(const std::vector<HistoryNumber>& known) const;
  /// What holds in the last row of a history, with the values of its numbers; nothing where nothing does.
  /// `began`, s, is when the stage did, `strains_since` is as in Test, and `sample` any state of it.
  template <int D>
  std::optional<std::string> met(const History& so_far, double began, const dem::Stage& stage,
                                 const PackingIn<D>* strains_since, const PackingIn<D>& sample) const;

 private:
  struct Comparison {
    std::string name;
    bool above = true;
    std::string limit;  ///< as it is evaluated
    std::string text;
  };
  static Comparison comparison_in(std::string_view text);
  std::vector<std::vector<Comparison>> any_;  ///< of which all hold
};

}  // namespace arenite::fields

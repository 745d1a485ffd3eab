#pragma once
#include <optional>
#include <string>
#include <vector>

#include "statistics/measured.hpp"
#include "statistics/numbers.hpp"
#include "statistics/numbers_text.hpp"

namespace arenite::identify {

/// What a source states for the same quantity, SI, and half of the last digit it is printed with.
struct Stated {
  double value = 0, half_digit = 0;
};

/// What is identified, declared once: its name in JSON ("surface_energy"), the unit in which it is shown ("kN/mm"), and
/// what it is.
struct Constant {
  std::string name, unit, sentence;
  double scale() const;  ///< of one such unit, SI
};

/// One identified constant.
struct Finding : Constant {
  statistics::Measured value;  ///< SI
  std::optional<Stated> stated = {};
};

/// True if the value rounds to what is stated.
bool agrees(const Finding& finding);

/// Quantities of one test, of one specimen; or of tests alike: one diameter, one glue, one material.
struct Group {
  std::string name;
  std::size_t count = 0;  ///< of values or points that it rests on; of a test not told
  std::vector<Finding> findings;
  std::vector<Group> tests = {};
};

struct Identification {
  std::string kind, file;  ///< "stiffness", "adhesion", "factor"
  std::vector<Group> groups;
  std::optional<Group> all = {};  ///< over all groups, where that has a meaning
  std::vector<std::string> notes = {};
};

/// Lines "name  value +- error unit (95 %: low to high)", then what each name means.
std::string to_text(const Identification& i);

/// Everything in SI; a quantity is {value, error, confidence_95: [low, high], unit}.
Numbers numbers(const Identification& i);

}  // namespace arenite::identify

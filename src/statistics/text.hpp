#pragma once
#include <string>
#include <utility>
#include <vector>

#include "statistics/estimate.hpp"

/// Statistics as lines of text.
namespace arenite::statistics {

/// "value +- error" with two digits of the error, and the value to the same place. The value alone where the error is
/// not known, or is that of rounding (at most 1e-12 of the value).
std::string with_error(const Estimate& e, double scale = 1);

/// Unit in which stresses of this size are read easily.
struct StressUnit {
  const char* name;
  double scale;
};
StressUnit stress_unit(double size);

/// Rows "name  value", the values in one column, then notes.
class Lines {
 public:
  void put(std::string name, std::string value) { rows_.emplace_back(std::move(name), std::move(value)); }
  /// Left out where it is not known.
  void put(const std::string& name, const Estimate& e, const std::string& unit = "", double scale = 1);
  void note(const std::string& text) { notes_ += "note: " + text + "\n"; }
  std::string text() const;

 private:
  std::vector<std::pair<std::string, std::string>> rows_;
  std::string notes_;
};

}  // namespace arenite::statistics

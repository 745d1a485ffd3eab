#pragma once
#include <string>

#include "statistics/numbers.hpp"

namespace arenite::report {

/// A number of a result as people read it, "0.842 +- 0.003"; empty where it is not known.
std::string shown(const Numbers& number);

/// A tree of numbers as lines "name  value", the values in one column.
class NumberLines {
 public:
  /// The tree must outlive the lines.
  explicit NumberLines(const Numbers& root) : root_(root) {}

  void heading(const std::string& text) { text_ += "\n" + text + "\n"; }
  /// The value at a path such as "/phases/particle", if it is there.
  void add(const std::string& name, const std::string& path, const char* unit = "");
  void raw(const std::string& line) { text_ += line + "\n"; }
  bool has(const std::string& path) const { return root_.at_path(path) != nullptr; }
  std::string text() && { return std::move(text_); }

 private:
  const Numbers& root_;
  std::string text_;
};

}  // namespace arenite::report

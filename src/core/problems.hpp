#pragma once
#include <fmt/format.h>

#include <string>
#include <utility>
#include <vector>

#include "core/error.hpp"

namespace arenite {

/// Collects what is wrong with one input, so that all of it is reported in one pass; beyond `most` only counted.
class Problems {
 public:
  Problems() = default;
  explicit Problems(std::string file) : file_(std::move(file)) {}
  const std::string& file() const { return file_; }

  void add(int line, std::string message) {
    if (++count_ <= most) list_.push_back({file_, line, 0, std::move(message)});
  }
  void add(std::string message) { add(0, std::move(message)); }
  /// Adds a problem without a line if the input is not `good`.
  template <class... T>
  void unless(bool good, fmt::format_string<T...> text, T&&... values) {
    if (!good) add(fmt::format(text, std::forward<T>(values)...));
  }
  bool any() const { return count_ > 0; }
  /// Throws InputError if there is any.
  void raise() {
    if (count_ == 0) return;
    if (count_ > most) list_.push_back({file_, 0, 0, "and " + std::to_string(count_ - most) + " more problems like these"});
    throw InputError(std::move(list_));
  }

 private:
  static constexpr int most = 20;
  std::string file_;
  std::vector<Problem> list_;
  int count_ = 0;
};

}  // namespace arenite

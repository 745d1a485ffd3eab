#pragma once
#include <fmt/format.h>

#include <algorithm>
#include <initializer_list>
#include <iterator>
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
  void raise() { raise({this}); }
  /// The same of several inputs together, in their order.
  static void raise(std::initializer_list<Problems*> inputs) {
    std::vector<Problem> all;
    for (Problems* of : inputs) {
      if (of->count_ > most) of->list_.push_back({of->file_, 0, 0, "and " + std::to_string(of->count_ - most) + " more problems like these"});
      std::move(of->list_.begin(), of->list_.end(), std::back_inserter(all));
    }
    if (!all.empty()) throw InputError(std::move(all));
  }

 private:
  static constexpr int most = 20;
  std::string file_;
  std::vector<Problem> list_;
  int count_ = 0;
};

}  // namespace arenite

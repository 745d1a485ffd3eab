#pragma once
#include <fmt/core.h>

#include <initializer_list>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/error.hpp"

namespace arenite {

/// An error of one sentence that fmt puts together, to be thrown; with the file and line that it is about (line 0:
/// unknown).
template <class... T> InputError refusal(fmt::format_string<T...> sentence, T&&... values) {
  return InputError(fmt::format(sentence, std::forward<T>(values)...));
}
template <class... T>
InputError refusal_at(const std::string& file, int line, fmt::format_string<T...> sentence, T&&... values) {
  return {file, line, fmt::format(sentence, std::forward<T>(values)...)};
}

/// Throws what is wrong with a file, and how to fix it.
template <class... T>
[[noreturn]] void refuse(const std::string& file, fmt::format_string<T...> sentence, T&&... values) {
  throw refusal_at(file, 0, sentence, std::forward<T>(values)...);
}

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
  template <class First, class... T>
  void add(int line, fmt::format_string<First, T...> text, First&& first, T&&... values) {
    add(line, fmt::format(text, std::forward<First>(first), std::forward<T>(values)...));
  }
  template <class First, class... T> void add(fmt::format_string<First, T...> text, First&& first, T&&... values) {
    add(0, fmt::format(text, std::forward<First>(first), std::forward<T>(values)...));
  }
  /// Adds a problem without a line if the input is not `good`.
  template <class... T> void unless(bool good, fmt::format_string<T...> text, T&&... values) {
    if (!good) add(0, fmt::format(text, std::forward<T>(values)...));
  }
  bool any() const { return count_ > 0; }
  /// Throws InputError if there is any.
  void raise() { raise({this}); }
  /// The same of several inputs together, in their order.
  static void raise(std::initializer_list<Problems*> inputs);

 private:
  static constexpr int most = 20;
  std::string file_;
  std::vector<Problem> list_;
  int count_ = 0;
};

/// Number of single-letter insertions, deletions, replacements and swaps of neighbours that turn `a` into `b`.
std::size_t edit_distance(std::string_view a, std::string_view b);

/// The candidate closest to `word` that a typing slip could have meant; empty if none is near. The first of equals.
std::string nearest(std::string_view word, const std::vector<std::string>& candidates);

}  // namespace arenite

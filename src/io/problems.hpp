#pragma once
#include <string>
#include <vector>

#include "core/error.hpp"

namespace arenite::io {

/// Collects what is wrong with one file, so that all of it is reported in one pass; beyond `most` only counted.
class Problems {
 public:
  explicit Problems(std::string file) : file_(std::move(file)) {}
  const std::string& file() const { return file_; }

  void add(int line, std::string message) {
    if (++count_ <= most) list_.push_back({file_, line, 0, std::move(message)});
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

}  // namespace arenite::io

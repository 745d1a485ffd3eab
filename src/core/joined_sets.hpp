#pragma once
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

namespace arenite {

/// Sets of numbers that are joined step by step (union-find with path halving); a set is known by its smallest member.
class JoinedSets {
 public:
  /// The numbers 0 .. n-1, each a set of its own.
  explicit JoinedSets(std::size_t n = 0) { part(n); }
  void part(std::size_t n) {
    parent_.resize(n);
    std::iota(parent_.begin(), parent_.end(), 0);
  }
  /// One number more.
  std::int32_t add() {
    parent_.push_back(static_cast<std::int32_t>(parent_.size()));
    return parent_.back();
  }
  std::int32_t find(std::int32_t i) {
    while (at(i) != i) i = at(i) = at(at(i));
    return i;
  }
  std::int32_t join(std::int32_t a, std::int32_t b) {
    a = find(a);
    b = find(b);
    return a < b ? at(b) = a : at(a) = b;
  }

 private:
  std::int32_t& at(std::int32_t i) { return parent_[static_cast<std::size_t>(i)]; }
  std::vector<std::int32_t> parent_;
};

}  // namespace arenite

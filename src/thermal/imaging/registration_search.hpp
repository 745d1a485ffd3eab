#pragma once
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "thermal/imaging/centre_grid.hpp"
#include "thermal/imaging/registration.hpp"

namespace arenite::imaging {

/// The search of register_circles: transforms from pairs of grains, held against their neighbours, grown over the picture.
class RegistrationSearch {
 public:
  using Pairs = std::vector<std::pair<std::int32_t, std::int32_t>>;

  RegistrationSearch(const PictureGrains& from, const PictureGrains& to, const RegistrationOptions& options);

  /// The transform that speaks for itself best, and its pairs; no pairs where there is none.
  Pairs best(Similarity& transform);
  /// Grains whose places agree under a transform, each once: of two that want one partner the nearer has it.
  Pairs matches(const Similarity& t, std::span<const std::int32_t> of) const;
  Similarity fit(const Pairs& pairs, bool mirrored) const;
  std::vector<std::int32_t> all() const;

 private:
  /// A transform with what it matches, and its score with 12, 24, 48, ... grains around its base.
  struct Candidate {
    Similarity transform;
    Pairs pairs;
    std::vector<double> score;
    double total() const { return score.empty() ? 0 : score.back(); }
  };

  bool alike(double scale, std::size_t a, std::size_t b) const;
  std::int32_t partner(const Similarity& t, std::int32_t a) const;
  double score(const Similarity& t, const Pairs& pairs) const;
  bool same(const Similarity& s, const Similarity& t) const;
  std::vector<std::int32_t> around(Vec2 middle) const;
  std::size_t other_end(std::size_t first) const;
  std::pair<double, double> scales(std::size_t a, std::size_t b) const;
  std::vector<std::size_t> reaches() const;
  void try_base(std::size_t first, Candidate& best) const;
  void grow(Similarity t, const std::vector<std::int32_t>& order, Candidate& best) const;

  const PictureGrains &from_, &to_;
  const RegistrationOptions& options_;
  CentreGrid from_grid_, to_grid_;
};

}  // namespace arenite::imaging

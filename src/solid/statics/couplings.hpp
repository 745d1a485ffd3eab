#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace arenite::statics {

/// The four bilinear hats of a cell at one of its nodes; corners in the order (0,0), (1,0), (0,1), (1,1).
using Hats = double __attribute__((vector_size(32)));

/// Stiffness between the corners of aggregate p and those of aggregate q: [component][corner of p](corner of q), Pa,
/// with the components xx, xy (x of p, y of q), yy, yx.
struct Coupling {
  std::int32_t p, q;
  std::array<std::array<Hats, 4>, 4> block;
};

/// Couplings by the pair that they join.
class CouplingSum {
 public:
  explicit CouplingSum(std::size_t aggregates);
  Coupling& self(std::int32_t p) { return self_[static_cast<std::size_t>(p)]; }
  std::vector<Coupling>& selves() { return self_; }
  std::vector<Coupling>& crosses() { return cross_; }
  /// Of p with q, in this order; added where there is none.
  Coupling& between(std::int32_t p, std::int32_t q);
  /// All: of every aggregate with itself first, in order of aggregates.
  std::vector<Coupling> taken();

 private:
  std::vector<Coupling> self_, cross_;
  std::vector<std::int32_t> latest_, next_;  ///< of each aggregate's couplings, the newest; they form a chain
};

/// Hats at a node, whose place counts from the corner of any cell.
const Hats& hats_at(int x, int y);

}  // namespace arenite::statics

#include "solid/statics/couplings.hpp"

#include <utility>

#include "solid/statics/aggregates.hpp"

namespace arenite::statics {
namespace {

constexpr int cell = Aggregates::cell;

std::array<Hats, cell * cell> make_hats() {
  std::array<Hats, cell * cell> hats;
  for (unsigned y = 0; y < cell; ++y)
    for (unsigned x = 0; x < cell; ++x) {
      const double s = x / static_cast<double>(cell), t = y / static_cast<double>(cell);
      hats[y * cell + x] = Hats{(1 - s) * (1 - t), s * (1 - t), (1 - s) * t, s * t};
    }
  return hats;
}

const std::array<Hats, cell* cell> all_hats = make_hats();

}  // namespace

CouplingSum::CouplingSum(std::size_t aggregates) : self_(aggregates), latest_(aggregates, -1) {
  for (std::size_t k = 0; k < aggregates; ++k) {
    const auto p = static_cast<std::int32_t>(k);
    self_[k] = {p, p, {}};
  }
  cross_.reserve(6 * aggregates);
}

Coupling& CouplingSum::between(std::int32_t p, std::int32_t q) {
  for (std::int32_t c = latest_[p]; c >= 0; c = next_[c])
    if (cross_[c].q == q) return cross_[c];
  next_.push_back(latest_[p]);
  latest_[p] = static_cast<std::int32_t>(cross_.size());
  cross_.push_back({p, q, {}});
  return cross_.back();
}

std::vector<Coupling> CouplingSum::taken() {
  self_.insert(self_.end(), cross_.begin(), cross_.end());
  return std::move(self_);
}

const Hats& hats_at(int x, int y) {
  return all_hats[static_cast<unsigned>((y & (cell - 1)) * cell + (x & (cell - 1)))];
}

}  // namespace arenite::statics

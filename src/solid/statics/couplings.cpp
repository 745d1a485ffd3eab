#include "solid/statics/couplings.hpp"

#include <utility>

#include "solid/statics/aggregates.hpp"

namespace arenite::statics {

template <int D>
CouplingSumIn<D>::CouplingSumIn(std::size_t aggregates, bool with_selves)
    : self_(with_selves ? aggregates : 0),
      latest_(aggregates, -1) {
  for (std::size_t k = 0; k < self_.size(); ++k) {
    const auto p = static_cast<std::int32_t>(k);
    self_[k] = {p, p, {}};
  }
  cross_.reserve(6 * self_.size());
}

template <int D> CouplingIn<D>& CouplingSumIn<D>::between(std::int32_t p, std::int32_t q) {
  for (std::int32_t c = latest_[p]; c >= 0; c = next_[c])
    if (other_[c] == q) return cross_[c];
  other_.push_back(q);
  next_.push_back(latest_[p]);
  latest_[p] = static_cast<std::int32_t>(cross_.size());
  cross_.push_back({p, q, {}});
  return cross_.back();
}

template <int D> void CouplingSumIn<D>::clear() {
  for (auto& self : self_) self.block = {};
  for (const auto& cross : cross_) latest_[cross.p] = -1;
  cross_.clear();
  other_.clear();
  next_.clear();
}

template <int D> std::vector<CouplingIn<D>> CouplingSumIn<D>::taken() {
  self_.insert(self_.end(), cross_.begin(), cross_.end());
  return std::move(self_);
}

template class CouplingSumIn<2>;
template class CouplingSumIn<3>;

template <int D> HatTableIn<D>::HatTableIn(int side) : side_(side) {
  for (int z = 0; z < (D > 2 ? side : 1); ++z)
    for (int y = 0; y < side; ++y)
      for (int x = 0; x < side; ++x) {
        const double s = x / static_cast<double>(side), t = y / static_cast<double>(side),
                     r = z / static_cast<double>(side);
        HatsIn<D> hats;
        for (int c = 0; c < corners<D>; ++c)
          hats[c] = (c & 1 ? s : 1 - s) * (c >> 1 & 1 ? t : 1 - t) * (c >> 2 ? r : 1 - r);
        hats_.push_back(hats);
      }
}

template class HatTableIn<2>;
template class HatTableIn<3>;

const Hats& hats_at(int x, int y) {
  static const HatTableIn<2> table(Aggregates::cell);
  constexpr int inside = Aggregates::cell - 1;
  return table.at(x & inside, y & inside, 0);
}

}  // namespace arenite::statics

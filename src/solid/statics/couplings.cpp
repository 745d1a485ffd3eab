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
    if (cross_[c].q == q) return cross_[c];
  next_.push_back(latest_[p]);
  latest_[p] = static_cast<std::int32_t>(cross_.size());
  cross_.push_back({p, q, {}});
  return cross_.back();
}

template <int D> std::vector<CouplingIn<D>> CouplingSumIn<D>::taken() {
  self_.insert(self_.end(), cross_.begin(), cross_.end());
  return std::move(self_);
}

template class CouplingSumIn<2>;
template class CouplingSumIn<3>;

HatTable::HatTable(int side) : side_(side) {
  for (int z = 0; z < side; ++z)
    for (int y = 0; y < side; ++y)
      for (int x = 0; x < side; ++x) {
        const double s = x / static_cast<double>(side), t = y / static_cast<double>(side),
                     r = z / static_cast<double>(side);
        HatsIn<3> hats;
        for (int c = 0; c < 8; ++c) hats[c] = (c & 1 ? s : 1 - s) * (c >> 1 & 1 ? t : 1 - t) * (c >> 2 ? r : 1 - r);
        hats_.push_back(hats);
      }
}

const Hats& hats_at(int x, int y) {
  return all_hats[static_cast<unsigned>((y & (cell - 1)) * cell + (x & (cell - 1)))];
}

}  // namespace arenite::statics

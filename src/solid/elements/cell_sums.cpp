#include "solid/elements/cell_sums.hpp"

#include <algorithm>

namespace arenite::elements {
namespace {

/// visit(k) for the cells that corners are in, as bits of the axes along which they are the next ones.
template <class Visit> void each_cell(unsigned across, const Visit& visit) {
  for (unsigned k = 0; k < 8; ++k)
    if ((k & ~across) == 0) visit(k);
}

}  // namespace

CellSums::CellSums(const Voxels& elements, const Aggregates& cut, const std::vector<std::uint8_t>& prescribed)
    : elements_(elements),
      of_node_(cut.of_node.data()),
      stride_(elements.grid.stride),
      layer_(elements.grid.layer),
      side_(cut.side),
      weights_(static_cast<std::size_t>(cut.side), Weights{}) {
  for (int z = 0; z < elements.cells[2]; ++z)
    slides_.push_back(prescribed[static_cast<std::size_t>(z)] == statics::normal_component<3>);
  const int last = side_ - 2;  // from where an element does not reach into the next cell
  for (const int at : {0, last / 2, last})
    if (at >= 0 && (places_.empty() || at > places_.back())) places_.push_back(at);
  for (int at = 0; at <= last; ++at)
    for (std::size_t k = 0; k < places_.size(); ++k) {
      double weight = 1;
      for (const int other : places_)
        if (other != places_[k]) weight *= static_cast<double>(at - other) / (places_[k] - other);
      weights_[static_cast<std::size_t>(at)][k] = weight;
    }
  weights_.back()[0] = 1;
  const auto hats = [&](int node) {
    const double share = node / static_cast<double>(side_);
    return std::array{1 - share, share};
  };
  using Ends = std::array<double, 2>;  // of a hat, or of the part of it that is in one cell
  const auto along = [](const Ends& end, bool changes) { return changes ? end[1] - end[0] : end[1] + end[0]; };
  const auto put = [&](AxisProducts& products, std::size_t place, const auto& of_p, const auto& of_q) {
    for (std::size_t modes = 0; modes < 4; ++modes)
      for (std::size_t a = 0; a < 2; ++a)
        for (std::size_t b = 0; b < 2; ++b)
          products.at[modes][place][2 * a + b] = along(of_p[a], modes >> 1 & 1) * along(of_q[b], modes & 1);
  };
  inside_.places = static_cast<int>(places_.size());
  for (std::size_t k = 0; k < places_.size(); ++k) {
    const auto low = hats(places_[k]), high = hats(places_[k] + 1);
    const std::array of{Ends{low[0], high[0]}, Ends{low[1], high[1]}};
    put(inside_, k, of, of);
  }
  const auto last_hats = hats(side_ - 1);
  const std::array<std::array<Ends, 2>, 2> side{{{Ends{last_hats[0], 0}, Ends{last_hats[1], 0}}, {Ends{0, 1}, {}}}};
  for (std::size_t p = 0; p < 2; ++p)
    for (std::size_t q = 0; q < 2; ++q) {
      AxisProducts& products = across_[2 * p + q];
      put(products, 0, side[p], side[q]);
      products.of_p = p ? 1 : 2, products.of_q = q ? 1 : 2;
    }
}

CellSums::Found CellSums::count_of(std::vector<Count>& counts, unsigned across, const Side& left, const Side& right) {
  Labels labels;
  for (std::size_t c = 0; c < labels.size(); ++c) labels[c] = (c & 1 ? right : left).labels[c >> 1];
  for (std::size_t k = counts.size(); k-- > 0;)
    if (counts[k].across == across && counts[k].labels == labels) return {counts[k]};
  counts.push_back({across, labels, {}});
  return {counts.back()};
}

CellShares CellSums::shares_of(const Count& count) const {
  constexpr std::array members{&Modes<3>::axial, &Modes<3>::cross,  &Modes<3>::shear,
                               &Modes<3>::along, &Modes<3>::across, &Modes<3>::trilinear};
  CellShares shares{};
  for (std::size_t place = 0; place < shares.at[0].size(); ++place) {
    for (std::size_t k = 0; k < members.size(); ++k)
      for (const Kind kind : solid_kinds)
        shares.at[k][place] += elements_.modes[kind].*members[k] * count.at[kind - 1][place];
    shares.at[CellShares::third_shear][place] = shares.at[CellShares::shear][place] / 3.0;
    shares.at[CellShares::two_thirds_shear][place] = 2.0 * shares.at[CellShares::third_shear][place];
  }
  return shares;
}

void CellSums::work_out(const Count& count, statics::CouplingSumIn<3>& sum) const {
  const CellShares shares = shares_of(count);
  each_cell(count.across, [&](unsigned a) {
    each_cell(count.across, [&](unsigned b) {
      if (b < a) return;
      const bool swap = count.labels[b] < count.labels[a];
      const unsigned low = swap ? b : a, high = swap ? a : b;
      CellProducts products;
      for (unsigned axis = 0; axis < 3; ++axis)
        products[axis] = count.across >> axis & 1 ? &across_[2 * (low >> axis & 1) + (high >> axis & 1)] : &inside_;
      couple_(shares, products, sum.between(count.labels[low], count.labels[high]));
    });
  });
}

}  // namespace arenite::elements

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
  const statics::HatTableIn<3> hats(side_);
  for (unsigned across = 0; across < 8; ++across)
    for (int k = 0; k < places(across, 2); ++k)
      for (int j = 0; j < places(across, 1); ++j)
        for (int i = 0; i < places(across, 0); ++i)
          each_cell(across, [&](unsigned reached) {
            Part<3>& part = parts_[across].emplace_back();
            part.clear();
            for (int c = 0; c < 8; ++c)
              if ((static_cast<unsigned>(c) & across) == reached)
                part.add(hats.at(place_at(across, 0, i) + (c & 1), place_at(across, 1, j) + (c >> 1 & 1),
                                 place_at(across, 2, k) + (c >> 2)),
                         c, false);
          });
}

CellSums::Found CellSums::count_of(std::vector<Count>& counts, unsigned across, const Side& left, const Side& right) {
  Labels labels;
  for (std::size_t c = 0; c < labels.size(); ++c) labels[c] = (c & 1 ? right : left).labels[c >> 1];
  for (std::size_t k = counts.size(); k-- > 0;)
    if (counts[k].across == across && counts[k].labels == labels) return {counts[k]};
  counts.push_back({across, labels, {}});
  return {counts.back()};
}

void CellSums::work_out(const Count& count, statics::CouplingSumIn<3>& sum) const {
  std::vector<Modes<3>> modes;
  for (int k = 0; k < places(count.across, 2); ++k)
    for (int j = 0; j < places(count.across, 1); ++j)
      for (int i = 0; i < places(count.across, 0); ++i) {
        Modes<3>& here = modes.emplace_back();
        for (const Kind kind : solid_kinds)
          for (const auto mode : Modes<3>::members)
            here.*mode +=
                count.at[kind - 1][static_cast<std::size_t>(most_places * k + j)][i] * elements_.modes[kind].*mode;
      }
  const std::vector<Part<3>>& parts = parts_[count.across];
  const std::size_t reached = parts.size() / modes.size();
  std::array<std::int32_t, 8> owner{};
  std::size_t n = 0;
  each_cell(count.across, [&](unsigned k) { owner[n++] = count.labels[k]; });
  for (std::size_t a = 0; a < reached; ++a)
    for (std::size_t b = a; b < reached; ++b) {
      const bool swap = owner[b] < owner[a];
      const std::size_t low = swap ? b : a, high = swap ? a : b;
      statics::CouplingIn<3>& to = sum.between(owner[low], owner[high]);
      for (std::size_t k = 0; k < modes.size(); ++k)
        if (modes[k].shear != 0) couple_(modes[k], parts[k * reached + low], parts[k * reached + high], to);
    }
}

}  // namespace arenite::elements

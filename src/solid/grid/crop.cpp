#include "solid/grid/crop.hpp"

#include <utility>

namespace arenite::grid {
namespace {

constexpr std::int32_t left_out = -1;

/// New number of every grain that is kept, in the order in which they were added.
class Numbering {
 public:
  explicit Numbering(std::size_t grains) : number_(grains, left_out) {}
  void add(std::int32_t grain) {
    auto& number = number_[static_cast<std::size_t>(grain)];
    if (number != left_out) return;
    number = static_cast<std::int32_t>(kept_.size());
    kept_.push_back(grain);
  }
  std::int32_t operator[](std::int32_t grain) const { return number_[static_cast<std::size_t>(grain)]; }
  bool has(std::int32_t grain) const { return number_[static_cast<std::size_t>(grain)] != left_out; }
  const std::vector<std::int32_t>& kept() const { return kept_; }

 private:
  std::vector<std::int32_t> number_, kept_;
};

Contacts take(const Contacts& from, const Numbering& numbering) {
  Contacts contacts;
  for (std::size_t c = 0; c < from.size(); ++c) {
    if (!numbering.has(from.i[c]) || (!from.is_wall(c) && !numbering.has(from.j[c]))) continue;
    contacts.add(numbering[from.i[c]], from.is_wall(c) ? from.j[c] : numbering[from.j[c]], from.normal[c], from.fn[c],
                 from.ft[c], from.arm_i[c], from.arm_j[c]);
    contacts.overlap.back() = from.overlap[c];
    contacts.sliding_velocity.back() = from.sliding_velocity[c];
    contacts.glued.back() = from.glued[c];
  }
  return contacts;
}

template <class Neck> std::vector<Neck> take(const std::vector<Neck>& from, const Numbering& numbering) {
  std::vector<Neck> necks;
  for (Neck neck : from) {
    if (!numbering.has(neck.i) || !numbering.has(neck.j)) continue;
    neck.i = numbering[neck.i];
    neck.j = numbering[neck.j];
    necks.push_back(neck);
  }
  return necks;
}

}  // namespace

CroppedPacking crop(const Packing& packing, const Cement& cement, const std::vector<std::int32_t>& grain_of_label,
                    Vec2 corner) {
  Numbering numbering(packing.grains.size());
  for (const std::int32_t grain : grain_of_label) numbering.add(grain);
  const auto labels = static_cast<std::int32_t>(numbering.kept().size());
  const auto shown = [&](std::int32_t grain) { return numbering.has(grain) && numbering[grain] < labels; };
  const auto add_partner = [&](std::int32_t i, std::int32_t j) {
    if (shown(i)) numbering.add(j);
    else if (shown(j)) numbering.add(i);
  };
  for (std::size_t c = 0; c < packing.contacts.size(); ++c)
    if (!packing.contacts.is_wall(c)) add_partner(packing.contacts.i[c], packing.contacts.j[c]);
  for (const Bridge& bridge : cement.bridges) add_partner(bridge.i, bridge.j);
  for (const Meniscus& meniscus : cement.menisci) add_partner(meniscus.i, meniscus.j);

  CroppedPacking result;
  result.packing.materials = packing.materials;
  result.packing.domain = packing.domain;
  for (int side = 0; side < sides; ++side) result.packing.domain.wall[side].position -= across(side, corner);
  for (Boundary& boundary : result.packing.domain.boundaries) {
    for (Vec2& p : boundary.points) p -= corner;
    boundary.centre -= corner;
  }
  result.packing.grains = picked(packing.grains, numbering.kept(), corner);
  result.packing.contacts = take(packing.contacts, numbering);
  result.cement.full = cement.full;
  result.cement.coating = cement.coating;
  result.cement.bridges = take(cement.bridges, numbering);
  result.cement.menisci = take(cement.menisci, numbering);
  return result;
}

Packing transposed(const Packing& packing) {
  Packing other = packing;
  for (auto* vectors : {&other.grains.position, &other.grains.velocity, &other.contacts.normal})
    for (Vec2& v : *vectors) std::swap(v.x, v.y);
  for (auto* turning : {&other.grains.angle, &other.grains.omega})
    for (double& value : *turning) value = -value;
  for (double& ft : other.contacts.ft) ft = -ft;  // t is n turned counter-clockwise, which a mirror image is not
  for (std::int32_t& j : other.contacts.j)
    if (is_wall(j) && !is_boundary(j)) j = wall_partner(wall_side(j) ^ 2);
  for (Boundary& boundary : other.domain.boundaries) {
    for (Vec2& p : boundary.points) std::swap(p.x, p.y);
    for (Vec2* v : {&boundary.velocity, &boundary.centre, &boundary.force}) std::swap(v->x, v->y);
    boundary.spin = -boundary.spin;
    boundary.torque = -boundary.torque;
  }
  std::swap(other.domain.wall[left], other.domain.wall[bottom]);
  std::swap(other.domain.wall[right], other.domain.wall[top]);
  std::swap(other.domain.periodic[0], other.domain.periodic[1]);
  return other;
}

}  // namespace arenite::grid

#include "workflow/cropped_packing.hpp"

#include <algorithm>
#include <utility>

namespace arenite::study {
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

Grains take(const Grains& from, const std::vector<std::int32_t>& kept, Vec2 corner) {
  Grains grains;
  grains.resize(kept.size());
  for (std::size_t k = 0; k < kept.size(); ++k) {
    const auto g = static_cast<std::size_t>(kept[k]);
    grains.id[k] = from.id[g];
    grains.radius[k] = from.radius[g];
    grains.material[k] = from.material[g];
    grains.zone[k] = from.zone[g];
    grains.x[k] = from.x[g] - corner.x;
    grains.y[k] = from.y[g] - corner.y;
    grains.angle[k] = from.angle[g];
  }
  return grains;
}

Contacts take(const Contacts& from, const Numbering& numbering) {
  Contacts contacts;
  for (std::size_t c = 0; c < from.size(); ++c) {
    if (!numbering.has(from.i[c]) || (!from.is_wall(c) && !numbering.has(from.j[c]))) continue;
    contacts.add(numbering[from.i[c]], from.is_wall(c) ? from.j[c] : numbering[from.j[c]], from.normal(c), from.fn[c], from.ft[c],
                 from.arm_i[c], from.arm_j[c]);
    contacts.overlap.back() = from.overlap[c];
    contacts.sliding_velocity.back() = from.sliding_velocity[c];
    contacts.glued.back() = from.glued[c];
  }
  return contacts;
}

template <class Joint>
std::vector<Joint> take(const std::vector<Joint>& from, const Numbering& numbering) {
  std::vector<Joint> joints;
  for (Joint joint : from) {
    if (!numbering.has(joint.i) || !numbering.has(joint.j)) continue;
    joint.i = numbering[joint.i];
    joint.j = numbering[joint.j];
    joints.push_back(joint);
  }
  return joints;
}

}  // namespace

CroppedPacking crop(const Packing& packing, const Cement& cement, const std::vector<std::int32_t>& grain_of_label, Vec2 corner) {
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
  for (int side = 0; side < 4; ++side) result.packing.domain.wall[static_cast<std::size_t>(side)].position -= side < 2 ? corner.x : corner.y;
  result.packing.grains = take(packing.grains, numbering.kept(), corner);
  result.packing.contacts = take(packing.contacts, numbering);
  result.cement.full = cement.full;
  result.cement.coating = cement.coating;
  result.cement.bridges = take(cement.bridges, numbering);
  result.cement.menisci = take(cement.menisci, numbering);
  return result;
}

Packing transposed(const Packing& packing) {
  Packing other = packing;
  std::swap(other.grains.x, other.grains.y);
  std::swap(other.grains.vx, other.grains.vy);
  for (auto* turning : {&other.grains.angle, &other.grains.omega})
    for (double& value : *turning) value = -value;
  std::swap(other.contacts.nx, other.contacts.ny);
  for (double& ft : other.contacts.ft) ft = -ft;  // t is n turned counter-clockwise, which a mirror image is not
  for (std::int32_t& j : other.contacts.j)
    if (j < 0) j = wall_partner((-1 - j) ^ 2);
  std::swap(other.domain.wall[left], other.domain.wall[bottom]);
  std::swap(other.domain.wall[right], other.domain.wall[top]);
  std::swap(other.domain.periodic_x, other.domain.periodic_y);
  return other;
}

}  // namespace arenite::study

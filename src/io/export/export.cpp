#include "io/export/export.hpp"

#include <algorithm>

#include "core/mapped.hpp"

namespace arenite::io {

int contact_type(const Packing& packing, std::size_t contact) {
  if (packing.contacts.is_wall(contact)) return -1;
  const auto of = [&](std::int32_t grain) { return packing.grains.material[static_cast<std::size_t>(grain)]; };
  const auto [low, high] = std::minmax({of(packing.contacts.i[contact]), of(packing.contacts.j[contact])});
  const int kinds = static_cast<int>(packing.materials.size());
  return low * kinds - low * (low - 1) / 2 + (high - low);
}

Vec2 far_end(const Packing& packing, std::size_t contact) {
  const auto& contacts = packing.contacts;
  const Vec2 from = packing.grains.position[static_cast<std::size_t>(contacts.i[contact])];
  if (contacts.is_wall(contact)) return from + contacts.lever_i(contact);
  return from + packing.domain.nearest_image(packing.grains.position[static_cast<std::size_t>(contacts.j[contact])] - from);
}

std::vector<std::uint8_t> class_of_node(const PhaseMap& map) {
  return mapped(map.grain, [&](std::int32_t g) { return static_cast<std::uint8_t>(g < 0 ? GrainClass::none : map.grain_class[static_cast<std::size_t>(g)]); });
}

}  // namespace arenite::io

#include "grains/texture/fabric.hpp"

#include <numbers>
#include <string>
#include <utility>

namespace arenite::texture {
namespace {

void put_load(Numbers& to, const View& view) {
  put_angle(to, "load_axis_deg", view.load_axis * 180 / std::numbers::pi, half_turn,
            "Direction of the load, from x, to which signs refer", Trait::detail | by_load_axis(view));
}
void put_load(Numbers& to, const SphereView& view) {
  const Vec3 m = view.load_axis;
  if (view.axis_is_given)
    put(to, "load_direction", Numbers::list({m.x, m.y, m.z}), "", "Direction of the load: x, y, z of a unit vector",
        Trait::detail);
}

/// The set itself and its strong and weak contacts; empty ones are left out.
template <int D> void put_sets(Numbers& to, const ViewIn<D>& view, const std::string& name, const Items& items) {
  Items strong, weak;
  for (const std::size_t c : items) (view.strong(c) ? strong : weak).push_back(c);
  const std::string prefix = name == "all" ? "" : name + " ";
  const auto put_set = [&](const std::string& set, const Items& members, Trait traits) {
    if (members.empty()) return;
    Numbers& place = place_of(set, to, "sets");
    place.update(fabric_of(view, members));
    place.mark(traits);
  };
  put_set(name, items, Trait::none);
  put_set(prefix + "strong", strong, Trait::detail | Trait::by_forces);
  put_set(prefix + "weak", weak, Trait::detail | Trait::by_forces);
}

}  // namespace

/// Strong and weak are told apart by the mean force of the whole network; a contact that pulls is weak.
template <int D> void fabric(const ViewIn<D>& view, TextureIn<D>& texture) {
  if (view.contacts.empty()) return;
  Numbers& j = texture.numbers["fabric"];
  put_sets(j, view, "all", view.contacts);
  for (const auto& [name, items] : contacts_by_type(view)) put_sets(j, view, name, items);
  put_load(j, view);
}
template void fabric(const View&, Texture&);
template void fabric(const SphereView&, TextureIn<3>&);

}  // namespace arenite::texture

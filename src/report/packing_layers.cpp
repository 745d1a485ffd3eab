#include "report/packing_layers.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>
#include <utility>

#include "core/mapped.hpp"
#include "geometry/rectangle.hpp"
#include "grains/fields/coarse_layers.hpp"
#include "grains/texture/grain_quantities.hpp"
#include "grains/texture/stress.hpp"
#include "model/shapes.hpp"
#include "report/colour_ends.hpp"
#include "report/figures/distributions.hpp"
#include "report/figures/state_numbers.hpp"
#include "report/page_document.hpp"

namespace arenite::report {
namespace {

/// Rims of grains that are no disks, from their centres where their angles are 0: those of grain g are points first[g]
/// to first[g + 1] - 1.
Numbers shapes_of(Grains grains, NumberBlock& block) {
  grains.angle.assign(grains.size(), 0.0);
  std::vector<std::uint32_t> first{0};
  std::vector<Vec2> rim;
  for (std::size_t g = 0; g < grains.size(); ++g) {
    for (const Vec2& p : outline_of(grains, g, 0.3)) rim.push_back(p - grains.position[g]);
    first.push_back(static_cast<std::uint32_t>(rim.size()));
  }
  return {{"first", block.add_indices(first)},
          {"x", block.add_reals(mapped(rim, &Vec2::x), "m")},
          {"y", block.add_reals(mapped(rim, &Vec2::y), "m")}};
}

/// What the page knows of every grain in a state: its contacts, place and angle, pressure and deviator of its stress,
/// the mean ratio of its forces, velocity and spin. Of a state at rest the last two are left out.
void add_grain_values(Numbers& out, const Packing& packing, const std::vector<Tensor2>& stresses, NumberBlock& block) {
  if (std::ranges::any_of(packing.contacts.ft, [](double force) { return force != 0; }))
    out["friction"] = block.add_coarse(texture::mobilisations(packing));
  out["coordination"] = block.add_indices(texture::values_of(packing, "coordination"));
  const Grains& grains = packing.grains;
  add_columns(out, grains, io::grain_state_columns, {"x", "y", "angle"}, block);
  out["pressure"] = block.add_reals(mapped(stresses, [](const Tensor2& s) { return texture::pressure(s); }), "Pa");
  out["deviator"] = block.add_coarse(mapped(stresses, [](const Tensor2& s) { return texture::deviator(s); }), "Pa");
  const auto add_motion = [&](std::initializer_list<std::string_view> names) {
    add_columns(out, grains, io::grain_state_columns, names, block, &NumberBlock::add_coarse);
  };
  if (!std::ranges::all_of(grains.velocity, [](Vec2 v) { return v == Vec2{}; })) add_motion({"vx", "vy"});
  if (!std::ranges::all_of(grains.omega, [](double v) { return v == 0; })) add_motion({"omega"});
}

/// Bonds that hold, and how the others broke.
Numbers bonds_of(const Packing& packing, NumberBlock& block) {
  return {{"i", block.add_indices(mapped(packing.bonds, &Bond::i))},
          {"j", block.add_indices(mapped(packing.bonds, &Bond::j))},
          {"broken", block.add_indices(mapped(packing.bonds, &Bond::broken))}};
}

/// Pairs that a pull joins, touching or not.
Numbers cohesive_of(const Packing& packing, NumberBlock& block) {
  return {{"i", block.add_indices(mapped(packing.cohesive, &CohesivePair::i))},
          {"j", block.add_indices(mapped(packing.cohesive, &CohesivePair::j))},
          {"gap", block.add_coarse(mapped(packing.cohesive, &CohesivePair::gap), "m")},
          {"pull", block.add_coarse(mapped(packing.cohesive, &CohesivePair::pull), "N")}};
}

Numbers boundaries_of(const Domain& domain, NumberBlock& block) {
  Numbers list = Numbers::list();
  for (const Boundary& boundary : domain.boundaries) {
    list.push_back({{"name", boundary.name},
                    {"closed", boundary.closed},
                    {"present", boundary.present},
                    {"x", block.add_reals(mapped(boundary.points, &Vec2::x), "m")},
                    {"y", block.add_reals(mapped(boundary.points, &Vec2::y), "m")},
                    {"force", {boundary.force.x, boundary.force.y}},
                    {"torque", boundary.torque}});
  }
  return list;
}

Numbers contacts_of(const Packing& packing, NumberBlock& block) {
  Numbers out = pairs_of(packing, block);
  add_columns(out, packing.contacts, io::contact_columns, {"fn", "ft"}, block);
  out["glued"] = block.add_indices(packing.contacts.glued);
  return out;
}

Numbers domain_of(const Domain& domain, NumberBlock& block) {
  const auto walls = mapped(domain.wall, [](const Wall& wall) {
    return Numbers{
        {"present", wall.present}, {"position", wall.position}, {"force", wall.force}, {"shear", wall.shear_force}};
  });
  Numbers out{{"walls", walls},
              {"periodic", {domain.periodic[0], domain.periodic[1]}},
              {"tilt", domain.tilt},
              {"thickness", domain.thickness}};
  if (!domain.boundaries.empty()) out["boundaries"] = boundaries_of(domain, block);
  return out;
}

/// The numbers of a state, and the window that they are of.
Numbers texture_of(const texture::Texture& texture, const Numbers& numbers, NumberBlock& block) {
  Numbers out = shortened(numbers);
  const texture::Window& window = texture.window;
  out["window"] = {{"known", window.known}, {"x", {window.x_min, window.x_max}}, {"y", {window.y_min, window.y_max}}};
  out["grain_considered"] = block.add_indices(texture.per_grain.considered);
  return out;
}

/// What does not change with time of one grain.
void add_grain(Grains& to, const Grains& from, std::size_t g) {
  const std::size_t n = to.size();
  to.resize(n + 1);
  to.id[n] = from.id[g];
  to.radius[n] = from.radius[g];
  to.material[n] = from.material[g];
  to.zone[n] = from.zone[g];
}

}  // namespace

geometry::Rectangle seen_of(const Packing& packing) {
  constexpr double near = 0.25;  // of the grains' extent
  const Domain& domain = packing.domain;
  const geometry::Rectangle grains = geometry::bounds(packing.grains.position, packing.grains.radius);
  const double x = near * grains.width(), y = near * grains.height();
  geometry::Rectangle seen = grains;
  for (const Boundary& boundary : domain.boundaries) {
    if (!boundary.present || boundary.points.empty()) continue;
    const geometry::Rectangle all = geometry::bounds(boundary.points);
    const auto clipped = [&](double low, double high, double at) {
      return boundary.closed ? at : std::clamp(at, low, high);
    };
    seen.x_min = std::min(seen.x_min, clipped(grains.x_min - x, grains.x_max + x, all.x_min));
    seen.x_max = std::max(seen.x_max, clipped(grains.x_min - x, grains.x_max + x, all.x_max));
    seen.y_min = std::min(seen.y_min, clipped(grains.y_min - y, grains.y_max + y, all.y_min));
    seen.y_max = std::max(seen.y_max, clipped(grains.y_min - y, grains.y_max + y, all.y_max));
  }
  const auto reach = [](double& end, double side, double most) {
    if (std::abs(side - end) <= most) end = side;
  };
  reach(seen.x_min, domain.wall[left].position, x), reach(seen.x_max, domain.wall[right].position, x);
  reach(seen.y_min, domain.wall[bottom].position, y), reach(seen.y_max, domain.wall[top].position, y);
  return seen;
}

Numbers materials_of(const Materials& materials) {
  return mapped(materials, [](const Material& m) {
    return Numbers{{"name", m.name}, {"density", m.density}, {"stiffness", m.stiffness}};
  });
}

Numbers grains_of(const Grains& grains, NumberBlock& block) {
  Numbers out = {{"count", grains.size()},
                 {"id", block.add_integers(std::vector<std::int32_t>(grains.id.begin(), grains.id.end()))},
                 {"radius", block.add_reals(grains.radius, "m")},
                 {"mean_radius", 0.5 * grains.mean_diameter()},
                 {"material", block.add_indices(grains.material)},
                 {"zone", block.add_indices(grains.zone)}};
  if (!grains.shapes.empty()) out["shapes"] = shapes_of(grains, block);
  return out;
}

Numbers pairs_of(const Packing& packing, NumberBlock& block) {
  const Contacts& contacts = packing.contacts;
  const auto grains = static_cast<std::uint32_t>(packing.grains.size());
  std::vector<std::uint32_t> partner(contacts.size());
  for (std::size_t c = 0; c < contacts.size(); ++c)
    partner[c] = contacts.is_wall(c) ? grains + static_cast<std::uint32_t>(contacts.wall_side(c))
                                     : static_cast<std::uint32_t>(contacts.j[c]);
  return {{"i", block.add_indices(contacts.i)}, {"j", block.add_indices(partner)}};
}

Numbers numbers_of(const texture::ForceScale& scale) { return {{"mean", scale.mean}, {"tension", scale.tension}}; }

Numbers snapshot_of(const Snapshot& snapshot, std::size_t stage, const texture::Texture& texture,
                    const Numbers& numbers, NumberBlock& block) {
  const texture::PerGrain& rows = texture.per_grain;
  const geometry::Rectangle seen = seen_of(snapshot.packing);
  Numbers out{{"stage", stage},
              {"label", snapshot.label},
              {"time", snapshot.time},
              {"step", snapshot.step},
              {"domain", domain_of(snapshot.packing.domain, block)},
              {"extent", {seen.x_min, seen.x_max, seen.y_min, seen.y_max}},
              {"contacts", contacts_of(snapshot.packing, block)},
              {"force_scale", numbers_of(figures::force_scale(snapshot.packing, numbers))}};
  add_grain_values(out, snapshot.packing, rows.sigma.empty() ? texture::grain_stresses(snapshot.packing) : rows.sigma,
                   block);
  if (!rows.sigma_norm.empty()) out["sigma_norm"] = block.add_reals(rows.sigma_norm);
  if (!snapshot.packing.bonds.empty()) out["bonds"] = bonds_of(snapshot.packing, block);
  if (!snapshot.packing.cohesive.empty()) out["cohesive"] = cohesive_of(snapshot.packing, block);
  if (numbers.is_known()) out["texture"] = texture_of(texture, numbers, block);
  return out;
}

Numbers coarse_fields_of(const Packing& packing, double shear_rate, NumberBlock& block) {
  if (!fields::has_fields(packing)) return {};
  const fields::Grid grid = fields::grid_to_show(packing);
  const auto f = fields::fields_to_show(packing, shear_rate, grid);
  const auto& [low, high, count] = grid;
  Numbers out{{"bounds", {low.x, high.x, low.y, high.y}},
              {"columns", count.x},
              {"rows", count.y},
              {"width", fields::width_to_show(packing, grid)}};
  Numbers ends = Numbers::tree();
  for (const auto& layer : fields::coarse_layers<2>()) {
    if (!fields::has_layer(layer, f)) continue;
    const std::vector<double> values = fields::values_of(layer, f);
    ends[layer.name] = numbers_of(ends_of(layer, f, values));
    if (layer.formula.empty()) out[layer.name] = block.add_coarse(values, std::string(layer.unit));
  }
  out["ends"] = std::move(ends);
  return out;
}

ShownGrains::ShownGrains(const std::vector<const StageResult*>& stages) {
  for (const StageResult* stage : stages) {
    if (!stage->snapshots.empty()) all_ = stage->snapshots.back().packing.grains;
    exchanged_ = exchanged_ || stage->history.find("inserted");
  }
  last_ = all_.size();
  if (!exchanged_) return;
  for (std::size_t g = 0; g < last_; ++g) place_.emplace(all_.id[g], static_cast<std::uint32_t>(g));
  for (const StageResult* stage : stages)
    for (const Snapshot& snapshot : stage->snapshots) {
      const Grains& grains = snapshot.packing.grains;
      if (fits_last(grains)) continue;
      for (std::size_t g = 0; g < grains.size(); ++g)
        if (place_.emplace(grains.id[g], static_cast<std::uint32_t>(all_.size())).second) add_grain(all_, grains, g);
    }
}

bool ShownGrains::fits_last(const Grains& grains) const {
  const std::size_t n = grains.size();
  return n == last_ && std::equal(grains.radius.begin(), grains.radius.end(), all_.radius.begin()) &&
         std::equal(grains.material.begin(), grains.material.end(), all_.material.begin());
}

bool ShownGrains::has(const Grains& grains) const { return exchanged_ || grains.size() == last_; }

std::vector<const Snapshot*> ShownGrains::states_of(const StageResult& stage) const {
  std::vector<const Snapshot*> states;
  for (const Snapshot& snapshot : stage.snapshots)
    if (has(snapshot.packing.grains)) states.push_back(&snapshot);
  return states;
}

std::vector<std::uint32_t> ShownGrains::places_of(const Grains& grains) const {
  std::vector<std::uint32_t> places;
  const bool fits = fits_last(grains);
  if (!exchanged_ || (fits && all_.size() == last_)) return places;
  for (std::size_t g = 0; g < grains.size(); ++g)
    places.push_back(fits ? static_cast<std::uint32_t>(g) : place_.at(grains.id[g]));
  return places;
}

}  // namespace arenite::report

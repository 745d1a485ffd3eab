#include "report/sphere_document.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <iterator>
#include <numeric>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/mapped.hpp"
#include "geometry/face.hpp"
#include "grains/fields/coarse_layers.hpp"
#include "grains/texture/grain_quantities.hpp"
#include "grains/texture/spheres/spheres.hpp"
#include "report/colour_ends.hpp"
#include "report/figures/headlines.hpp"
#include "report/figures/run_figures.hpp"
#include "report/figures/state_numbers.hpp"
#include "report/packing_layers.hpp"
#include "report/page_document.hpp"
#include "statistics/measured.hpp"

namespace arenite::report {
namespace {

constexpr std::size_t most_forces = 100'000;
constexpr std::size_t most_spheres = 400'000;  // of all stored states together, each of about 30 bytes of the page
constexpr std::size_t most_cells = 60'000;     // of the fields of all states together, each of about 10 bytes

/// Container: lowest corner and size, m; which axes are periodic, by how much the cell above is shifted along x, m, and
/// which sides are walls.
Numbers container_of(const DomainIn<3>& domain) {
  const Vec3 corner = domain.corner(), size = domain.size();
  Numbers periodic = Numbers::list(), walls = Numbers::list();
  for (const bool is_periodic : domain.periodic) periodic.push_back(is_periodic);
  for (int side = 0; side < sides_in<3>; ++side)
    walls.push_back(domain.wall[side].present && !domain.is_periodic(side));
  return {{"corner", Numbers::list({corner.x, corner.y, corner.z})},
          {"size", Numbers::list({size.x, size.y, size.z})},
          {"periodic", std::move(periodic)},
          {"tilt", domain.tilt},
          {"walls", std::move(walls)}};
}

/// The largest forces with the places of their spheres; walls are numbered after the spheres by their side, and
/// contacts with boundaries are left out.
Numbers forces_of(const PackingIn<3>& packing, NumberBlock& block) {
  const ContactsIn<3>& contacts = packing.contacts;
  std::vector<std::size_t> order(contacts.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::erase_if(order, [&](std::size_t c) { return contacts.is_boundary(c); });
  std::ranges::stable_sort(order, std::greater{}, [&](std::size_t c) { return std::abs(contacts.fn[c]); });
  order.resize(std::min(order.size(), most_forces));
  const auto partner = [&](std::size_t c) {
    return contacts.is_wall(c) ? packing.grains.size() + static_cast<std::size_t>(contacts.wall_side(c))
                               : static_cast<std::size_t>(contacts.j[c]);
  };
  return {{"i", block.add_indices(mapped(order, [&](std::size_t c) { return contacts.i[c]; }))},
          {"j", block.add_indices(mapped(order, partner))},
          {"fn", block.add_coarse(mapped(order, [&](std::size_t c) { return contacts.fn[c]; }), "N")},
          {"all", contacts.size()}};
}

/// Bonds with how they broke, 0 while they hold, how near each is to its strength, and where it broke.
Numbers bonds_of(const std::vector<BondIn<3>>& bonds, NumberBlock& block) {
  const auto place = [&](int axis) { return mapped(bonds, [&](const BondIn<3>& bond) { return bond.place[axis]; }); };
  return {{"i", block.add_indices(mapped(bonds, &BondIn<3>::i))},
          {"j", block.add_indices(mapped(bonds, &BondIn<3>::j))},
          {"broken", block.add_indices(
                         mapped(bonds, [](const BondIn<3>& bond) { return static_cast<std::int32_t>(bond.broken); }))},
          {"load", block.add_coarse(mapped(bonds, &BondIn<3>::load))},
          {"x", block.add_reals(place(0), "m")},
          {"y", block.add_reals(place(1), "m")},
          {"z", block.add_reals(place(2), "m")}};
}

/// Boundaries with the edges of their faces: three numbers for either end, from the container's origin.
Numbers boundaries_of(const DomainIn<3>& domain, NumberBlock& block) {
  Numbers list = Numbers::list();
  for (const BoundaryIn<3>& boundary : domain.boundaries) {
    std::vector<double> ends;
    for (const auto& edge : geometry::edges_of(geometry::faces_of(boundary.points, boundary.corners)))
      for (const Vec3& end : edge) ends.insert(ends.end(), {end.x, end.y, end.z});
    list.push_back({{"name", boundary.name}, {"present", boundary.present}, {"ends", block.add_reals(ends, "m")}});
  }
  return list;
}

bool are_those(const GrainsIn<3>& of, const GrainsIn<3>& last) {
  return of.id == last.id && of.radius == last.radius && of.material == last.material;
}

/// Adds what the page may colour spheres by, in its order: quantities of grains by their names. Returns what each is
/// called and its mean.
Numbers add_quantities(Numbers& out, const PackingIn<3>& packing, const Asked& asked, NumberBlock& block) {
  const bool has_forces = std::ranges::any_of(packing.contacts.fn, [](double force) { return force != 0; });
  Numbers words = Numbers::tree();
  const auto add_values = [&](const char* name, const std::vector<double>& values, auto written) {
    const texture::GrainQuantity& quantity = texture::grain_quantity(name);
    out[name] = written(values, std::string(quantity.unit));
    Numbers& said = words[name] = {{"label", std::string(quantity.label)},
                                   {"symbol", std::string(quantity.symbol)},
                                   {"unit", std::string(quantity.unit)}};
    if (quantity.is_magnitude) said["magnitude"] = true;
    if (!values.empty()) said["mean"] = statistics::mean_of(values).value;
  };
  const auto add = [&](const char* name, auto written) {
    add_values(name, texture::values_of(packing, name), written);
  };
  const auto coarse = [&](const std::vector<double>& values, std::string unit) {
    return block.add_coarse(values, std::move(unit));
  };
  if (has_forces) {
    add("pressure", coarse);
    add_values("stress", texture::grain_rows(packing, texture::sphere_options(asked)).per_grain.sigma_norm, coarse);
  }
  if (packing.contacts.size() > 0)
    add("coordination", [&](const std::vector<double>& counts, auto&&) { return block.add_indices(counts); });
  add("speed", coarse);
  return words;
}

/// One state, with what its spheres are unless they are those of the last one. The last one also has what its
/// quantities are called, with their means, for all states have the colours of the last.
Numbers state_of(const SphereResult& stage, std::size_t place, NumberBlock& block) {
  const SnapshotIn<3>& state = stage.snapshots[place];
  const PackingIn<3>& packing = state.packing;
  const GrainsIn<3>& grains = packing.grains;
  Numbers out{{"label", state.label}, {"time", state.time}, {"place", place}, {"count", grains.size()}};
  out["container"] = container_of(packing.domain);
  const bool is_last = place + 1 == stage.snapshots.size();
  if (is_last || !are_those(grains, stage.snapshots.back().packing.grains)) {
    out["materials"] = materials_of(packing.materials);
    out["id"] = block.add_integers(std::vector<std::int32_t>(grains.id.begin(), grains.id.end()));
    out["radius"] = block.add_reals(grains.radius, "m");
    out["mean_radius"] = 0.5 * grains.mean_diameter();
    out["material"] = block.add_indices(grains.material);
  }
  out["x"] = block.add_reals(mapped(grains.position, &Vec3::x), "m");
  out["y"] = block.add_reals(mapped(grains.position, &Vec3::y), "m");
  out["z"] = block.add_reals(mapped(grains.position, &Vec3::z), "m");
  Numbers words = add_quantities(out, packing, stage.asked, block);
  if (is_last) out["quantities"] = std::move(words);
  if (!packing.domain.boundaries.empty()) out["boundaries"] = boundaries_of(packing.domain, block);
  if (!packing.bonds.empty()) out["bonds"] = bonds_of(packing.bonds, block);
  if (!out.contains("pressure")) return out;
  out["forces"] = forces_of(packing, block);
  out["force_scale"] = report::numbers_of(figures::force_scale(stage, state));
  return out;
}

/// Coarse-grained fields of a state on so many cells of its container, along x first, then along y, then along z: the
/// kernel's width, m, where any grain is within its reach unless everywhere, and the layers that no formula gives.
Numbers fields_of(const SphereResult& stage, const SnapshotIn<3>& state, const Cells<3>& cells, NumberBlock& block) {
  const PackingIn<3>& packing = state.packing;
  const fields::GridIn<3> grid{packing.domain.corner(), packing.domain.corner(1), cells};
  const auto f = fields::fields_to_show(packing, fields::shear_rate_at(stage.history, state.time), grid);
  Numbers out{{"low", Numbers::list({grid.low.x, grid.low.y, grid.low.z})},
              {"high", Numbers::list({grid.high.x, grid.high.y, grid.high.z})},
              {"cells", Numbers::list({cells.x, cells.y, cells.z})},
              {"width", fields::width_to_show(packing, grid)}};
  const auto reached = mapped<std::uint8_t>(f.solid_fraction, [](double share) { return share > 0; });
  if (!std::ranges::all_of(reached, [](std::uint8_t is) { return is; })) out["reached"] = block.add_indices(reached);
  Numbers& layers = out["layers"] = Numbers::tree();
  Numbers ends = Numbers::tree();
  for (const auto& layer : fields::coarse_layers<3>()) {
    if (!fields::has_layer(layer, f)) continue;
    const std::vector<double> values = fields::values_of(layer, f);
    ends[layer.name] = report::numbers_of(ends_of(layer, f, values));
    if (layer.formula.empty())
      layers[layer.name] = report::numbers_of(code_field(cells.x, cells.y * cells.z, values, reached, true), block);
  }
  out["ends"] = std::move(ends);
  return out;
}

/// The cells of the fields of a stage, as many in all its states; none where it has no fields.
Cells<3> cells_of(const SphereResult& stage) {
  if (stage.snapshots.empty() || !fields::has_fields(stage.snapshots.back().packing)) return {};
  return fields::grid_to_show(stage.snapshots.back().packing).count;
}

/// What is said of the places and sizes of spheres, and of the quantities of the last state.
Numbers kinds_of(const Numbers& quantities) {
  auto kinds = texture::grain_quantities();
  std::erase_if(kinds, [&](const texture::GrainQuantity& kind) {
    constexpr std::string_view always[] = {"x", "y", "z", "size"};
    return std::ranges::find(always, kind.name) == std::end(always) && !quantities.contains(kind.name);
  });
  return named_kinds(kinds);
}

/// Every so many states are on the page, counted from a stage's last one, and every so many of these with fields.
struct Thinned {
  std::size_t states = 1, fields = 1;
};

Numbers stage_of(const SphereResult& r, const Thinned& every, NumberBlock& block, const figures::WriteList& write) {
  Numbers out{{"name", r.name},
              {"converged", r.converged},
              {"outcome", r.outcome},
              {"provenance", provenance_of(r.provenance)},
              {"headlines", figures::numbers_of(figures::headlines_of(r))},
              {"figures", shortened(figures::numbers_of(figures::sphere_figures(), r, write, true))}};
  add_numbers(out, r.texture.is_tree() ? r.texture : Numbers::tree());
  out["states"] = Numbers::list();
  const std::size_t stored = r.snapshots.size();
  const Cells<3> cells = cells_of(r);
  if (cells.x > 0) out["layers"] = named_kinds(fields::coarse_layers<3>());
  for (std::size_t place = 0; place < stored; ++place) {
    const std::size_t before_last = stored - 1 - place;
    if (before_last % every.states != 0) continue;
    out["states"].push_back(state_of(r, place, block));
    if (cells.x > 0 && fields::has_fields(r.snapshots[place].packing) && before_last / every.states % every.fields == 0)
      out["states"].back()["fields"] = fields_of(r, r.snapshots[place], cells, block);
  }
  out["quantities"] = stored > 0 ? kinds_of(out["states"].back()["quantities"]) : Numbers::tree();
  if (stored < 2) return out;
  std::string note = "Numbers and distributions beside are of the last state.";
  if (every.states > 1)
    note +=
        fmt::format(" Of {} stored states one in {} is on the page, counted from the last; the stage's file has all.",
                    stored, every.states);
  out["note"] = note;
  return out;
}

/// Lest the page be too large.
Thinned thinned(std::span<const SphereResult> stages) {
  std::size_t spheres = 0, cells = 0;
  for (const SphereResult& stage : stages)
    for (const SnapshotIn<3>& state : stage.snapshots) spheres += state.packing.grains.size();
  const std::size_t every = 1 + spheres / most_spheres;
  for (const SphereResult& stage : stages) {
    const Cells<3> of_one = cells_of(stage);
    cells += (stage.snapshots.size() + every - 1) / every * static_cast<std::size_t>(of_one.x) *
             static_cast<std::size_t>(of_one.y) * static_cast<std::size_t>(of_one.z);
  }
  return {every, 1 + cells / most_cells};
}

}  // namespace

void add_spheres(Numbers& document, const PageData& data, NumberBlock& block, const figures::WriteList& write) {
  const Thinned every = thinned(data.spheres);
  for (const SphereResult& result : data.spheres) document["spheres"].push_back(stage_of(result, every, block, write));
}

Numbers state_of_now(const SphereResult& stage, NumberBlock& block) {
  return state_of(stage, stage.snapshots.size() - 1, block);
}

}  // namespace arenite::report

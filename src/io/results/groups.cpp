#include "io/results/groups.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <numeric>
#include <optional>

#include "core/mapped.hpp"
#include "io/results/joints.hpp"

namespace arenite::io {
namespace {

/// A number that need not be there.
void transfer_constant(const Hdf5Group& at, const char* name, std::optional<double>& value) {
  if (at.reads() ? !at.has_attribute(name) : !value) return;
  double number = value.value_or(0);
  at(name, number);
  value = number;
}

/// How the points of a boundary are joined; whether those that were read can be.
void transfer_joints(const Hdf5Group& at, Boundary& boundary) { at("closed", boundary.closed); }
void transfer_joints(const Hdf5Group& at, BoundaryIn<3>& boundary) { at.array("corners", boundary.corners); }
bool are_joined(const Boundary& /*boundary*/) { return true; }
bool are_joined(const BoundaryIn<3>& boundary) {
  const auto& corners = boundary.corners;
  return std::ranges::all_of(corners, [](std::int32_t count) { return count > 0; }) &&
         std::accumulate(corners.begin(), corners.end(), std::size_t{0}) == boundary.points.size();
}

void transfer_along(const Hdf5Group& at, const char* name, const char* unit, double& value) {
  at(fmt::format("{} [{}]", name, unit).c_str(), value);
}
template <int D> void transfer_along(const Hdf5Group& at, const char* name, const char* unit, Vec<D>& value) {
  constexpr const char* axes = "xyz";
  for (int axis = 0; axis < D; ++axis) at(fmt::format("{}_{} [{}]", name, axes[axis], unit).c_str(), value[axis]);
}

/// The boundaries of a domain, of which most have none: files without them have no such group.
template <int D> void transfer_boundaries(const Hdf5Group& at, std::vector<BoundaryIn<D>>& boundaries) {
  if (at.lacks("boundaries", boundaries.empty())) return;
  at.each("boundaries", boundaries, 2, [](const Hdf5Group& one, BoundaryIn<D>& boundary) {
    one("name", boundary.name);
    transfer_joints(one, boundary);
    one("present", boundary.present);
    transfer_along(one, "velocity", "m/s", boundary.velocity);
    transfer_along(one, "spin", "rad/s", boundary.spin);
    transfer_along(one, "centre", "m", boundary.centre);
    transfer_along(one, "force", "N", boundary.force);
    transfer_along(one, "torque", "N m", boundary.torque);
    transfer_points(one, boundary.points);
    if (one.reads() && !are_joined(boundary)) one.refuse("has faces with other points than there are");
  });
}

/// What grains are that are no disks; files of disks have no such group.
void transfer_shapes(const Hdf5Group& /*at*/, GrainsIn<3>& /*grains*/, const GrainsIn<3>* /*sample*/) {}
void transfer_shapes(const Hdf5Group& at, Grains& grains, const Grains* sample) {
  Shapes& shapes = grains.shapes;
  if (at.reads() && !at.has_group("shapes")) {
    if (sample) shapes = sample->shapes;
    return;
  }
  if (!at.reads() && (shapes.empty() || (sample && shapes == sample->shapes))) return;
  const auto group = at.group("shapes");
  group.note(
      "first",
      "grain g has the disks first[g] to first[g + 1] - 1, at x and y from its centre of mass where its angle is 0");
  group.note("filled",
             "1: the convex polygon of the disks' centres widened by their common radius; 0: the union of the disks");
  group.array("first", shapes.first);
  transfer_points(group, shapes.place);
  group.array("radius", shapes.radius, "m");
  group.array("filled", shapes.filled);
  group.array("gyration", shapes.gyration, "m");
  if (!at.reads()) return;
  const std::size_t n = grains.id.size(), disks = shapes.place.size();
  group.same_length(
      {n, shapes.first.empty() ? n + 1 : shapes.first.size() - 1, shapes.filled.size(), shapes.gyration.size()});
  group.same_length({disks, shapes.radius.size()});
  const bool rising = std::is_sorted(shapes.first.begin(), shapes.first.end()) && shapes.first.front() == 0;
  if (!rising || shapes.first.back() != static_cast<std::int32_t>(disks))
    group.refuse("names disks of grains that do not exist");
}

void transfer_shear_force(const Hdf5Group& at, double& force) { at("shear_force [N]", force); }
void transfer_shear_force(const Hdf5Group& at, Vec3& force) {
  at("shear_force_x [N]", force.x);
  at("shear_force_y [N]", force.y);
  at("shear_force_z [N]", force.z);
}

/// What the plane alone has.
void transfer_thickness(const Hdf5Group& /*at*/, DomainIn<3>& /*domain*/) {}
void transfer_thickness(const Hdf5Group& at, Domain& domain) { at("thickness [m]", domain.thickness); }
void note_signs(const Hdf5Group& at, const Packing& packing) {
  at.note(
      "i and j",
      "indices into the arrays of grains, from 0, not ids; j = -1, -2, -3, -4 is the left, right, bottom, top wall");
  if (packing.domain.elements() > 0)
    at.note(
        "j below -4",
        "-5 - j counts the elements of all boundaries, two per point: the point, and the segment from it to the next");
  at.note("signs",
          "n points from j to i, t is n turned by +90 degrees, the force on i is fn n + ft t; fn > 0 is repulsive");
}
void note_signs(const Hdf5Group& at, const PackingIn<3>& packing) {
  at.note("i and j",
          "indices into the arrays of grains, from 0, not ids; j = -1, -2, -3, -4, -5, -6 is the left, right, bottom, "
          "top, back, front wall");
  if (packing.domain.elements() > 0) at.note("j below -6", "-7 - j counts the faces of all boundaries");
  at.note("signs", "n points from j to i, the force on i is fn n + ft x n; fn > 0 is repulsive");
}

/// Arms of grains that are no disks begin off their centres.
void transfer_levers(const Hdf5Group& /*at*/, ContactsIn<3>& /*contacts*/) {}
void transfer_levers(const Hdf5Group& at, Contacts& contacts) {
  if (at.reads() ? !at.has(lever_columns[0].name) : contacts.off_i.empty()) return;
  at.note("off_i_x", "the arms of i and j start at this distance from the centres, for grains other than disks");
  transfer_columns(at, contacts, lever_columns, contacts.size());
}

}  // namespace

void refuse_version_01(const Hdf5Group& file, const std::filesystem::path& path) {
  const auto is_text = [&](const char* numbers) { return file.has(numbers) && !file.has_group(numbers); };
  if (is_text("texture") || is_text("numbers") || file.has("swing"))
    refuse(path.string(),
           "was written by Arenite 0.1, whose results are no longer read; run the recipe in it (/provenance/recipe) "
           "again");
}

void transfer_points(const Hdf5Group& at, std::vector<Vec2>& points) {
  at.records(points, Named{"x", &Vec2::x, "m"}, Named{"y", &Vec2::y, "m"});
}
void transfer_points(const Hdf5Group& at, std::vector<Vec3>& points) {
  at.records(points, Named{"x", &Vec3::x, "m"}, Named{"y", &Vec3::y, "m"}, Named{"z", &Vec3::z, "m"});
}

void transfer_provenance(const Hdf5Group& at, Provenance& provenance) {
  at("version", provenance.version);
  at("stage", provenance.stage);
  at("input_hash", provenance.input_hash);
  at.seed("seed", provenance.seed);
  at("kernel", provenance.kernel);
  at.text("recipe", provenance.recipe);
  at.attributes("options", provenance.options);
  if (!at.reads() || at.has_attribute("title")) at("title", provenance.title);
}

void transfer_materials(const Hdf5Group& at, Materials& materials) {
  at.each("materials", materials, 2, [](const Hdf5Group& one, Material& material) {
    one("name", material.name);
    one("density [kg/m^3]", material.density);
    one("stiffness [N/m]", material.stiffness);
    one("thermoelastic_factor [K/Pa]", material.thermoelastic_factor);
    transfer_constant(one, "youngs_modulus [Pa]", material.youngs_modulus);
    transfer_constant(one, "poisson", material.poisson);
  });
}

template <int D> void transfer_domain(const Hdf5Group& at, DomainIn<D>& domain) {
  constexpr std::array<const char*, 3> periodic{"periodic_x", "periodic_y", "periodic_z"};
  const auto group = at.group("domain");
  for (int axis = 0; axis < D; ++axis) group(periodic[axis], domain.periodic[axis]);
  group("tilt [m]", domain.tilt);
  transfer_thickness(group, domain);
  for (std::size_t side = 0; side < domain.wall.size(); ++side) {
    const auto at_side = group.group(any_side_names[side]);
    WallIn<D>& wall = domain.wall[side];
    at_side("present", wall.present);
    at_side("position [m]", wall.position);
    at_side("velocity [m/s]", wall.velocity);
    at_side("force [N]", wall.force);
    transfer_shear_force(at_side, wall.shear_force);
  }
  transfer_boundaries(group, domain.boundaries);
}

template void transfer_domain<2>(const Hdf5Group&, Domain&);
template void transfer_domain<3>(const Hdf5Group&, DomainIn<3>&);

template <int D> void transfer_names(const Hdf5Group& at, GrainsIn<D>& grains, const GrainsIn<D>* sample) {
  const auto transfer = [&]<class T>(const char* name, std::vector<T> GrainsIn<D>::*member, const char* unit = "1") {
    auto& values = grains.*member;
    if (at.reads() && sample && !at.has(name)) values = sample->*member;
    else if (at.reads() || !sample || values != sample->*member) at.array(name, values, unit);
  };
  transfer("id", &GrainsIn<D>::id);
  transfer("radius", &GrainsIn<D>::radius, "m");
  transfer("material", &GrainsIn<D>::material);
  transfer("zone", &GrainsIn<D>::zone);
  at.same_length({grains.id.size(), grains.radius.size(), grains.material.size(), grains.zone.size()});
  transfer_shapes(at, grains, sample);
}

template <int D> void transfer_grains(const Hdf5Group& at, PackingIn<D>& packing, const GrainsIn<D>* sample) {
  const auto group = at.group("grains");
  transfer_names(group, packing.grains, sample);
  transfer_columns(group, packing.grains, state_columns(packing.grains), packing.grains.id.size());
  const auto kinds = static_cast<std::int64_t>(packing.materials.size());
  for (const auto m : packing.grains.material)
    if (at.reads() && (m < 0 || m >= kinds)) at.refuse("names a material that does not exist");
}

template <int D> void transfer_contacts(const Hdf5Group& at, PackingIn<D>& packing) {
  ContactsIn<D>& contacts = packing.contacts;
  const auto group = at.group("contacts");
  note_signs(group, packing);
  group.array("i", contacts.i);
  group.array("j", contacts.j);
  transfer_columns(group, contacts, columns_of(contacts), contacts.size());
  group.array("glued", contacts.glued);
  transfer_levers(group, contacts);
  if (!at.reads()) return;
  group.same_length({contacts.size(), contacts.j.size(), contacts.glued.size()});
  const auto n = static_cast<std::int64_t>(packing.grains.size());
  const std::int32_t last = wall_partner(sides_in<D> - 1) - packing.domain.elements();
  for (std::size_t c = 0; c < contacts.size(); ++c)
    if (contacts.i[c] < 0 || contacts.i[c] >= n || contacts.j[c] >= n || contacts.j[c] < last)
      group.refuse("names a grain that does not exist");
}

void transfer_packing(const Hdf5Group& at, Packing& packing) {
  const auto group = at.group("packing");
  transfer_materials(group, packing.materials);
  transfer_domain<2>(group, packing.domain);
  transfer_grains<2>(group, packing, nullptr);
  transfer_contacts(group, packing);
  transfer_joints(group, packing);
}

#define ARENITE_OF(D)                                                                 \
  template void transfer_names(const Hdf5Group&, GrainsIn<D>&, const GrainsIn<D>*);   \
  template void transfer_grains(const Hdf5Group&, PackingIn<D>&, const GrainsIn<D>*); \
  template void transfer_contacts(const Hdf5Group&, PackingIn<D>&);
ARENITE_OF(2)
ARENITE_OF(3)
#undef ARENITE_OF

void transfer_phases(const Hdf5Group& map_at, std::vector<Phase>& phases, Shape shape) {
  auto stored = mapped(phases, [](Phase phase) { return static_cast<std::uint8_t>(phase); });
  map_at.note("phases", "0 empty, 1 matrix, 2 particle");
  map_at.image("phase", stored, shape);
  if (!map_at.reads()) return;
  for (const auto phase : stored)
    if (phase > static_cast<std::uint8_t>(Phase::particle)) map_at.refuse("names a phase that does not exist");
  phases = mapped(stored, [](std::uint8_t phase) { return static_cast<Phase>(phase); });
}

void transfer_history(const Hdf5Group& at, const char* name, History& history) {
  const auto group = at.group(name);
  if (at.reads())
    for (const auto& own : group.names()) history.columns.push_back({own, group.unit(own), {}});
  for (auto& column : history.columns) group.array(column.name, column.values, column.unit);
}

}  // namespace arenite::io

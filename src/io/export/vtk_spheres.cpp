#include "io/export/vtk_spheres.hpp"

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "io/export/vtk_file.hpp"
#include "io/results/groups.hpp"

namespace arenite::io {
namespace {

VtkPolyData spheres_of(const ExportSpheres& from) {
  const GrainsIn<3>& grains = from.snapshot->packing.grains;
  VtkPolyData data;
  data.time = from.snapshot->time;
  data.points = in_space(grains.position);
  data.point_arrays = {{"id", grains.id},
                       {"radius", grains.radius},
                       {"material", grains.material},
                       {"velocity", in_space(grains.velocity), 3},
                       {"angle", in_space(grains.angle), 3},
                       {"omega", in_space(grains.omega), 3}};
  for (const auto& field : from.fields) data.point_arrays.push_back({field.name, field.values});
  return data;
}

VtkPolyData contacts_of_spheres(const ExportSpheres& from) {
  const PackingIn<3>& packing = from.snapshot->packing;
  const ContactsIn<3>& contacts = packing.contacts;
  VtkPolyData data;
  data.time = from.snapshot->time;
  data.lines = true;
  std::vector<Vec3> ends;
  std::vector<double> force_at_ends;
  for (std::size_t c = 0; c < contacts.size(); ++c) {
    ends.push_back(packing.grains.position[static_cast<std::size_t>(contacts.i[c])]);
    ends.push_back(far_end(packing, c));
    force_at_ends.insert(force_at_ends.end(), 2, contacts.fn[c]);
  }
  data.points = in_space(ends);
  data.point_arrays = {{"fn", force_at_ends}};
  const auto of_each = [&](auto value) { return by_contact(packing, value); };
  data.cell_arrays = {{"i", of_each([&](std::size_t c) { return id_of_i(packing, c); })},
                      {"j", of_each([&](std::size_t c) { return id_of_j(packing, c); })},
                      {"type", of_each([&](std::size_t c) { return contact_type(packing, c); })},
                      {"force", in_space(of_each([&](std::size_t c) { return contacts.force_on_i(c); })), 3}};
  for (const auto& column : columns_of(contacts)) data.cell_arrays.push_back({column.name, column.of(contacts)});
  return data;
}

/// Bonds that hold, as lines from centre to centre.
VtkPolyData bonds_of_spheres(const ExportSpheres& from) {
  const PackingIn<3>& packing = from.snapshot->packing;
  VtkPolyData data;
  data.time = from.snapshot->time;
  data.lines = true;
  std::vector<Vec3> ends, force, moment;
  std::vector<std::int64_t> i, j;
  std::vector<double> load, energy;
  for (const BondIn<3>& bond : packing.bonds) {
    if (bond.broken != BondBreak::none) continue;
    const Vec3 place = packing.grains.position[bond.i];
    ends.insert(ends.end(), {place, place - branch_of(packing, bond)});
    i.push_back(packing.grains.id[bond.i]), j.push_back(packing.grains.id[bond.j]);
    force.push_back(force_on_i(packing, bond)), moment.push_back(bond.moment);
    load.push_back(bond.load), energy.push_back(bond.energy);
  }
  data.points = in_space(ends);
  data.cell_arrays = {{"i", i},       {"j", j},           {"force", in_space(force), 3},
                      {"load", load}, {"energy", energy}, {"moment", in_space(moment), 3}};
  return data;
}

/// A point for every bond that broke, where it did.
VtkPolyData cracks_of_spheres(const ExportSpheres& from) {
  const PackingIn<3>& packing = from.snapshot->packing;
  VtkPolyData data;
  data.time = from.snapshot->time;
  std::vector<Vec3> places;
  std::vector<std::int64_t> i, j;
  std::vector<std::int32_t> broken;
  std::vector<double> time, energy;
  for (const BondIn<3>& bond : packing.bonds) {
    if (bond.broken == BondBreak::none) continue;
    places.push_back(bond.place);
    i.push_back(packing.grains.id[bond.i]), j.push_back(packing.grains.id[bond.j]);
    broken.push_back(static_cast<std::int32_t>(bond.broken));
    time.push_back(bond.time), energy.push_back(bond.energy);
  }
  data.points = in_space(places);
  data.point_arrays = {{"i", i}, {"j", j}, {"broken", broken}, {"time", time}, {"energy", energy}};
  return data;
}

/// The faces of boundaries, of which each has what acts on the boundary that it is of.
VtkPolyData boundaries_of_spheres(const ExportSpheres& from) {
  VtkPolyData data;
  data.time = from.snapshot->time;
  std::vector<Vec3> points, force, torque, velocity;
  std::vector<std::int32_t> number;
  std::vector<std::uint8_t> present;
  const auto& boundaries = from.snapshot->packing.domain.boundaries;
  for (std::size_t b = 0; b < boundaries.size(); ++b) {
    const BoundaryIn<3>& boundary = boundaries[b];
    points.insert(points.end(), boundary.points.begin(), boundary.points.end());
    data.corners.insert(data.corners.end(), boundary.corners.begin(), boundary.corners.end());
    const std::size_t faces = boundary.corners.size();
    number.insert(number.end(), faces, static_cast<std::int32_t>(b));
    present.insert(present.end(), faces, boundary.present ? 1 : 0);
    force.insert(force.end(), faces, boundary.force), torque.insert(torque.end(), faces, boundary.torque);
    velocity.insert(velocity.end(), faces, boundary.velocity);
  }
  data.points = in_space(points);
  data.cell_arrays = {{"boundary", number},
                      {"present", present},
                      {"force", in_space(force), 3},
                      {"torque", in_space(torque), 3},
                      {"velocity", in_space(velocity), 3}};
  return data;
}

}  // namespace

std::vector<NamedBytes> vtk_spheres(const ExportSpheres& from) {
  std::vector<NamedBytes> files;
  std::vector<std::pair<std::string, std::string>> blocks;
  const auto add = [&](const char* what, const VtkPolyData& data) {
    files.push_back({vtk_name(what, from.number), vtp_bytes(data)});
    blocks.emplace_back(what, files.back().name);
  };
  add("grains", spheres_of(from));
  add("contacts", contacts_of_spheres(from));
  if (!from.snapshot->packing.bonds.empty()) {
    add("bonds", bonds_of_spheres(from));
    add("cracks", cracks_of_spheres(from));
  }
  if (!from.snapshot->packing.domain.boundaries.empty()) add("boundaries", boundaries_of_spheres(from));
  files.push_back({vtk_state_name(from.number), vtm_bytes(blocks)});
  return files;
}

}  // namespace arenite::io

#include <fmt/core.h>

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <numeric>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/mapped.hpp"
#include "io/export/export.hpp"
#include "io/export/vtk_file.hpp"
#include "io/export/vtk_spheres.hpp"
#include "io/results/groups.hpp"
#include "model/shapes.hpp"

namespace arenite::io {
namespace {

/// The stress of every grain as one tensor of nine, row by row; nothing where a component is not there.
std::vector<double> stress_of(const ExportSnapshot& from) {
  constexpr std::pair<const char*, std::size_t> components[] = {
      {"sigma_xx", 0}, {"sigma_xy", 1}, {"sigma_yx", 3}, {"sigma_yy", 4}};
  std::vector<double> tensor;
  for (const auto& [name, place] : components) {
    const auto at = std::ranges::find(from.fields, name, &GrainField::name);
    if (at == from.fields.end()) return {};
    tensor.resize(9 * at->values.size());
    for (std::size_t k = 0; k < at->values.size(); ++k) tensor[9 * k + place] = at->values[k];
  }
  return tensor;
}

VtkPolyData grains_of(const ExportSnapshot& from) {
  const Grains& grains = from.snapshot->packing.grains;
  VtkPolyData data;
  data.time = from.snapshot->time;
  data.points = in_space(grains.position);
  data.point_arrays = {{"id", grains.id},
                       {"radius", grains.radius},
                       {"material", grains.material},
                       {"zone", grains.zone},
                       {"velocity", in_space(grains.velocity), 3},
                       {"angle", grains.angle},
                       {"omega", grains.omega}};
  if (from.displacement.size() == grains.size())
    data.point_arrays.push_back({"displacement", in_space(from.displacement), 3});
  for (const auto& field : from.fields) data.point_arrays.push_back({field.name, field.values});
  if (auto stress = stress_of(from); !stress.empty()) data.point_arrays.push_back({"stress", std::move(stress), 9});
  return data;
}

/// Lines, to be filled in.
VtkPolyData lines_at(const ExportSnapshot& from) {
  VtkPolyData data;
  data.time = from.snapshot->time;
  data.lines = true;
  return data;
}

VtkPolyData contacts_of(const ExportSnapshot& from) {
  const Packing& packing = from.snapshot->packing;
  const Contacts& contacts = packing.contacts;
  const double mean = mean_compressive_force(contacts);
  VtkPolyData data = lines_at(from);
  std::vector<double> force_at_ends;
  for (std::size_t c = 0; c < contacts.size(); ++c) {
    const Vec2 a = packing.grains.position[static_cast<std::size_t>(contacts.i[c])], b = far_end(packing, c);
    data.points.insert(data.points.end(), {a.x, a.y, 0, b.x, b.y, 0});
    force_at_ends.insert(force_at_ends.end(), 2, contacts.fn[c]);
  }
  const auto of_each = [&](auto value) { return by_contact(packing, value); };
  data.point_arrays = {{"fn", force_at_ends}};  // on points as well: ParaView's tubes take their radius from there
  data.cell_arrays = {{"i", of_each([&](std::size_t c) { return id_of_i(packing, c); })},
                      {"j", of_each([&](std::size_t c) { return id_of_j(packing, c); })},
                      {"type", of_each([&](std::size_t c) { return contact_type(packing, c); })},
                      {"strong", of_each([&](std::size_t c) { return std::uint8_t{contacts.fn[c] > mean}; })},
                      {"glued", contacts.glued},
                      {"force", in_space(of_each([&](std::size_t c) { return contacts.force_on_i(c); })),
                       3}};  // on i, the line's first end
  for (const auto& column : contact_columns) data.cell_arrays.push_back({column.name, column.of(contacts)});
  return data;
}

/// Four lines, in the order of the sides; `present` is 0 where a side is the edge of a periodic cell. Behind them the
/// segments of boundaries, whose `side` counts on from 4 and whose force and velocity are without direction.
VtkPolyData walls_of(const ExportSnapshot& from) {
  const Domain& domain = from.snapshot->packing.domain;
  const double x0 = domain.wall[left].position, x1 = domain.wall[right].position;
  const double y0 = domain.wall[bottom].position, y1 = domain.wall[top].position;
  VtkPolyData data = lines_at(from);
  const double t = domain.tilt;
  data.points = {x0, y0, 0, x0 + t, y1, 0, x1,     y0, 0, x1 + t, y1, 0,
                 x0, y0, 0, x1,     y0, 0, x0 + t, y1, 0, x1 + t, y1, 0};
  std::vector<std::int32_t> side{left, right, bottom, top};
  auto present = mapped<std::uint8_t>(domain.wall, &Wall::present);
  auto force = mapped(domain.wall, &Wall::force), shear_force = mapped(domain.wall, &Wall::shear_force),
       velocity = mapped(domain.wall, &Wall::velocity);
  for (std::size_t b = 0; b < domain.boundaries.size(); ++b) {
    const Boundary& boundary = domain.boundaries[b];
    const std::size_t n = boundary.points.size();
    for (std::size_t p = 0; p + (boundary.closed ? 0 : 1) < n; ++p) {
      const Vec2 from_here = boundary.points[p], to = boundary.points[(p + 1) % n];
      data.points.insert(data.points.end(), {from_here.x, from_here.y, 0, to.x, to.y, 0});
      side.push_back(4 + static_cast<std::int32_t>(b));
      present.push_back(boundary.present ? 1 : 0);
      force.push_back(norm(boundary.force));
      shear_force.push_back(0);
      velocity.push_back(norm(boundary.velocity));
    }
  }
  data.cell_arrays = {
      {"side", side}, {"present", present}, {"force", force}, {"shear_force", shear_force}, {"velocity", velocity}};
  return data;
}

/// Lines along the rims of grains.
VtkPolyData rims_of(const ExportSnapshot& from) {
  const Grains& grains = from.snapshot->packing.grains;
  VtkPolyData data = lines_at(from);
  std::vector<std::int64_t> id;
  std::vector<std::int32_t> material;
  for (std::size_t g = 0; g < grains.size(); ++g) {
    const std::vector<Vec2> rim = outline_of(grains, g);
    for (std::size_t k = 0; k < rim.size(); ++k) {
      const Vec2 next = rim[(k + 1) % rim.size()];
      data.points.insert(data.points.end(), {rim[k].x, rim[k].y, 0, next.x, next.y, 0});
      id.push_back(grains.id[g]);
      material.push_back(grains.material[g]);
    }
  }
  data.cell_arrays = {{"id", id}, {"material", material}};
  return data;
}

std::vector<float> single(const std::vector<double>& values) { return {values.begin(), values.end()}; }

struct Part {
  const char* name;
  VtkPolyData (*of)(const ExportSnapshot&);
};
constexpr Part parts[] = {{"grains", grains_of}, {"contacts", contacts_of}, {"walls", walls_of}};
constexpr Part outlines{"outlines", rims_of};  // beside them, where grains are no disks

/// The bonds that broke, a point each, in the order of breaking.
VtkPolyData cracks_of(const std::vector<Crack>& cracks) {
  VtkPolyData data;
  for (const Crack& crack : cracks) data.points.insert(data.points.end(), {crack.x, crack.y, 0});
  std::vector<std::int32_t> order(cracks.size());
  std::iota(order.begin(), order.end(), 0);
  data.point_arrays = {
      {"order", order}, {"type", mapped(cracks, &Crack::type)}, {"strain", mapped(cracks, &Crack::strain)}};
  return data;
}

/// The faces between voxels whose shortest bond broke, in the order of breaking: the surfaces of cracks.
VtkPolyData crack_faces(const VoxelResult& r) {
  VtkPolyData data;
  std::vector<std::int32_t> order, type;
  std::vector<double> strain;
  for (std::size_t k = 0; k < r.cracks.size(); ++k) {
    const SpaceCrack& c = r.cracks[k];
    const int along[] = {std::abs(c.along_x), std::abs(c.along_y), std::abs(c.along_z)};
    if (along[0] + along[1] + along[2] != 1) continue;
    const Vec3 middle{static_cast<double>(c.x), static_cast<double>(c.y), static_cast<double>(c.z)};
    const int normal = along[0] == 1 ? 0 : along[1] == 1 ? 1 : 2;
    for (const auto& [u, v] : {std::pair{-0.5, -0.5}, {0.5, -0.5}, {0.5, 0.5}, {-0.5, 0.5}}) {
      Vec3 corner = middle;
      corner[(normal + 1) % 3] += u * r.map.dx, corner[(normal + 2) % 3] += v * r.map.dx;
      data.points.insert(data.points.end(), {corner.x, corner.y, corner.z});
    }
    data.corners.push_back(4);
    order.push_back(static_cast<std::int32_t>(k)), type.push_back(c.type), strain.push_back(c.strain);
  }
  data.cell_arrays = {{"order", order}, {"type", type}, {"strain", strain}};
  return data;
}

std::vector<NamedBytes> vtk_snapshot(const ExportSnapshot& snapshot) {
  std::vector<NamedBytes> files;
  std::vector<std::pair<std::string, std::string>> blocks;
  const auto add = [&](const Part& part) {
    files.push_back({vtk_name(part.name, snapshot.number), vtp_bytes(part.of(snapshot))});
    blocks.emplace_back(part.name, files.back().name);
  };
  for (const Part& part : parts) add(part);
  if (!snapshot.snapshot->packing.grains.shapes.empty()) add(outlines);
  files.push_back({vtk_state_name(snapshot.number), vtm_bytes(blocks)});
  return files;
}

/// loading.pvd opens everything, as blocks with names; grains.pvd, contacts.pvd and walls.pvd one thing each, which
/// filters like better.
std::vector<NamedBytes> vtk_index(const std::vector<double>& times) {
  auto files = mapped(parts, [&](const Part& part) {
    return NamedBytes{fmt::format("{}.pvd", part.name),
                      pvd_bytes(times, [&](int f) { return vtk_name(part.name, f); })};
  });
  files.push_back({"loading.pvd", pvd_bytes(times, vtk_state_name)});
  return files;
}

/// The nodes as a picture (NAME.vti); of a pull to failure the broken bonds too, NAME-cracks.vtp.
std::vector<NamedBytes> vti_field(const ExportField& from) {
  const FieldResult& r = *from.result;
  VtkImage image{r.map.width, r.map.height, r.map.dx, {}};
  const auto phase = mapped(r.map.phase, [](Phase p) { return static_cast<std::uint8_t>(p); });
  image.point_arrays = {{"phase", phase}, {"grain", r.map.grain}, {"class", class_of_node(r.map)}};
  if (r.field.size() > 0) {
    std::vector<Vec2> displacement;
    for (std::size_t node = 0; node < r.field.size(); ++node) displacement.push_back(r.field.displacement(node));
    image.point_arrays.push_back({"displacement", single(in_space(displacement)), 3});
    for (const auto& c : field_columns)
      if (std::string_view(c.name).starts_with("sigma"))
        image.point_arrays.push_back({c.name, single(r.field.*c.numbers)});
    image.point_arrays.push_back({"stress", single(symmetric(r.field.xx, r.field.yy, r.field.xy)), 6});
  }
  std::vector<NamedBytes> files{{r.name + ".vti", vti_bytes(image)}};
  if (!r.cracks.empty()) files.push_back({r.name + "-cracks.vtp", vtp_bytes(cracks_of(r.cracks))});
  return files;
}

/// The voxels as an image (NAME.vti); of a test to failure the faces of its cracks too, NAME-cracks.vtp.
std::vector<NamedBytes> vti_voxels(const VoxelResult& r) {
  VtkImage image;
  image.width = r.map.width, image.height = r.map.height, image.depth = r.map.depth;
  image.dx = image.dy = image.dz = r.map.dx;
  image.back = image.depth > 1 ? 0 : -image.dz / 2;
  const VoxelStress& f = r.field;
  std::vector<float> displacement, stress;
  for (std::size_t k = 0; k < f.size(); ++k) {
    displacement.insert(displacement.end(), {f.ux[k], f.uy[k], f.uz[k]});
    stress.insert(stress.end(), {f.xx[k], f.yy[k], f.zz[k], f.xy[k], f.yz[k], f.xz[k]});
  }
  image.point_arrays = {{"phase", mapped(r.map.phase, [](Phase p) { return static_cast<std::uint8_t>(p); })},
                        {"grain", r.map.grain},
                        {"displacement", std::move(displacement), 3},
                        {"stress", std::move(stress), 6}};
  if (!f.damage.empty()) image.point_arrays.push_back({"damage", f.damage});
  image.provenance = fmt::format("Arenite {}, {}", r.provenance.version, r.provenance.input_hash);
  std::vector<NamedBytes> files{{r.name + ".vti", vti_bytes(image)}};
  if (!r.cracks.empty()) files.push_back({r.name + "-cracks.vtp", vtp_bytes(crack_faces(r))});
  return files;
}

}  // namespace

const ExportFormat exports::vtk{
    .name = "vtk",
    .sentence =
        "ParaView: open loading.pvd, which has grains, contacts and walls of all states; fields on nodes (.vti), "
        "broken bonds of a failure (-cracks.vtp)",
    .states = {{"grains",
                "place, radius, id, number of the material, zone, velocity, angle, omega, displacement, stresses and "
                "other numbers of grains"},
               {"contacts", "lines from centre to centre, or to the wall: forces, normal, arms, overlap"},
               {"walls, boundaries", "lines with their forces; in space the faces of boundaries"},
               {"shapes of grains", "their rims, as lines"},
               {"time", "in every file and in the .pvd"},
               {"bonds of spheres", "lines from centre to centre, and as points, cracks, where some broke"},
               {"names of materials, periodic sides, thickness, bonds of disks",
                "left out; `netcdf` has the names, the sides and the thickness"}},
    .other_names = {"paraview", "vtp"},
    .of_snapshot = vtk_snapshot,
    .index = vtk_index,
    .of_field = vti_field,
    .of_spheres = vtk_spheres,
    .of_voxels = vti_voxels};

}  // namespace arenite::io

#pragma once
#include <algorithm>
#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "core/mapped.hpp"
#include "io/formats.hpp"
#include "model/result.hpp"
#include "statistics/columns.hpp"

namespace arenite::io {

/// A quantity of every grain that was derived from a snapshot (its stress, its number of contacts), or of every
/// contact, to be written beside what the snapshot holds. NaN where it is not known.
struct GrainField {
  std::string name, unit;
  std::vector<double> values;
};

/// Fields of a state on the centres of equal cells of an upright box: along x first, then along y, then along z.
template <int D> struct GridFieldsIn {
  Vec<D> corner, step;                ///< m
  Vec<D, std::int32_t> count{};       ///< of cells along each axis
  std::vector<GrainField> scalars{};  ///< one value a point
  std::vector<Vec<D>> velocity{};     ///< m/s; NaN where no grain is near
  std::vector<double> stress{};       ///< xx, yy, zz, xy, yz, xz of each point, Pa, tension positive, with the kinetic
                                      ///< part; 0 out of the plane
};

/// One state of the loading, as every export format gets it: of disks (D = 2) or spheres (3).
template <int D> struct ExportStateIn {
  int number = 0;     ///< place in the loading, from 0
  std::string stage;  ///< name of the stage it belongs to
  const SnapshotIn<D>* snapshot = nullptr;
  std::vector<GrainField> fields;
  std::vector<GrainField> of_contacts = {};
  std::vector<Vec<D>> displacement{};  ///< m, of every grain since the first state; empty if there is none before this
  GridFieldsIn<D> grid{};              ///< for a format that wants it; without columns where the state has none
};
using ExportSnapshot = ExportStateIn<2>;
using ExportSpheres = ExportStateIn<3>;

/// A result on nodes, as export formats get it.
struct ExportField {
  const FieldResult* result = nullptr;
  std::vector<GrainField> fields;  ///< of the grains of the map, one value a label
};

struct NamedBytes {
  std::string name, bytes;
};

/// The curves of a stage, row by row of its history or by cycles.
struct ExportCurves {
  std::string name;  ///< "STAGE_curves", "STAGE_cycles"
  statistics::Columns curves;
};

/// A format: what it makes of one snapshot. Files of the same name from successive snapshots are joined into one;
/// `index` makes the files that list all snapshots by their times. A format of whole loadings has `of_loading` instead,
/// which gets all snapshots and what made the last.
struct ExportFormat {
  std::string_view name, sentence;
  Statements states = {};                            ///< what its files carry of a state, and what they leave out
  std::array<std::string_view, 2> other_names = {};  ///< of programs that read it, by which it may be asked for
  bool wants_grid = false;                           ///< coarse-grained fields, ExportStateIn::grid
  std::vector<NamedBytes> (*of_snapshot)(const ExportSnapshot&) = nullptr;  ///< null: holds fields only
  std::vector<NamedBytes> (*index)(const std::vector<double>& times) = nullptr;
  std::vector<NamedBytes> (*of_field)(const ExportField&) = nullptr;  ///< of a result on nodes; null: holds grains only
  std::vector<NamedBytes> (*of_spheres)(const ExportSpheres&) = nullptr;  ///< null: of none
  std::vector<NamedBytes> (*of_voxels)(const VoxelResult&) = nullptr;     ///< of a sample in space; null: of none
  NamedBytes (*of_curves)(const ExportCurves&) = nullptr;                 ///< null: holds states only
  std::vector<NamedBytes> (*of_loading)(const std::vector<ExportSnapshot>&, const Provenance&) = nullptr;
  std::vector<NamedBytes> (*of_sphere_loading)(const std::vector<ExportSpheres>&, const Provenance&) = nullptr;

  bool holds_disks() const { return of_snapshot || of_loading; }
  bool holds_spheres() const { return of_spheres || of_sphere_loading; }
};
namespace exports {
ARENITE_FAMILY(ExportFormat, ARENITE_EXPORT_FORMATS)
}

/// The export of that name, or with that one among its other names; null if there is none.
inline const ExportFormat* export_named(std::string_view name) {
  return first_format(exports::all, [&](const ExportFormat& format) {
    return format.name == name || (!name.empty() && std::ranges::count(format.other_names, name) > 0);
  });
}
/// All names by which exports are asked for.
inline std::vector<std::string> export_names() {
  auto names = words_of(exports::all, &ExportFormat::name);
  for (const auto* format : exports::all)
    for (const std::string_view other : format->other_names)
      if (!other.empty()) names.emplace_back(other);
  return names;
}

/// `value` of every contact of a packing, by its place.
template <int D, class Value> auto by_contact(const PackingIn<D>& packing, Value value) {
  std::vector<std::decay_t<decltype(value(std::size_t{}))>> values;
  for (std::size_t c = 0; c < packing.contacts.size(); ++c) values.push_back(value(c));
  return values;
}

/// The contact's kind: -1 with a wall, else the place of the pair of materials in 00, 01, .., 0m, 11, 12, .. .
template <int D> std::int32_t contact_type(const PackingIn<D>& packing, std::size_t contact) {
  if (packing.contacts.is_wall(contact)) return -1;
  const auto of = [&](std::int32_t grain) { return packing.grains.material[static_cast<std::size_t>(grain)]; };
  const auto [low, high] = std::minmax({of(packing.contacts.i[contact]), of(packing.contacts.j[contact])});
  const int kinds = static_cast<int>(packing.materials.size());
  return low * kinds - low * (low - 1) / 2 + (high - low);
}

/// The centre of j, or of its periodic image, as seen from i; for a wall the contact point.
template <int D> Vec<D> far_end(const PackingIn<D>& packing, std::size_t contact) {
  const auto& contacts = packing.contacts;
  const Vec<D> from = packing.grains.position[static_cast<std::size_t>(contacts.i[contact])];
  if (contacts.is_wall(contact)) return from + contacts.lever_i(contact);
  return from +
         packing.domain.nearest_image(packing.grains.position[static_cast<std::size_t>(contacts.j[contact])] - from);
}

/// Where the two bodies of a contact touch, m; on the side of grain i.
inline Vec2 contact_point(const Packing& packing, std::size_t contact) {
  return packing.grains.position[static_cast<std::size_t>(packing.contacts.i[contact])] +
         packing.contacts.lever_i(contact);
}

/// How many bonds and pulls across gaps each grain has: forces that no list of contacts holds. Empty where there are
/// none.
std::vector<int> links_of_grains(const Packing& packing);

/// Ids of the grains of a contact; the second is below 0 where it is none.
template <int D> std::int64_t id_of_i(const PackingIn<D>& p, std::size_t c) {
  return p.grains.id[static_cast<std::size_t>(p.contacts.i[c])];
}
template <int D> std::int64_t id_of_j(const PackingIn<D>& p, std::size_t c) {
  return p.contacts.is_wall(c) ? p.contacts.j[c] : p.grains.id[static_cast<std::size_t>(p.contacts.j[c])];
}

/// The class of the grain at every node of a map; 0 where there is none.
inline std::vector<std::uint8_t> class_of_node(const PhaseMap& map) {
  return mapped(map.grain, [&](std::int32_t g) {
    return static_cast<std::uint8_t>(g < 0 ? GrainClass::none : map.grain_class[static_cast<std::size_t>(g)]);
  });
}

}  // namespace arenite::io

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <span>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "core/mapped.hpp"
#include "io/export/export.hpp"
#include "io/results/groups.hpp"
#include "io/table/table.hpp"

namespace arenite::io {
namespace {

/// Its head, and what writes the cell of a row.
struct CsvColumn {
  std::string head;
  std::function<void(std::string& text, std::size_t row)> write;
};
using Columns = std::vector<CsvColumn>;

std::string table_of(const Columns& columns, std::size_t rows) {
  std::string text;
  const auto add_line = [&](auto add_cell) {
    for (const CsvColumn& column : columns) {
      if (&column != columns.data()) text += ',';
      add_cell(column);
    }
    text += '\n';
  };
  add_line([&](const CsvColumn& column) { text += column.head; });
  for (std::size_t row = 0; row < rows; ++row) add_line([&](const CsvColumn& column) { column.write(text, row); });
  return text;
}

/// `value(row)` as it is, a number as the shortest decimal that reads back as the same; an empty cell where it is not
/// known.
template <class Value> CsvColumn column(std::string head, Value value) {
  return {std::move(head), [value = std::move(value)](std::string& text, std::size_t row) {
            const auto of_row = value(row);
            if constexpr (std::is_floating_point_v<std::remove_const_t<decltype(of_row)>>)
              if (std::isnan(of_row)) return;
            fmt::format_to(std::back_inserter(text), "{}", of_row);
          }};
}

/// "name [unit]"; a number without unit is its name alone.
std::string title(const std::string& name, const std::string& unit) {
  return unit == "1" ? name : name + " [" + unit + "]";
}

/// Columns of results by their declarations, in the precision in which they are stored.
template <class Real = double, class Declared, class Owner>
void add(Columns& to, const Declared& declared, const Owner& owner) {
  for (const auto& c : declared)
    to.push_back(column(title(c.name, c.unit), [&](std::size_t row) { return static_cast<Real>(c.at(owner, row)); }));
}
/// Fields of an export, or columns of a curve.
template <class Field> void add(Columns& to, const std::vector<Field>& fields) {
  for (const auto& field : fields)
    to.push_back(column(title(field.name, field.unit), [&](std::size_t row) { return field.values[row]; }));
}

/// A number or word of a table of one row.
template <class Value> CsvColumn of_state(std::string head, Value value) {
  return column(std::move(head), [value = std::move(value)](std::size_t) { return value; });
}

/// When a state was, and the cell it was in: a row of a table that grows by one a state, its head before the first.
template <int D> NamedBytes state_row(const ExportStateIn<D>& from, Columns more = {}) {
  const SnapshotIn<D>& state = *from.snapshot;
  const DomainIn<D>& cell = state.packing.domain;
  Columns columns{of_state("state", from.number), of_state("stage", quoted_cell(from.stage)),
                  of_state("label", quoted_cell(state.label)), of_state("step", state.step),
                  of_state(title("time", "s"), state.time)};
  for (int axis = 0; axis < D; ++axis) {
    const std::string name(1, "xyz"[axis]);
    columns.push_back(of_state(title(name + "_low", "m"), cell.corner()[axis]));
    columns.push_back(of_state(title(name + "_high", "m"), cell.corner()[axis] + cell.extent(axis)));
    columns.push_back(of_state("periodic_" + name, cell.periodic[static_cast<std::size_t>(axis)] ? 1 : 0));
  }
  columns.push_back(of_state(title("tilt", "m"), cell.tilt));
  std::ranges::move(more, std::back_inserter(columns));
  std::string table = table_of(columns, 1);
  if (from.number > 0) table.erase(0, table.find('\n') + 1);
  return {"states.csv", std::move(table)};
}

std::string grain_table(const ExportSnapshot& from) {
  const Packing& packing = from.snapshot->packing;
  const Grains& g = packing.grains;
  const std::span declared(grain_state_columns);
  Columns columns{column("id", [&](std::size_t i) { return g.id[i]; })};
  add(columns, declared.first(2), g);  // the place
  columns.push_back(column(title("radius", "m"), [&](std::size_t i) { return g.radius[i]; }));
  columns.push_back(column("material", [&](std::size_t i) {
    return quoted_cell(packing.materials[static_cast<std::size_t>(g.material[i])].name);
  }));
  columns.push_back(column("zone", [&](std::size_t i) { return int{g.zone[i]}; }));
  add(columns, declared.subspan(2), g);
  add(columns, from.fields);
  const auto links = links_of_grains(packing);
  if (!links.empty()) columns.push_back(column("links", [&](std::size_t i) { return links[i]; }));
  return table_of(columns, g.size());
}

/// Of the grain, the boundary or the wall that a grain touches.
template <int D> std::string name_of_other(const PackingIn<D>& packing, std::size_t k) {
  const ContactsIn<D>& c = packing.contacts;
  if (c.is_boundary(k))
    return packing.domain.boundaries[static_cast<std::size_t>(packing.domain.boundary_of(c.element(k)))].name;
  if (c.is_wall(k)) return any_side_names[static_cast<std::size_t>(c.wall_side(k))];
  return std::to_string(id_of_j(packing, k));
}

/// The normal in these tables points from i to j, so it is the opposite of ours; fn and ft stay as they are.
std::string contact_table(const ExportSnapshot& from) {
  const Packing& packing = from.snapshot->packing;
  const Contacts& c = packing.contacts;
  const double mean = mean_compressive_force(c);
  Contacts opposite;
  opposite.normal = mapped(c.normal, [](Vec2 n) { return Vec2{0 - n.x, 0 - n.y}; });
  const std::span declared(contact_columns);
  Columns columns{column("i", [&](std::size_t k) { return id_of_i(packing, k); }),
                  column("j", [&](std::size_t k) { return quoted_cell(name_of_other(packing, k)); })};
  add(columns, declared.subspan(2, 2), c);  // forces
  add(columns, declared.first(2), opposite);
  columns.push_back(column("type", [&](std::size_t k) { return contact_type(packing, k); }));
  columns.push_back(column("strong", [&](std::size_t k) { return c.fn[k] > mean ? 1 : 0; }));
  columns.push_back(column("glued", [&](std::size_t k) { return int{c.glued[k]}; }));
  add(columns, declared.subspan(4), c);
  std::vector<Vec2> point;  // where grains that are no disks touch
  if (!c.off_i.empty()) point = by_contact(packing, [&](std::size_t k) { return contact_point(packing, k); });
  if (!point.empty())
    for (const auto& [name, axis] : {std::pair("x", &Vec2::x), std::pair("y", &Vec2::y)})
      columns.push_back(column(title(name, "m"), [&, axis = axis](std::size_t k) { return point[k].*axis; }));
  add(columns, from.of_contacts);
  return table_of(columns, c.size());
}

/// Spheres, and their contacts with the normal from i to j and the force on j; a wall by its name.
std::vector<NamedBytes> csv_spheres(const ExportSpheres& from) {
  const PackingIn<3>& packing = from.snapshot->packing;
  const GrainsIn<3>& g = packing.grains;
  const std::span grain_columns = state_columns(g);
  Columns grains{column("id", [&](std::size_t i) { return g.id[i]; })};
  add(grains, grain_columns.first(3), g);  // the place
  grains.push_back(column(title("radius", "m"), [&](std::size_t i) { return g.radius[i]; }));
  grains.push_back(column("material", [&](std::size_t i) {
    return quoted_cell(packing.materials[static_cast<std::size_t>(g.material[i])].name);
  }));
  add(grains, grain_columns.subspan(3), g);
  add(grains, from.fields);
  const ContactsIn<3>& c = packing.contacts;
  ContactsIn<3> opposite;
  opposite.normal = mapped(c.normal, [](Vec3 n) { return Vec3{0 - n.x, 0 - n.y, 0 - n.z}; });
  const auto force = by_contact(packing, [&](std::size_t k) { return Vec3{} - c.force_on_i(k); });  // on j
  Columns contacts{column("i", [&](std::size_t k) { return id_of_i(packing, k); }),
                   column("j", [&](std::size_t k) { return quoted_cell(name_of_other(packing, k)); })};
  add(contacts, columns_of(c).first(3), opposite);
  contacts.push_back(column(title("fn", "N"), [&](std::size_t k) { return c.fn[k]; }));
  for (const auto& [name, axis] : {std::pair("fx", &Vec3::x), std::pair("fy", &Vec3::y), std::pair("fz", &Vec3::z)})
    contacts.push_back(column(title(name, "N"), [&, axis = axis](std::size_t k) { return force[k].*axis; }));
  contacts.push_back(column(title("overlap", "m"), [&](std::size_t k) { return c.overlap[k]; }));
  return {{fmt::format("grains_{:04}.csv", from.number), table_of(grains, g.size())},
          {fmt::format("contacts_{:04}.csv", from.number), table_of(contacts, c.size())},
          state_row(from)};
}

std::string node_table(const FieldResult& r) {
  const PhaseMap& map = r.map;
  const auto width = static_cast<std::size_t>(map.width);
  const auto middle = [&](std::size_t k) { return fmt::format("{:.8g}", (static_cast<double>(k) + 0.5) * map.dx); };
  const auto classes = class_of_node(map);
  Columns columns{column(title("x", "m"), [&](std::size_t i) { return middle(i % width); }),
                  column(title("y", "m"), [&](std::size_t i) { return middle(i / width); }),
                  column("phase", [&](std::size_t i) { return static_cast<int>(map.phase[i]); }),
                  column("grain", [&](std::size_t i) { return map.grain[i]; }),
                  column("class", [&](std::size_t i) { return int{classes[i]}; })};
  if (r.field.size() > 0) add<float>(columns, field_columns, r.field);
  return table_of(columns, map.size());
}

std::string field_grain_table(const ExportField& from) {
  const auto& classes = from.result->map.grain_class;
  Columns columns{column("label", [](std::size_t g) { return g; }),
                  column("class", [&](std::size_t g) { return static_cast<int>(classes[g]); })};
  add(columns, from.fields);
  return table_of(columns, classes.size());
}

std::string curve_table(const History& curve) {
  Columns columns;
  add(columns, curve.columns);
  return table_of(columns, curve.columns.front().values.size());
}

/// Errors stand behind what they are of.
NamedBytes csv_curves(const ExportCurves& from) {
  Columns columns;
  for (const statistics::Column& c : from.curves.list) {
    const std::string unit = c.meaning.unit.empty() ? "1" : c.meaning.unit;
    columns.push_back(column(title(c.name, unit), [&](std::size_t row) { return c.values[row]; }));
    if (c.tells_errors)
      columns.push_back(column(title(c.name + "_error", unit), [&](std::size_t row) { return c.error[row]; }));
  }
  return {from.name + ".csv", table_of(columns, from.curves.list.front().values.size())};
}

std::vector<NamedBytes> csv_snapshot(const ExportSnapshot& snapshot) {
  return {{fmt::format("grains_{:04}.csv", snapshot.number), grain_table(snapshot)},
          {fmt::format("contacts_{:04}.csv", snapshot.number), contact_table(snapshot)},
          state_row(snapshot, {of_state(title("thickness", "m"), snapshot.snapshot->packing.domain.thickness)})};
}

/// Phases are 0 void, 1 matrix, 2 particle; classes 0 none, 1 small, 2 large.
std::vector<NamedBytes> csv_field(const ExportField& from) {
  const FieldResult& r = *from.result;
  std::vector<NamedBytes> files{{r.name + "_nodes.csv", node_table(r)},
                                {r.name + "_grains.csv", field_grain_table(from)}};
  if (!r.curve.columns.empty()) files.push_back({r.name + "_curve.csv", curve_table(r.curve)});
  return files;
}

}  // namespace

const ExportFormat exports::csv{
    .name = "csv",
    .sentence =
        "Tables of grains and contacts, which `arenite measure` also reads; of nodes and mean stresses of grains; of "
        "the "
        "curves of a test and of its cycles",
    .states =
        {{"grains",
          "place, radius, material, zone, velocity, angle, omega, stresses and other numbers of grains, units in "
          "the header"},
         {"contacts",
          "with grains, walls and boundaries: forces, normal from i to j, arms, overlap; of grains that are no "
          "disks the contact point x, y; of spheres fn and fx, fy, fz of the force on j"},
         {"curves of a test",
          "strains, stresses, ratios and densities row by row of a stage's history, and at both ends of each cycle; "
          "not with --last"},
         {"cell, thickness, step, time",
          "in states.csv, a row a state; `arenite measure` takes --box, --origin, --periodic and --thickness"},
         {"shapes of grains", "left out: a grain is the disk of its area; stress and contacts are those of the shapes"},
         {"bonds, pulls across gaps",
          "left out: `links` counts those of each grain, and `arenite measure` says that their stress lacks"},
         {"names that spreadsheets take for formulas",
          "written behind an apostrophe, which `arenite measure` takes away"}},
    .other_names = {"pandas", "tables"},
    .of_snapshot = csv_snapshot,
    .of_field = csv_field,
    .of_spheres = csv_spheres,
    .of_curves = csv_curves};

std::vector<int> links_of_grains(const Packing& packing) {
  std::vector<int> count;
  const auto add_link = [&](const auto& link) {
    count.resize(packing.grains.size(), 0);
    ++count[static_cast<std::size_t>(link.i)];
    ++count[static_cast<std::size_t>(link.j)];
  };
  for (const Bond& bond : packing.bonds)
    if (bond.broken == BondBreak::none) add_link(bond);
  for (const CohesivePair& pair : packing.cohesive)
    if (acts_across_gap(pair)) add_link(pair);
  return count;
}

}  // namespace arenite::io

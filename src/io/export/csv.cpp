#include <fmt/format.h>

#include <cmath>
#include <iterator>
#include <span>

#include "io/export/export.hpp"
#include "io/results/groups.hpp"
#include "io/table/table.hpp"

namespace arenite::io {
namespace {

using Text = std::back_insert_iterator<std::string>;

/// "name [unit]"; a number without unit is its name alone.
std::string title(const std::string& name, const std::string& unit) { return unit == "1" ? name : name + " [" + unit + "]"; }

/// What derived fields are called, each with a comma before it, and the end of the line.
std::string titles(const std::vector<GrainField>& fields) {
  std::string text;
  for (const auto& field : fields) text += "," + title(field.name, field.unit);
  return text + '\n';
}

/// Shortest decimal that reads back as the same double; an empty cell where nothing is known.
void cell(std::string& text, double value) {
  text += ',';
  if (!std::isnan(value)) fmt::format_to(Text(text), "{}", value);
}

std::string grain_table(const ExportFrame& from) {
  const Packing& packing = from.frame->packing;
  const Grains& g = packing.grains;
  std::string text = "id,x [m],y [m],radius [m],material,zone,angle [rad],vx [m/s],vy [m/s],omega [rad/s]" + titles(from.fields);
  for (std::size_t i = 0; i < g.size(); ++i) {
    fmt::format_to(Text(text), "{},{},{},{},{},{}", g.id[i], g.position[i].x, g.position[i].y, g.radius[i],
                   quoted_cell(packing.materials[static_cast<std::size_t>(g.material[i])].name), int{g.zone[i]});
    for (const double v : {g.angle[i], g.velocity[i].x, g.velocity[i].y, g.omega[i]}) cell(text, v);
    for (const auto& field : from.fields) cell(text, field.values[i]);
    text += '\n';
  }
  return text;
}

/// The normal in these tables points from i to j, so it is the opposite of ours; fn and ft stay as they are.
std::string contact_table(const ExportFrame& from) {
  const Packing& packing = from.frame->packing;
  const Contacts& c = packing.contacts;
  const double mean = mean_compressive_force(c);
  std::string text = "i,j,fn [N],ft [N],nx,ny,type,strong,glued,arm_i [m],arm_j [m],overlap [m],sliding_velocity [m/s]" + titles(from.of_contacts);
  for (std::size_t k = 0; k < c.size(); ++k) {
    const auto name = [&](std::int32_t grain) { return packing.grains.id[static_cast<std::size_t>(grain)]; };
    fmt::format_to(Text(text), "{},", name(c.i[k]));
    if (c.is_boundary(k)) text += packing.domain.boundaries[static_cast<std::size_t>(packing.domain.boundary_of(c.element(k)))].name;
    else if (c.is_wall(k)) text += side_names[static_cast<std::size_t>(c.wall_side(k))];
    else fmt::format_to(Text(text), "{}", name(c.j[k]));
    for (const double v : {c.fn[k], c.ft[k], 0 - c.normal[k].x, 0 - c.normal[k].y}) cell(text, v);
    fmt::format_to(Text(text), ",{},{},{}", contact_type(packing, k), c.fn[k] > mean ? 1 : 0, int{c.glued[k]});
    for (const double v : {c.arm_i[k], c.arm_j[k], c.overlap[k], c.sliding_velocity[k]}) cell(text, v);
    for (const auto& field : from.of_contacts) cell(text, field.values[k]);
    text += '\n';
  }
  return text;
}

std::string node_table(const FieldResult& r) {
  const PhaseMap& map = r.map;
  std::string text = "x [m],y [m],phase,grain,class";
  const std::span<const Column<StressField>> columns(field_columns, r.field.size() > 0 ? std::size(field_columns) : 0);
  for (const auto& c : columns) text += "," + title(c.name, c.unit);
  text += '\n';
  const auto classes = class_of_node(map);
  for (int y = 0; y < map.height; ++y)
    for (int x = 0; x < map.width; ++x) {
      const auto i = map.index(x, y);
      fmt::format_to(Text(text), "{:.8g},{:.8g},{},{},{}", (x + 0.5) * map.dx, (y + 0.5) * map.dx, static_cast<int>(map.phase[i]), map.grain[i], classes[i]);
      for (const auto& c : columns) fmt::format_to(Text(text), ",{}", static_cast<float>((r.field.*c.numbers)[i]));
      text += '\n';
    }
  return text;
}

std::string field_grain_table(const ExportField& from) {
  std::string text = "label,class" + titles(from.fields);
  const auto& classes = from.result->map.grain_class;
  for (std::size_t g = 0; g < classes.size(); ++g) {
    fmt::format_to(Text(text), "{},{}", g, static_cast<int>(classes[g]));
    for (const auto& field : from.fields) cell(text, field.values[g]);
    text += '\n';
  }
  return text;
}

std::string curve_table(const History& curve) {
  std::string text;
  for (const auto& column : curve.columns) text += (text.empty() ? "" : ",") + title(column.name, column.unit);
  text += '\n';
  for (std::size_t row = 0; row < curve.columns.front().values.size(); ++row) {
    for (std::size_t c = 0; c < curve.columns.size(); ++c) fmt::format_to(Text(text), "{}{}", c == 0 ? "" : ",", curve.columns[c].values[row]);
    text += '\n';
  }
  return text;
}

}  // namespace

std::vector<NamedBytes> csv_frame(const ExportFrame& frame) {
  return {{fmt::format("grains_{:04}.csv", frame.number), grain_table(frame)}, {fmt::format("contacts_{:04}.csv", frame.number), contact_table(frame)}};
}

/// Phases are 0 void, 1 matrix, 2 particle; classes 0 none, 1 small, 2 large.
std::vector<NamedBytes> csv_field(const ExportField& from) {
  const FieldResult& r = *from.result;
  std::vector<NamedBytes> files{{r.name + "_nodes.csv", node_table(r)}, {r.name + "_grains.csv", field_grain_table(from)}};
  if (!r.curve.columns.empty()) files.push_back({r.name + "_curve.csv", curve_table(r.curve)});
  return files;
}

}  // namespace arenite::io

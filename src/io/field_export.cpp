#include <fmt/format.h>

#include <cmath>
#include <iterator>

#include "io/export_frame.hpp"
#include "io/vtp.hpp"

namespace arenite::io {
namespace {

struct Component {
  const char* name;
  std::vector<double> StressField::*member;
};
constexpr Component stresses[] = {{"sigma_xx", &StressField::xx}, {"sigma_yy", &StressField::yy}, {"sigma_xy", &StressField::xy}};

template <class T>
std::vector<float> single(const std::vector<T>& values) {
  return {values.begin(), values.end()};
}

std::vector<float> displacement(const StressField& field) {
  std::vector<float> u(3 * field.size());
  for (std::size_t i = 0; i < field.size(); ++i) {
    u[3 * i] = static_cast<float>(field.ux[i]);
    u[3 * i + 1] = static_cast<float>(field.uy[i]);
  }
  return u;
}

std::vector<std::uint8_t> class_of_node(const PhaseMap& map) {
  std::vector<std::uint8_t> result;
  for (const std::int32_t g : map.grain) result.push_back(g < 0 ? 0 : static_cast<std::uint8_t>(map.grain_class[static_cast<std::size_t>(g)]));
  return result;
}

using Text = std::back_insert_iterator<std::string>;

std::string node_table(const FieldResult& r) {
  const PhaseMap& map = r.map;
  const bool loaded = r.field.size() > 0;
  std::string text = "x [m],y [m],phase,grain,class";
  if (loaded) text += ",ux [m],uy [m],sigma_xx [Pa],sigma_yy [Pa],sigma_xy [Pa]";
  text += '\n';
  const auto classes = class_of_node(map);
  for (int y = 0; y < map.height; ++y)
    for (int x = 0; x < map.width; ++x) {
      const auto i = map.index(x, y);
      fmt::format_to(Text(text), "{:.8g},{:.8g},{},{},{}", (x + 0.5) * map.dx, (y + 0.5) * map.dx, static_cast<int>(map.phase[i]), map.grain[i],
                     classes[i]);
      if (loaded)
        fmt::format_to(Text(text), ",{},{},{},{},{}", static_cast<float>(r.field.ux[i]), static_cast<float>(r.field.uy[i]),
                       static_cast<float>(r.field.xx[i]), static_cast<float>(r.field.yy[i]), static_cast<float>(r.field.xy[i]));
      text += '\n';
    }
  return text;
}

std::string grain_table(const ExportField& from) {
  std::string text = "label,class";
  for (const auto& field : from.fields) text += field.unit == "1" ? "," + field.name : fmt::format(",{} [{}]", field.name, field.unit);
  text += '\n';
  const auto& classes = from.result->map.grain_class;
  for (std::size_t g = 0; g < classes.size(); ++g) {
    fmt::format_to(Text(text), "{},{}", g, static_cast<int>(classes[g]));
    for (const auto& field : from.fields) {
      text += ',';
      if (!std::isnan(field.values[g])) fmt::format_to(Text(text), "{}", field.values[g]);
    }
    text += '\n';
  }
  return text;
}

std::string curve_table(const History& curve) {
  std::string text;
  for (const auto& column : curve.columns) text += (text.empty() ? "" : ",") + (column.unit == "1" ? column.name : column.name + " [" + column.unit + "]");
  text += '\n';
  for (std::size_t row = 0; row < curve.columns.front().values.size(); ++row) {
    for (std::size_t c = 0; c < curve.columns.size(); ++c) fmt::format_to(Text(text), "{}{}", c == 0 ? "" : ",", curve.columns[c].values[row]);
    text += '\n';
  }
  return text;
}

}  // namespace

std::vector<NamedBytes> vti_field(const ExportField& from) {
  const FieldResult& r = *from.result;
  VtkImage image{r.map.width, r.map.height, r.map.dx, {}};
  std::vector<std::uint8_t> phase;
  for (const Phase p : r.map.phase) phase.push_back(static_cast<std::uint8_t>(p));
  image.point_arrays = {{"phase", phase}, {"grain", r.map.grain}, {"class", class_of_node(r.map)}};
  if (r.field.size() > 0) {
    image.point_arrays.push_back({"displacement", displacement(r.field), 3});
    for (const auto& c : stresses) image.point_arrays.push_back({c.name, single(r.field.*c.member)});
  }
  return {{r.name + ".vti", vti_bytes(image)}};
}

/// Phases are 0 void, 1 matrix, 2 particle; classes 0 none, 1 small, 2 large.
std::vector<NamedBytes> csv_field(const ExportField& from) {
  const FieldResult& r = *from.result;
  std::vector<NamedBytes> files{{r.name + "_nodes.csv", node_table(r)}, {r.name + "_grains.csv", grain_table(from)}};
  if (!r.curve.columns.empty()) files.push_back({r.name + "_curve.csv", curve_table(r.curve)});
  return files;
}

}  // namespace arenite::io

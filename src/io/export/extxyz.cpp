#include <fmt/core.h>

#include "core/mapped.hpp"
#include "io/export/export.hpp"

namespace arenite::io {
namespace {

using Text = std::back_insert_iterator<std::string>;

/// A word: what would break a line or a quoted value becomes "_".
std::string word(std::string text) {
  for (char& c : text)
    if (c == ' ' || c == '\t' || c == '\n' || c == '\r' || c == '"' || c == '=' || c == ':') c = '_';
  return text.empty() ? "_" : text;
}

std::string comment_line(const ExportSnapshot& from) {
  const Domain& d = from.snapshot->packing.domain;
  std::string text = fmt::format("Lattice=\"{} 0 0 {} {} 0 0 0 {}\" Origin=\"{} {} {}\" pbc=\"{} {} F\"", d.width(), d.tilt, d.height(), d.thickness,
                                 d.wall[left].position, d.wall[bottom].position, -0.5 * d.thickness, d.periodic[0] ? "T" : "F", d.periodic[1] ? "T" : "F");
  fmt::format_to(Text(text), " Time={} Step={} Stage={} Label=\"{}\" Properties=species:S:1:pos:R:3:radius:R:1:id:I:1:zone:I:1:velo:R:3:angle:R:1:omega:R:1",
                 from.snapshot->time, from.snapshot->step, word(from.stage), word(from.snapshot->label));
  for (const auto& field : from.fields) text += ":" + word(field.name) + ":R:1";
  return text;
}

std::vector<NamedBytes> extxyz_snapshot(const ExportSnapshot& from) {
  const Packing& packing = from.snapshot->packing;
  const Grains& g = packing.grains;
  const auto species = mapped(packing.materials, [](const Material& material) { return word(material.name); });
  std::string text = fmt::format("{}\n{}\n", g.size(), comment_line(from));
  for (std::size_t i = 0; i < g.size(); ++i) {
    fmt::format_to(Text(text), "{} {} {} 0 {} {} {} {} {} 0 {} {}", species[static_cast<std::size_t>(g.material[i])], g.position[i].x, g.position[i].y,
                   g.radius[i], g.id[i], int{g.zone[i]}, g.velocity[i].x, g.velocity[i].y, g.angle[i], g.omega[i]);
    for (const auto& field : from.fields) fmt::format_to(Text(text), " {}", field.values[i]);
    text += '\n';
  }
  return {{"grains.extxyz", text}};
}

}  // namespace

const ExportFormat exports::extxyz{.name = "extxyz", .sentence = "OVITO and ASE: extended XYZ of grains", .of_snapshot = extxyz_snapshot};

}  // namespace arenite::io

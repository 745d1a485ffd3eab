#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "core/text.hpp"
#include "io/export/export.hpp"

namespace arenite::io {
namespace {

using Text = std::back_insert_iterator<std::string>;

/// A word of plain ASCII: what would break a line, a quoted value or a list becomes "_".
std::string word(std::string text) {
  for (char& c : text)
    if (!is_name_character(c) && c != '.' && c != '+') c = '_';
  return text.empty() ? "_" : text;
}

bool is_known(const GrainField& field) {
  return std::ranges::all_of(field.values, [](double v) { return std::isfinite(v); });
}

/// "1:POM 2:HDPE": the numbers of materials with their names.
std::string materials_of(const Materials& materials) {
  std::string names;
  for (std::size_t m = 0; m < materials.size(); ++m)
    names += fmt::format("{}{}:{}", m == 0 ? "" : " ", m + 1, word(materials[m].name));
  return names;
}

/// The second line: cell, moment and columns. ASE takes `species` for a chemical symbol, so it is X, none, for all
/// grains, and the material is a number whose name stands in `Materials`.
std::string comment_line(const ExportSnapshot& from) {
  const Packing& packing = from.snapshot->packing;
  const Domain& d = packing.domain;
  const auto yes = [](bool is) { return is ? "T" : "F"; };
  std::string text = fmt::format("Lattice=\"{} 0 0 {} {} 0 0 0 {}\" Origin=\"{} {} {}\" pbc=\"{} {} F\"", d.width(),
                                 d.tilt, d.height(), d.thickness, d.wall[left].position, d.wall[bottom].position,
                                 -0.5 * d.thickness, yes(d.periodic[0]), yes(d.periodic[1]));
  std::string left_out;
  for (const auto& field : from.fields)
    if (!is_known(field)) left_out += (left_out.empty() ? "" : " ") + word(field.name);
  fmt::format_to(Text(text), " Time={} Step={} Stage=\"{}\" Label=\"{}\" Materials=\"{}\"", from.snapshot->time,
                 from.snapshot->step, word(from.stage), word(from.snapshot->label), materials_of(packing.materials));
  if (!left_out.empty()) text += " LeftOut=\"" + left_out + '"';
  text += " Properties=species:S:1:pos:R:3:radius:R:1:id:I:1:material:I:1:zone:I:1:velo:R:3:angle:R:1:omega:R:1";
  for (const auto& field : from.fields)
    if (is_known(field)) text += ":" + word(field.name) + ":R:1";
  return text;
}

std::vector<NamedBytes> extxyz_spheres(const ExportSpheres& from) {
  const PackingIn<3>& packing = from.snapshot->packing;
  const DomainIn<3>& d = packing.domain;
  const GrainsIn<3>& g = packing.grains;
  const auto yes = [&](int axis) { return d.periodic[static_cast<std::size_t>(axis)] ? "T" : "F"; };
  std::string text = fmt::format(
      "{}\nLattice=\"{} 0 0 {} {} 0 0 0 {}\" Origin=\"{} {} {}\" pbc=\"{} {} {}\" Time={} Step={} Stage=\"{}\" "
      "Materials=\"{}\"",
      g.size(), d.extent(0), d.tilt, d.extent(1), d.extent(2), d.corner().x, d.corner().y, d.corner().z, yes(0), yes(1),
      yes(2), from.snapshot->time, from.snapshot->step, word(from.stage), materials_of(packing.materials));
  text += " Properties=species:S:1:pos:R:3:radius:R:1:id:I:1:material:I:1:velo:R:3:omega:R:3";
  for (const auto& field : from.fields) text += ":" + word(field.name) + ":R:1";
  text += '\n';
  for (std::size_t i = 0; i < g.size(); ++i) {
    fmt::format_to(Text(text), "X {} {} {} {} {} {} {} {} {} {} {} {}", g.position[i].x, g.position[i].y,
                   g.position[i].z, g.radius[i], g.id[i], g.material[i] + 1, g.velocity[i].x, g.velocity[i].y,
                   g.velocity[i].z, g.omega[i].x, g.omega[i].y, g.omega[i].z);
    for (const auto& field : from.fields) fmt::format_to(Text(text), " {}", field.values[i]);
    text += '\n';
  }
  return {{"grains.extxyz", text}};
}

std::vector<NamedBytes> extxyz_snapshot(const ExportSnapshot& from) {
  const Grains& g = from.snapshot->packing.grains;
  std::string text = fmt::format("{}\n{}\n", g.size(), comment_line(from));
  for (std::size_t i = 0; i < g.size(); ++i) {
    fmt::format_to(Text(text), "X {} {} 0 {} {} {} {} {} {} 0 {} {}", g.position[i].x, g.position[i].y, g.radius[i],
                   g.id[i], g.material[i] + 1, int{g.zone[i]}, g.velocity[i].x, g.velocity[i].y, g.angle[i],
                   g.omega[i]);
    for (const auto& field : from.fields)
      if (is_known(field)) fmt::format_to(Text(text), " {}", field.values[i]);
    text += '\n';
  }
  return {{"grains.extxyz", text}};
}

}  // namespace

const ExportFormat exports::extxyz{
    .name = "extxyz",
    .sentence = "ASE: extended XYZ of grains (OVITO reads the format; no test of ours runs it)",
    .states = {{"grains",
                "place, radius, id, material, zone, velocity, angle, omega, stresses and other numbers of grains"},
               {"species",
                "X, which is no chemical element: ASE refuses others. `material` is a number, `Materials` names them"},
               {"cell, periodic sides, time, step, stage", "in the second line of each state, in m and s"},
               {"numbers not known of some grain", "the column is left out, and `LeftOut` names it"},
               {"shapes of grains", "left out: a grain is the disk of its area"},
               {"contacts, walls, boundaries, bonds", "left out; `vtk`, `lammps`, `netcdf` and `csv` have contacts"}},
    .other_names = {"ase", "xyz"},
    .of_snapshot = extxyz_snapshot,
    .of_spheres = extxyz_spheres};

}  // namespace arenite::io

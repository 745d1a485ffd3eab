#include "io/sample/materials.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cstdint>
#include <set>
#include <string>
#include <unordered_map>
#include <vector>

#include "io/sample/formats.hpp"
#include "io/table/text_file.hpp"

namespace arenite::io {
namespace {

/// What a label that is only a number is called, so that "1-2" does not have to be read as a pair.
std::string readable(const std::string& label) {
  if (label.empty()) return "grain";
  return to_integer(label) ? "type" + label : label;
}

/// What the file of grains calls a material, or else its label.
std::string name_of(const std::string& label, const RawGrains& raw) {
  const auto named = raw.material_name.find(label);
  return named == raw.material_name.end() ? readable(label) : named->second;
}

struct Property {
  const char* column;
  Dimension dimension;
  double Material::*member;
};
constexpr Property properties[] = {
    {"density", dimension::density, &Material::density},
    {"stiffness", dimension::stiffness, &Material::stiffness},
    {"thermoelastic_factor", dimension::thermoelastic_factor, &Material::thermoelastic_factor},
};

Material read_material(const Table& table, const Table::Row& row, const std::string& label, Problems& problems) {
  const auto name = table.find({"name"});
  Material material;
  material.name = name ? std::string(row.cells[*name]) : readable(label);
  for (const Property& property : properties) {
    const auto column = table.find({property.column});
    if (!column) continue;
    const double factor = factor_or_problem(table.columns[*column].unit, property.column, property.dimension, 1,
                                            table.header_line, problems);
    material.*property.member = number_or_problem(row.cells[*column], property.column, factor, row.line, problems);
  }
  return material;
}

/// Reads the table: labels with their materials, or the label of every grain.
struct MaterialTable {
  std::vector<std::string> labels;
  Materials materials;
  std::unordered_map<std::int64_t, std::string> of_grain;
};

MaterialTable read_material_table(const std::filesystem::path& file) {
  Problems problems(file.string());
  const std::string text = read_text(file);
  const Table table = read_table(text, {}, problems);
  const auto label = table.find({"material"}), id = table.find({"id", "grain"});
  if (!label)
    problems.add(table.header_line,
                 "there is no column \"material\"; give material,name,density [kg/m^3],stiffness [N/m] or id,material");
  MaterialTable result;
  for (const auto& row : table.rows) {
    if (!label) break;
    const std::string name(row.cells[*label]);
    if (id) {
      result.of_grain[integer_or_problem(row.cells[*id], "id", row.line, problems)] = name;
      continue;
    }
    if (std::find(result.labels.begin(), result.labels.end(), name) != result.labels.end())
      problems.add(row.line, "material \"{}\" appears twice; keep one row", name);
    result.labels.push_back(name);
    result.materials.push_back(read_material(table, row, name, problems));
  }
  problems.raise();
  return result;
}

/// The materials of all grains where each is a number, in rising order; empty if any is a name.
std::set<std::int64_t> numbers_of(const RawGrains& raw, const std::unordered_map<std::int64_t, std::string>& of_grain) {
  std::set<std::int64_t> numbers;
  for (const RawGrain& grain : raw.rows) {
    const auto it = of_grain.find(grain.id);
    const std::string& label = it == of_grain.end() ? grain.material : it->second;
    const auto number = to_integer(label);
    if (!number || std::to_string(*number) != label) return {};
    numbers.insert(*number);
  }
  return numbers;
}

}  // namespace

void assign_materials(const RawGrains& raw, const std::optional<std::filesystem::path>& file, Materials& materials,
                      std::vector<std::int32_t>& of_grain, std::vector<std::string>& notes, Problems& problems) {
  MaterialTable table;
  if (file) table = read_material_table(*file);
  const bool closed = !table.labels.empty();  // then a label that is not in the table is a slip
  materials = table.materials;
  if (!closed) {  // numbered types in the order of their numbers, names in the order of their first grain
    for (std::int64_t type : numbers_of(raw, table.of_grain)) {
      table.labels.push_back(std::to_string(type));
      materials.push_back({name_of(table.labels.back(), raw), 0, 0, 0});
    }
  }
  std::vector<std::size_t> unnamed;
  for (std::size_t g = 0; g < raw.rows.size(); ++g) {
    std::string label = raw.rows[g].material;
    if (const auto it = table.of_grain.find(raw.rows[g].id); it != table.of_grain.end()) label = it->second;
    if (label.empty()) unnamed.push_back(g);
    if (label.empty() && closed && table.labels.size() == 1) label = table.labels.front();
    auto it = std::find(table.labels.begin(), table.labels.end(), label);
    if (it == table.labels.end()) {
      if (closed) {
        const std::string near = nearest(label, table.labels);
        problems.add(raw.rows[g].line, "material \"{}\" is not in {}; {}", label, file->string(),
                     near.empty() ? "add it there" : fmt::format("did you mean \"{}\"?", near));
        continue;
      }
      table.labels.push_back(label);
      materials.push_back({name_of(label, raw), 0, 0, 0});
      it = table.labels.end() - 1;
    }
    of_grain[g] = static_cast<std::int32_t>(it - table.labels.begin());
  }
  if (unnamed.empty() || unnamed.size() == raw.rows.size()) return;
  const RawGrain& first = raw.rows[unnamed.front()];
  notes.push_back(fmt::format(
      "{} of {} grains state no material, the first, {}, in line {}; they are of the material \"{}\".", unnamed.size(),
      raw.rows.size(), first.id, first.line, materials[static_cast<std::size_t>(of_grain[unnamed.front()])].name));
}

}  // namespace arenite::io

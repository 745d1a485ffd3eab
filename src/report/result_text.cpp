#include "report/result_text.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "statistics/estimate.hpp"

namespace arenite::report {
namespace {

void add_notes(TextLines& lines, const Numbers& numbers) {
  if (numbers.contains("notes"))
    for (const auto& note : numbers["notes"]) lines.raw("  " + note.get<std::string>());
}

void describe_sample(TextLines& lines) {
  lines.section("Sample on the nodes", {{"nodes along x", "/map/width"}, {"nodes along y", "/map/height"},
                                        {"distance of nodes", "/map/dx_m", "m"}, {"lengths", "/map/lengths"},
                                        {"grains", "/grains/all"},
                                        {"share of particles", "/phases/particle"},
                                        {"share of large grains", "/phases/large"}, {"share of small grains", "/phases/small"},
                                        {"share of matrix", "/phases/matrix"}, {"share of void", "/phases/void"},
                                        {"S_m (matrix in the pore space)", "/S_m"}, {"S_m by geometry", "/exact/S_m"},
                                        {"solid from bottom to top", "/percolates/solid_bottom_top"},
                                        {"void from left to right", "/percolates/void_left_right"},
                                        {"nodes across the thinnest joint", "/raster/thinnest_joint_nodes"},
                                        {"joints without a node", "/raster/lost_joints"},
                                        {"nodes across the smallest grain", "/raster/smallest_grain_nodes"}});
  if (lines.has("/coordination")) lines.heading("Neighbours by surface gap");
  lines.number("gap", "/coordination/gap_m", "m");
  for (const char* name : {"Z", "Z_l", "Z_s", "Z_ll", "Z_ls", "Z_sl", "Z_ss"}) lines.number(name, fmt::format("/coordination/{}", name));
  lines.heading("Pores and voids (volumes over pi times the reference radius squared)");
  for (const char* kind : {"pores", "voids"})
    for (const char* name : {"count", "mean", "deviation", "cv"}) lines.number(fmt::format("{} {}", kind, name), fmt::format("/{}/{}", kind, name));
}

void describe_load(TextLines& lines) {
  lines.section("Load", {{"loading", "/load/loading"}, {"along", "/load/axis"}, {"strain", "/load/strain"},
                         {"ending", "/load/ending"}, {"iterations", "/load/iterations"}, {"residual", "/load/residual"},
                         {"defect of the reaction identity", "/load/identity_defect"},
                         {"apparent modulus", "/modulus_Pa", "Pa"}, {"Poisson's ratio", "/poisson"},
                         {"E along x", "/moduli/E_x_Pa", "Pa"}, {"E along y", "/moduli/E_y_Pa", "Pa"},
                         {"nu, pulled along x", "/moduli/nu_xy"}, {"nu, pulled along y", "/moduli/nu_yx"}, {"G", "/moduli/G_Pa", "Pa"},
                         {"strength", "/strength_Pa", "Pa"}, {"strain at strength", "/failure/strain_at_strength"},
                         {"broken bonds, matrix", "/failure/broken/matrix"},
                         {"broken bonds, interface", "/failure/broken/interface"},
                         {"broken bonds, particle", "/failure/broken/particle"},
                         {"defect of the energy balance", "/failure/energy_defect"}});
}

void describe_component(TextLines& lines, const std::string& name, const Numbers& component) {
  lines.heading(fmt::format("Node stresses, {}", name));
  if (component.contains("sample_mean_Pa")) lines.raw(fmt::format("  {:<34} {} Pa", "mean of the sample", shown(component["sample_mean_Pa"])));
  if (!component.contains("sets")) return;
  lines.raw(fmt::format("  {:<10} {:>20} {:>20} {:>20} {:>20} {:>20}", "", "mean/sample mean", "variance", "excess kurtosis", "tail slope s", "q"));
  for (const auto& [set, d] : component["sets"].items()) {
    const auto cell = [&d = d](const char* path) {
      const Numbers* at = d.at_path(path);
      return at ? shown(*at) : std::string("-");
    };
    lines.raw(fmt::format("  {:<10} {:>20} {:>20} {:>20} {:>20} {:>20}", set, cell("/mean_over_sample_mean"), cell("/variance"),
                          cell("/excess_kurtosis"), cell("/tail/slope"), cell("/q_gaussian/q")));
  }
}

}  // namespace

std::string shown(const Numbers& j) {
  if (j.is_integer()) return to_json(j);
  if (j.is_number()) return fmt::format("{:.5g}", j.get<double>());
  if (j.is_truth()) return j.get<bool>() ? "yes" : "no";
  if (j.is_text()) return j.get<std::string>();
  if (!j.is_tree() || !j.contains("value") || !j["value"].is_known()) return {};
  const double value = j["value"].get<double>();
  return j.contains("error") && j["error"].is_number() ? statistics::with_error({value, j["error"].get<double>()}) : fmt::format("{:.5g}", value);
}

void TextLines::add(const std::string& name, const std::string& value) {
  if (!value.empty()) text_ += fmt::format("  {:<34} {}\n", name, value);
}

void TextLines::add(const std::string& name, const std::string& value, const std::string& meaning) {
  if (value.empty()) return;
  std::string line = fmt::format("  {:<28} {:<22}{}", name, value, meaning.empty() ? "" : "  " + meaning);
  line.erase(line.find_last_not_of(' ') + 1);
  raw(line);
}

std::string TextLines::value_at(const std::string& path, const char* unit) const {
  const Numbers* at = root_->at_path(path);
  const std::string value = at ? shown(*at) : "";
  return value.empty() || !*unit ? value : value + " " + unit;
}

void TextLines::number(const std::string& name, const std::string& path, const char* unit) { add(name, value_at(path, unit)); }

void TextLines::number(const std::string& name, const std::string& path, const char* unit, const char* meaning) { add(name, value_at(path, unit), meaning); }

void TextLines::numbers(std::initializer_list<Row> rows) {
  for (const Row& row : rows) number(row.name, row.path, row.unit);
}

void TextLines::section(const std::string& text, std::initializer_list<Row> rows) {
  heading(text);
  numbers(rows);
}

void TextLines::block(std::string_view lines) {
  while (!lines.empty()) {
    const auto length = std::min(lines.find('\n'), lines.size());
    raw(fmt::format("  {}", lines.substr(0, length)));
    lines.remove_prefix(std::min(length + 1, lines.size()));
  }
}

std::string field_headlines(const Numbers& numbers) {
  TextLines rows(numbers);
  rows.heading("Sample on the nodes");
  rows.number("lengths", "/map/lengths", "", "");
  rows.number("grains", "/grains/all", "", "");
  rows.number("void", "/phases/void", "", "share of the area");
  rows.number("matrix", "/phases/matrix", "", "share of the area");
  rows.number("S_m", "/S_m", "", "share of the space between grains that matrix fills");
  rows.number("neighbours Z", "/coordination/Z", "", "grains whose surfaces are near, of a grain");
  rows.number("pores", "/pores/count", "", "spaces between grains, matrix or not");
  rows.number("mean volume of pores", "/pores/mean", "", "over pi times the reference radius squared");
  rows.number("voids", "/voids/count", "", "spaces that nothing fills");
  if (numbers.contains("load")) rows.heading("Under load");
  rows.number("modulus E", "/modulus_Pa", "Pa", "mean stress over strain");
  rows.number("Poisson's ratio nu", "/poisson", "", "");
  rows.number("E along x", "/moduli/E_x_Pa", "Pa", "");
  rows.number("E along y", "/moduli/E_y_Pa", "Pa", "");
  rows.number("shear modulus G", "/moduli/G_Pa", "Pa", "");
  rows.number("strength", "/strength_Pa", "Pa", "greatest mean stress");
  rows.number("strain at strength", "/failure/strain_at_strength", "", "");
  if (const Numbers* sets = numbers.at_path("/stress/sigma_yy/sets")) {
    rows.heading("Vertical stress by phase over the mean of the sample");
    for (const auto& [name, set] : sets->items())
      if (set.contains("mean_over_sample_mean")) rows.add(name, shown(set["mean_over_sample_mean"]), "");
  }
  add_notes(rows, numbers);
  return std::move(rows).text();
}

std::string field_text(const Numbers& numbers) {
  TextLines lines(numbers);
  describe_sample(lines);
  if (numbers.contains("load")) describe_load(lines);
  if (numbers.contains("stress"))
    for (const auto& [name, part] : numbers["stress"].items())
      if (name.starts_with("sigma_")) describe_component(lines, name, part);
  if (numbers.contains("grain_stress_against_contacts")) {
    lines.heading("Mean stresses of grains against those from contact forces");
    for (const char* component : {"sigma_yy", "sigma_hyd"})
      lines.number(fmt::format("correlation, {}", component), fmt::format("/grain_stress_against_contacts/{}/all/correlation", component));
  }
  add_notes(lines, numbers);
  return std::move(lines).text();
}

}  // namespace arenite::report

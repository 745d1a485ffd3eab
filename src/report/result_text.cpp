#include "report/result_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "grains/dem/run_stage.hpp"
#include "io/table/table.hpp"
#include "recipe/recipe.hpp"

namespace arenite::report {
namespace {

void add_notes(TextLines& lines, const Numbers& numbers) {
  if (numbers.contains("notes"))
    for (const auto& note : numbers["notes"]) lines.raw("  " + note.get<std::string>());
}

void describe_sample(TextLines& lines) {
  lines.section("Sample on the nodes", {{"nodes along x", "/map/width"},
                                        {"nodes along y", "/map/height"},
                                        {"distance of nodes", "/map/dx_m", "m"},
                                        {"lengths", "/map/lengths"},
                                        {"grains", "/grains/all"},
                                        {"share of particles", "/phases/particle"},
                                        {"share of large grains", "/phases/large"},
                                        {"share of small grains", "/phases/small"},
                                        {"share of matrix", "/phases/matrix"},
                                        {"share of void", "/phases/void"},
                                        {"S_m (matrix in the pore space)", "/S_m"},
                                        {"S_m by geometry", "/exact/S_m"},
                                        {"solid from bottom to top", "/percolates/solid_bottom_top"},
                                        {"void from left to right", "/percolates/void_left_right"},
                                        {"nodes across the thinnest neck", "/grid/thinnest_neck_nodes"},
                                        {"necks without a node", "/grid/lost_necks"},
                                        {"nodes across the smallest grain", "/grid/smallest_grain_nodes"}});
  if (lines.has("/coordination")) lines.heading("Neighbours by surface gap");
  lines.number("gap", "/coordination/gap_m", "m");
  for (const char* name : {"Z", "Z_l", "Z_s", "Z_ll", "Z_ls", "Z_sl", "Z_ss"}) lines.number(name, fmt::format("/coordination/{}", name));
  lines.heading("Pores and voids (volumes over pi times the reference radius squared)");
  for (const char* kind : {"pores", "voids"})
    for (const char* name : {"count", "mean", "deviation", "cv"}) lines.number(fmt::format("{} {}", kind, name), fmt::format("/{}/{}", kind, name));
}

void describe_load(TextLines& lines) {
  lines.section("Load", {{"loading", "/load/loading"},
                         {"along", "/load/axis"},
                         {"strain", "/load/strain"},
                         {"ending", "/load/ending"},
                         {"iterations", "/load/iterations"},
                         {"residual", "/load/residual"},
                         {"reaction-force balance error", "/load/reaction_balance_error"},
                         {"apparent modulus", "/modulus_Pa", "Pa"},
                         {"Poisson's ratio", "/poisson"},
                         {"E along x", "/moduli/E_x_Pa", "Pa"},
                         {"E along y", "/moduli/E_y_Pa", "Pa"},
                         {"nu, pulled along x", "/moduli/nu_xy"},
                         {"nu, pulled along y", "/moduli/nu_yx"},
                         {"G", "/moduli/G_Pa", "Pa"},
                         {"strength", "/strength_Pa", "Pa"},
                         {"strain at strength", "/failure/strain_at_strength"},
                         {"broken bonds, matrix", "/failure/broken/matrix"},
                         {"broken bonds, interface", "/failure/broken/interface"},
                         {"broken bonds, particle", "/failure/broken/particle"},
                         {"error of the energy balance", "/failure/energy_balance_error"}});
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
    lines.raw(fmt::format("  {:<10} {:>20} {:>20} {:>20} {:>20} {:>20}", set, cell("/mean_over_sample_mean"), cell("/variance"), cell("/excess_kurtosis"),
                          cell("/tail/slope"), cell("/q_gaussian/q")));
  }
}

void add(TextLines& rows, const std::string& name, const statistics::Estimate& e, const std::string& meaning, const char* unit = "") {
  if (std::isfinite(e.value)) rows.add(name, statistics::with_error(e) + unit, meaning);
}

std::string grains_of(const Packing& packing) {
  const std::size_t all = packing.grains.size();
  if (packing.materials.size() < 2) return std::to_string(all);
  std::string parts;
  for (std::size_t m = 0; m < packing.materials.size(); ++m) {
    const auto count = std::count(packing.grains.material.begin(), packing.grains.material.end(), static_cast<std::int32_t>(m));
    parts += fmt::format("{}{} {}", m > 0 ? ", " : "", count, packing.materials[m].name);
  }
  return fmt::format("{}: {}", all, parts);
}

std::string forces_on_sides(const Domain& domain) {
  std::string text;
  for (std::size_t side = 0; side < domain.wall.size(); ++side)
    if (const double f = domain.wall[side].force; domain.wall[side].present)
      text += fmt::format("{}{} {}", text.empty() ? "" : ", ", side_names[side],
                          std::abs(f) < 1e4 ? fmt::format("{:.4g} N", f) : fmt::format("{:.4g} kN", 1e-3 * f));
  return text;
}

/// The criterion that the stage was judged by, or would have been if it had not ended by its time.
dem::EquilibriumCriterion criterion_of(const Provenance& made) {
  try {
    const recipe::Recipe recipe = recipe::parse_recipe(made.recipe, "recipe");
    for (const auto& stage : recipe.stages)
      if (stage.name == made.stage) return stage.equilibrium;
  } catch (const InputError&) {}
  return {};
}

std::string state_of(const StageResult& last) {
  const Equilibrium& now = last.frames.back().equilibrium;
  const bool rests = last.converged && dem::is_at_rest(now, criterion_of(last.provenance));
  return fmt::format("{}: {}", rests ? "in equilibrium" : "NOT IN EQUILIBRIUM", dem::describe(now));
}

void add_forces(TextLines& rows, const texture::Texture& t) {
  if (const auto* all = texture::find(t.force.compressive, "all")) {
    add(rows, "mean normal force <F>", all->mean, "of contacts that push", " N");
    add(rows, "fraction above the mean P_0", all->fraction_above_mean, "of contacts with F > <F>");
    add(rows, "strong forces' decay beta", all->tail.beta, "P(F) ~ exp(-beta F/<F>) for F > <F>");
  }
  const texture::Stress& s = t.stress;
  if (!std::isfinite(s.whole.value.xx)) return;
  const auto [unit, scale] = statistics::stress_unit(std::abs(s.pressure) + s.deviator);
  rows.add("pressure p", fmt::format("{:.4g} {}", s.pressure * scale + 0.0, unit), "mean of the principal stresses, compression positive");
  if (s.pressure > 0)
    rows.add("deviator over pressure q/p", fmt::format("{:.3g}", s.deviator / s.pressure), "q: half the difference of the principal stresses");
}

void add_fabric(TextLines& rows, const texture::Texture& t) {
  add(rows, "solid fraction", t.solid_fraction, "area of grains over area of the sample");
  if (const auto* z = texture::find(t.coordination.mean, "all")) add(rows, "coordination z", *z, "contacts of a grain with others");
  if (const auto* z = texture::find(t.coordination.mean, "all without rattlers")) add(rows, "z without rattlers", *z, "of grains that carry force");
  if (const auto* z = texture::find(t.coordination.mean, "all, neighbours"))
    add(rows, "touching neighbours", *z, "grains that a grain touches, in one contact or more");
  if (t.long_axes.grains > 0) add(rows, "order of long axes", t.long_axes.order, fmt::format("0: at random; random ones give {:.2g}", t.long_axes.noise));
  add(rows, "rattlers", t.coordination.rattlers, "share of grains with fewer than two contacts that carry force");
  if (const auto* all = texture::find(t.fabric, "all"))
    add(rows, "contact anisotropy a_c", all->a_c, fmt::format("0: contacts in all directions alike; random ones give {:.2g}", all->noise));
}

}  // namespace

std::string shown(const Numbers& j) {
  if (j.is_integer()) return to_json(j);
  if (j.is_number()) return fmt::format("{:.5g}", j.get<double>());
  if (j.is_truth()) return j.get<bool>() ? "yes" : "no";
  if (j.is_text()) return j.get<std::string>();
  if (!j.is_tree() || !j.contains("value") || !j["value"].is_number()) return {};
  const double value = j["value"].get<double>();
  return j.contains("error") && j["error"].is_number() ? statistics::with_error({value, j["error"].get<double>()}) : fmt::format("{:.5g}", value);
}

void TextLines::add(const std::string& name, const std::string& value, const std::string& meaning) {
  if (value.empty()) return;
  if (layout_ == Layout::plain) return raw(fmt::format("  {:<34} {}", name, value));
  std::string line = fmt::format("  {:<28} {:<22}{}", name, value, meaning.empty() ? "" : "  " + meaning);
  line.erase(line.find_last_not_of(' ') + 1);
  raw(line);
}

void TextLines::number(const std::string& name, const std::string& path, const char* unit, const char* meaning) {
  const Numbers* at = root_->at_path(path);
  const std::string value = at ? shown(*at) : "";
  add(name, value.empty() || !*unit ? value : value + " " + unit, meaning);
}

void TextLines::numbers(std::initializer_list<Row> rows) {
  for (const Row& row : rows) number(row.name, row.path, row.unit, row.meaning);
}

void TextLines::section(const std::string& text, std::initializer_list<Row> rows) {
  heading(text);
  numbers(rows);
}

void TextLines::block(std::string_view lines) {
  io::Lines rest(lines);
  for (std::string_view line; rest.next(line);) raw(fmt::format("  {}", line));
}

std::string headlines(const StageResult& last, const texture::Texture& t) {
  TextLines rows(TextLines::Layout::explained);
  const Frame& frame = last.frames.back();
  rows.heading(fmt::format("Last state: {} of {}", frame.label, last.name));
  if (!last.provenance.kernel.empty()) rows.add("state", state_of(last));
  rows.add("grains", grains_of(frame.packing));
  rows.add("contacts", fmt::format("{} between grains, {} with walls", t.contacts, t.wall_contacts));
  rows.add("forces on the walls", forces_on_sides(frame.packing.domain));
  rows.heading("Away from the walls, each +- its standard error");
  add_fabric(rows, t);
  add_forces(rows, t);
  std::string text = std::move(rows).text();
  for (const auto& note : t.notes) text += "  note: " + note + "\n";
  return text;
}

std::string field_headlines(const Numbers& numbers) {
  TextLines rows(numbers, TextLines::Layout::explained);
  rows.section("Sample on the nodes", {{"lengths", "/map/lengths"},
                                       {"grains", "/grains/all"},
                                       {"void", "/phases/void", "", "share of the area"},
                                       {"matrix", "/phases/matrix", "", "share of the area"},
                                       {"S_m", "/S_m", "", "share of the space between grains that matrix fills"},
                                       {"neighbours Z", "/coordination/Z", "", "grains whose surfaces are near, of a grain"},
                                       {"pores", "/pores/count", "", "spaces between grains, matrix or not"},
                                       {"mean volume of pores", "/pores/mean", "", "over pi times the reference radius squared"},
                                       {"voids", "/voids/count", "", "spaces that nothing fills"}});
  if (numbers.contains("load")) rows.heading("Under load");
  rows.numbers({{"modulus E", "/modulus_Pa", "Pa", "mean stress over strain"},
                {"Poisson's ratio nu", "/poisson"},
                {"E along x", "/moduli/E_x_Pa", "Pa"},
                {"E along y", "/moduli/E_y_Pa", "Pa"},
                {"shear modulus G", "/moduli/G_Pa", "Pa"},
                {"strength", "/strength_Pa", "Pa", "greatest mean stress"},
                {"strain at strength", "/failure/strain_at_strength"}});
  if (const Numbers* sets = numbers.at_path("/stress/sigma_yy/sets")) {
    rows.heading("Vertical stress by phase over the mean of the sample");
    for (const auto& [name, set] : sets->items())
      if (set.contains("mean_over_sample_mean")) rows.add(name, shown(set["mean_over_sample_mean"]));
  }
  add_notes(rows, numbers);
  return std::move(rows).text();
}

std::string described(const Numbers& numbers) {
  std::string text;
  for (const auto& [name, number, meaning] : named_numbers(numbers)) {
    const std::string value = shown(*number), unit = meaning ? meaning->unit : "";
    if (!value.empty()) text += fmt::format("{:<48} {:<26} {}\n", name, value + (unit.empty() ? "" : " " + unit), meaning ? meaning->sentence : "");
  }
  return text;
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

#include "report/headlines.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/error.hpp"
#include "grains/dem/run_stage.hpp"
#include "report/number_lines.hpp"
#include "statistics/numbers.hpp"
#include "statistics/text.hpp"
#include "recipe/recipe.hpp"

namespace arenite::report {
namespace {

using statistics::with_error;

/// Rows "name  value  meaning" in three columns; those without a value are left out.
class Rows {
 public:
  void heading(const std::string& text) { text_ += "\n" + text + "\n"; }
  void add(const std::string& name, const std::string& value, const std::string& meaning = "") {
    if (value.empty()) return;
    std::string line = fmt::format("  {:<28} {:<22}{}", name, value, meaning.empty() ? "" : "  " + meaning);
    line.erase(line.find_last_not_of(' ') + 1);
    text_ += line + "\n";
  }
  void add(const std::string& name, const statistics::Estimate& e, const std::string& unit, const std::string& meaning, double scale = 1) {
    if (std::isfinite(e.value)) add(name, with_error(e, scale) + (unit.empty() ? "" : " " + unit), meaning);
  }
  std::string text() && { return std::move(text_); }

 private:
  std::string text_;
};

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
      text += fmt::format("{}{} {}", text.empty() ? "" : ", ", side_names[side], std::abs(f) < 1e4 ? fmt::format("{:.4g} N", f) : fmt::format("{:.4g} kN", 1e-3 * f));
  return text;
}

/// The criterion that the stage was judged by, or would have been if it had not ended by its time.
dem::RestCriterion criterion_of(const Provenance& made) {
  try {
    const study::Recipe recipe = study::parse_recipe(made.recipe, "recipe");
    for (const auto& stage : recipe.stages)
      if (stage.name == made.stage) return stage.rest;
  } catch (const InputError&) {
  }
  return {};
}

std::string state_of(const StageResult& last) {
  const Equilibrium& now = last.frames.back().equilibrium;
  const bool rests = last.converged && dem::is_at_rest(now, criterion_of(last.provenance));
  return fmt::format("{}: {}", rests ? "at rest" : "NOT AT REST", dem::describe(now));
}

void add_forces(Rows& rows, const texture::Texture& t) {
  if (const auto* all = texture::find(t.force.compressive, "all")) {
    rows.add("mean normal force <F>", all->mean, "N", "of contacts that push");
    rows.add("share above the mean P_0", all->share_above, "", "of contacts with F > <F>");
    rows.add("strong forces' decay beta", all->tail.beta, "", "P(F) ~ exp(-beta F/<F>) for F > <F>");
  }
  const texture::Stress& s = t.stress;
  if (!std::isfinite(s.whole.value.xx)) return;
  const auto [unit, scale] = statistics::stress_unit(std::abs(s.pressure) + s.deviator);
  rows.add("pressure p", fmt::format("{:.4g} {}", s.pressure * scale + 0.0, unit), "mean of the principal stresses, compression positive");
  if (s.pressure > 0) rows.add("deviator over pressure q/p", fmt::format("{:.3g}", s.deviator / s.pressure), "q: half the difference of the principal stresses");
}

void add_fabric(Rows& rows, const texture::Texture& t) {
  rows.add("solid fraction", t.solid_fraction, "", "area of grains over area of the sample");
  if (const auto* z = texture::find(t.coordination.mean, "all")) rows.add("coordination z", *z, "", "contacts of a grain with others");
  if (const auto* z = texture::find(t.coordination.mean, "all without rattlers")) rows.add("z without rattlers", *z, "", "of grains that carry force");
  rows.add("rattlers", t.coordination.rattlers, "", "share of grains with fewer than two contacts that carry force");
  if (const auto* all = texture::find(t.fabric, "all"))
    rows.add("contact anisotropy a_c", all->a_c, "", fmt::format("0: contacts in all directions alike; random ones give {:.2g}", all->noise));
}

}  // namespace

std::string headlines(const StageResult& last, const texture::Texture& t) {
  Rows rows;
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
  Rows rows;
  const auto add = [&](const char* name, const char* path, const char* unit, const char* meaning) {
    const Numbers* at = numbers.at_path(path);
    const std::string value = at ? shown(*at) : "";
    if (!value.empty()) rows.add(name, value + (*unit ? std::string(" ") + unit : ""), meaning);
  };
  rows.heading("Sample on the nodes");
  add("lengths", "/map/lengths", "", "");
  add("grains", "/grains/all", "", "");
  add("void", "/phases/void", "", "share of the area");
  add("matrix", "/phases/matrix", "", "share of the area");
  add("S_m", "/S_m", "", "share of the space between grains that matrix fills");
  add("neighbours Z", "/coordination/Z", "", "grains whose surfaces are near, of a grain");
  add("pores", "/pores/count", "", "spaces between grains, matrix or not");
  add("mean volume of pores", "/pores/mean", "", "over pi times the reference radius squared");
  add("voids", "/voids/count", "", "spaces that nothing fills");
  if (numbers.contains("load")) rows.heading("Under load");
  add("modulus E", "/modulus_Pa", "Pa", "mean stress over strain");
  add("Poisson's ratio nu", "/poisson", "", "");
  add("E along x", "/moduli/E_x_Pa", "Pa", "");
  add("E along y", "/moduli/E_y_Pa", "Pa", "");
  add("shear modulus G", "/moduli/G_Pa", "Pa", "");
  add("strength", "/strength_Pa", "Pa", "greatest mean stress");
  add("strain at strength", "/failure/strain_at_strength", "", "");
  if (const Numbers* sets = numbers.at_path("/stress/sigma_yy/sets")) {
    rows.heading("Vertical stress by phase over the mean of the sample");
    for (const auto& [name, set] : sets->items())
      if (set.contains("mean_over_sample_mean")) rows.add(name, shown(set["mean_over_sample_mean"]));
  }
  std::string text = std::move(rows).text();
  if (numbers.contains("notes"))
    for (const auto& note : numbers["notes"]) text += "  " + note.get<std::string>() + "\n";
  return text;
}

}  // namespace arenite::report

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/error.hpp"
#include "grains/dem/run_stage.hpp"
#include "report/result_text.hpp"
#include "statistics/numbers.hpp"
#include "statistics/estimate.hpp"
#include "recipe/recipe.hpp"

namespace arenite::report {
namespace {

using statistics::with_error;

void add(TextLines& rows, const std::string& name, const statistics::Estimate& e, const std::string& unit, const std::string& meaning, double scale = 1) {
  if (std::isfinite(e.value)) rows.add(name, with_error(e, scale) + (unit.empty() ? "" : " " + unit), meaning);
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
      text += fmt::format("{}{} {}", text.empty() ? "" : ", ", side_names[side], std::abs(f) < 1e4 ? fmt::format("{:.4g} N", f) : fmt::format("{:.4g} kN", 1e-3 * f));
  return text;
}

/// The criterion that the stage was judged by, or would have been if it had not ended by its time.
dem::RestCriterion criterion_of(const Provenance& made) {
  try {
    const recipe::Recipe recipe = recipe::parse_recipe(made.recipe, "recipe");
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

void add_forces(TextLines& rows, const texture::Texture& t) {
  if (const auto* all = texture::find(t.force.compressive, "all")) {
    add(rows, "mean normal force <F>", all->mean, "N", "of contacts that push");
    add(rows, "share above the mean P_0", all->share_above, "", "of contacts with F > <F>");
    add(rows, "strong forces' decay beta", all->tail.beta, "", "P(F) ~ exp(-beta F/<F>) for F > <F>");
  }
  const texture::Stress& s = t.stress;
  if (!std::isfinite(s.whole.value.xx)) return;
  const auto [unit, scale] = statistics::stress_unit(std::abs(s.pressure) + s.deviator);
  rows.add("pressure p", fmt::format("{:.4g} {}", s.pressure * scale + 0.0, unit), "mean of the principal stresses, compression positive");
  if (s.pressure > 0) rows.add("deviator over pressure q/p", fmt::format("{:.3g}", s.deviator / s.pressure), "q: half the difference of the principal stresses");
}

void add_fabric(TextLines& rows, const texture::Texture& t) {
  add(rows, "solid fraction", t.solid_fraction, "", "area of grains over area of the sample");
  if (const auto* z = texture::find(t.coordination.mean, "all")) add(rows, "coordination z", *z, "", "contacts of a grain with others");
  if (const auto* z = texture::find(t.coordination.mean, "all without rattlers")) add(rows, "z without rattlers", *z, "", "of grains that carry force");
  add(rows, "rattlers", t.coordination.rattlers, "", "share of grains with fewer than two contacts that carry force");
  if (const auto* all = texture::find(t.fabric, "all"))
    add(rows, "contact anisotropy a_c", all->a_c, "", fmt::format("0: contacts in all directions alike; random ones give {:.2g}", all->noise));
}

}  // namespace

std::string headlines(const StageResult& last, const texture::Texture& t) {
  TextLines rows;
  const Frame& frame = last.frames.back();
  rows.heading(fmt::format("Last state: {} of {}", frame.label, last.name));
  if (!last.provenance.kernel.empty()) rows.add("state", state_of(last), "");
  rows.add("grains", grains_of(frame.packing), "");
  rows.add("contacts", fmt::format("{} between grains, {} with walls", t.contacts, t.wall_contacts), "");
  rows.add("forces on the walls", forces_on_sides(frame.packing.domain), "");
  rows.heading("Away from the walls, each +- its standard error");
  add_fabric(rows, t);
  add_forces(rows, t);
  std::string text = std::move(rows).text();
  for (const auto& note : t.notes) text += "  note: " + note + "\n";
  return text;
}

}  // namespace arenite::report

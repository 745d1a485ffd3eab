#include "report/field_text.hpp"

#include <fmt/format.h>

#include "report/number_lines.hpp"
#include "statistics/numbers.hpp"

namespace arenite::report {
namespace {

using Lines = NumberLines;

void describe_sample(Lines& lines) {
  lines.heading("Sample on the nodes");
  lines.add("nodes along x", "/map/width");
  lines.add("nodes along y", "/map/height");
  lines.add("distance of nodes", "/map/dx_m", "m");
  lines.add("lengths", "/map/lengths");
  lines.add("grains", "/grains/all");
  lines.add("share of particles", "/phases/particle");
  lines.add("share of large grains", "/phases/large");
  lines.add("share of small grains", "/phases/small");
  lines.add("share of matrix", "/phases/matrix");
  lines.add("share of void", "/phases/void");
  lines.add("S_m (matrix in the pore space)", "/S_m");
  lines.add("S_m by geometry", "/exact/S_m");
  lines.add("solid from bottom to top", "/percolates/solid_bottom_top");
  lines.add("void from left to right", "/percolates/void_left_right");
  lines.add("nodes across the thinnest joint", "/raster/thinnest_joint_nodes");
  lines.add("joints without a node", "/raster/lost_joints");
  lines.add("nodes across the smallest grain", "/raster/smallest_grain_nodes");
  if (lines.has("/coordination")) lines.heading("Neighbours by surface gap");
  lines.add("gap", "/coordination/gap_m", "m");
  for (const char* name : {"Z", "Z_l", "Z_s", "Z_ll", "Z_ls", "Z_sl", "Z_ss"}) lines.add(name, fmt::format("/coordination/{}", name));
  lines.heading("Pores and voids (volumes over pi times the reference radius squared)");
  for (const char* kind : {"pores", "voids"})
    for (const char* name : {"count", "mean", "deviation", "cv"}) lines.add(fmt::format("{} {}", kind, name), fmt::format("/{}/{}", kind, name));
}

void describe_load(Lines& lines) {
  lines.heading("Load");
  lines.add("loading", "/load/loading");
  lines.add("along", "/load/axis");
  lines.add("strain", "/load/strain");
  lines.add("ending", "/load/ending");
  lines.add("iterations", "/load/iterations");
  lines.add("residual", "/load/residual");
  lines.add("defect of the reaction identity", "/load/identity_defect");
  lines.add("apparent modulus", "/modulus_Pa", "Pa");
  lines.add("Poisson's ratio", "/poisson");
  lines.add("E along x", "/moduli/E_x_Pa", "Pa");
  lines.add("E along y", "/moduli/E_y_Pa", "Pa");
  lines.add("nu, pulled along x", "/moduli/nu_xy");
  lines.add("nu, pulled along y", "/moduli/nu_yx");
  lines.add("G", "/moduli/G_Pa", "Pa");
  lines.add("strength", "/strength_Pa", "Pa");
  lines.add("strain at strength", "/failure/strain_at_strength");
  for (const char* type : {"matrix", "interface", "particle"})
    lines.add(fmt::format("broken bonds, {}", type), fmt::format("/failure/broken/{}", type));
  lines.add("defect of the energy balance", "/failure/energy_defect");
}

void describe_component(Lines& lines, const std::string& name, const Numbers& component) {
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

std::string field_text(const Numbers& numbers) {
  Lines lines(numbers);
  describe_sample(lines);
  if (numbers.contains("load")) describe_load(lines);
  if (numbers.contains("stress"))
    for (const auto& [name, part] : numbers["stress"].items())
      if (name.starts_with("sigma_")) describe_component(lines, name, part);
  if (numbers.contains("grain_stress_against_contacts")) {
    lines.heading("Mean stresses of grains against those from contact forces");
    for (const char* component : {"sigma_yy", "sigma_hyd"})
      lines.add(fmt::format("correlation, {}", component), fmt::format("/grain_stress_against_contacts/{}/all/correlation", component));
  }
  if (numbers.contains("notes"))
    for (const auto& note : numbers["notes"]) lines.raw("  " + note.get<std::string>());
  return std::move(lines).text();
}

}  // namespace arenite::report

#include "workflow/export_fields.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <initializer_list>
#include <utility>

#include "core/mapped.hpp"
#include "core/problems.hpp"
#include "grains/fields/coarse_grained.hpp"
#include "grains/texture/partners.hpp"
#include "grains/texture/stress.hpp"
#include "grains/texture/texture.hpp"
#include "solid/stress/grains.hpp"
#include "workflow/film/film_numbers.hpp"

namespace arenite::workflow {
namespace {

template <class T> std::vector<double> as_doubles(const std::vector<T>& values) {
  return {values.begin(), values.end()};
}

void add_components(std::vector<io::GrainField>& fields, const std::vector<Tensor2>& stress,
                    std::initializer_list<std::pair<const char*, double Tensor2::*>> wanted) {
  for (const auto& [name, component] : wanted) {
    fields.push_back({name, "Pa", {}});
    for (const Tensor2& t : stress) fields.back().values.push_back(t.*component);
  }
}

/// As VTK has a symmetric tensor: xx, yy, zz, xy, yz, xz.
std::array<double, 6> components_of(const Tensor2& t) { return {t.xx, t.yy, 0, 0.5 * (t.xy + t.yx), 0, 0}; }
std::array<double, 6> components_of(const Tensor3& t) {
  const auto mean = [&](int a, int b) { return 0.5 * (t.at[a][b] + t.at[b][a]); };
  return {t.at[0][0], t.at[1][1], t.at[2][2], mean(0, 1), mean(1, 2), mean(0, 2)};
}

}  // namespace

template <int D> io::GridFieldsIn<D> grid_fields(const PackingIn<D>& packing, double shear_rate) {
  using texture::pressure;
  if (!fields::has_fields(packing))
    throw InputError("this result has no box of known size, which coarse-grained fields need");
  constexpr std::array<double, 2> most{INFINITY, 1e6};
  const double diameter = packing.grains.mean_diameter();
  double spacing = 0.5 * diameter;
  const auto points = [&] {
    double count = 1;
    for (int axis = 0; axis < D; ++axis) count *= std::ceil(packing.domain.extent(axis) / spacing);
    return count;
  };
  while (points() > most[D - 2]) spacing *= 1.01;
  const auto grid = fields::grid_over<D>(packing.domain, spacing);
  const auto f = fields::coarse_fields(packing, shear_rate, std::max(diameter, spacing), grid);
  io::GridFieldsIn<D> g{f.grid.low, f.grid.step(), f.grid.count, {}, f.velocity, {}};
  g.scalars = {
      {"solid_fraction", "1", f.solid_fraction}, {"density", "kg/m^3", f.density}, {"kinetic_pressure", "Pa", {}}};
  for (std::size_t k = 0; k < f.grid.size(); ++k) {
    const auto stress = components_of(f.stress(k));
    g.stress.insert(g.stress.end(), stress.begin(), stress.end());
    g.scalars.back().values.push_back(pressure(f.kinetic_stress[k]));
  }
  return g;
}
template io::GridFieldsIn<2> grid_fields(const Packing&, double);
template io::GridFieldsIn<3> grid_fields(const PackingIn<3>&, double);

std::vector<io::GrainField> derived_fields(const Packing& packing) {
  texture::Options options;
  options.rev.sizes = 0;
  const texture::PerGrain rows = texture::measure(packing, options).per_grain;
  std::vector<io::GrainField> fields{{"contacts", "1", as_doubles(rows.contacts)},
                                     {"rattler", "1", as_doubles(rows.rattler)},
                                     {"sigma_norm", "1", rows.sigma_norm},
                                     {"psi6", "1", rows.psi6}};
  if (rows.sigma.empty()) return fields;
  fields.push_back({"sigma_hyd", "Pa", rows.sigma_hyd});
  add_components(
      fields, rows.sigma,
      {{"sigma_xx", &Tensor2::xx}, {"sigma_xy", &Tensor2::xy}, {"sigma_yx", &Tensor2::yx}, {"sigma_yy", &Tensor2::yy}});
  return fields;
}

std::vector<io::GrainField> derived_fields(const PackingIn<3>& packing) {
  return {{"contacts", "1", as_doubles(texture::Partners(packing).of_each())},
          {"sigma_hyd", "Pa",
           mapped(texture::grain_stresses(packing), [](const Tensor3& s) { return mean_principal(s); })}};
}

std::vector<io::GrainField> derived_fields(const FilmResult& film) {
  const texture::PerGrain rows = texture_of(film, false).per_grain;
  return {{"contacts", "1", as_doubles(rows.contacts)},
          {"sigma_norm", "1", rows.sigma_norm},
          {"sigma_hyd", "Pa", film.peak_to_peak.sigma_hyd},
          {"sigma_hyd_error", "Pa", film.peak_to_peak.error}};
}

std::vector<io::GrainField> fields_of_contacts(const FilmResult& film) {
  if (film.fn_error.empty()) return {};
  return {{"fn_error", "N", film.fn_error}, {"ft_error", "N", film.ft_error}, {"presence", "1", film.presence}};
}

std::vector<io::GrainField> derived_fields(const FieldResult& result) {
  const bool loaded = result.field.size() > 0;
  StressField none;
  if (!loaded)
    for (auto* component : {&none.ux, &none.uy, &none.xx, &none.yy, &none.xy})
      component->assign(result.map.size(), 0.0);
  const auto rows = stress::measure_grains(result.map, loaded ? result.field : none, 0, 1);
  std::vector<double> x, y;
  for (const Vec2& centre : rows.centre) x.push_back(centre.x), y.push_back(centre.y);
  std::vector<io::GrainField> fields{
      {"nodes", "1", as_doubles(rows.nodes)}, {"whole", "1", as_doubles(rows.whole)}, {"x", "m", x}, {"y", "m", y}};
  if (loaded)
    add_components(fields, rows.stress,
                   {{"sigma_xx", &Tensor2::xx}, {"sigma_yy", &Tensor2::yy}, {"sigma_xy", &Tensor2::xy}});
  return fields;
}

}  // namespace arenite::workflow

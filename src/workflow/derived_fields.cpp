#include "workflow/derived_fields.hpp"

#include "solid/stress/grains.hpp"
#include "grains/texture/texture.hpp"

namespace arenite::study {
namespace {

template <class T>
std::vector<double> as_doubles(const std::vector<T>& values) {
  return {values.begin(), values.end()};
}

std::vector<double> component(const std::vector<Tensor2>& tensors, double Tensor2::*member) {
  std::vector<double> values;
  for (const Tensor2& t : tensors) values.push_back(t.*member);
  return values;
}

}  // namespace

std::vector<io::GrainField> derived_fields(const Packing& packing) {
  texture::Options options;
  options.rev_sizes = 0;
  const texture::PerGrain rows = texture::measure(packing, options).per_grain;
  std::vector<io::GrainField> fields{{"contacts", "1", as_doubles(rows.contacts)},
                                     {"rattler", "1", as_doubles(rows.rattler)},
                                     {"sigma_norm", "1", rows.sigma_norm},
                                     {"psi6", "1", rows.psi6}};
  if (!rows.sigma.empty()) {
    fields.push_back({"sigma_hyd", "Pa", rows.sigma_hyd});
    fields.push_back({"sigma_xx", "Pa", component(rows.sigma, &Tensor2::xx)});
    fields.push_back({"sigma_xy", "Pa", component(rows.sigma, &Tensor2::xy)});
    fields.push_back({"sigma_yx", "Pa", component(rows.sigma, &Tensor2::yx)});
    fields.push_back({"sigma_yy", "Pa", component(rows.sigma, &Tensor2::yy)});
  }
  return fields;
}

std::vector<io::GrainField> derived_fields(const FilmResult& film) {
  texture::Options options;
  options.rev_sizes = 0;
  options.grain_sigma_hyd = film.swing.sigma_hyd;
  const texture::PerGrain rows = texture::measure(film.packing, options).per_grain;
  return {{"contacts", "1", as_doubles(rows.contacts)},
          {"sigma_norm", "1", rows.sigma_norm},
          {"sigma_hyd", "Pa", film.swing.sigma_hyd},
          {"sigma_hyd_error", "Pa", film.swing.error}};
}

std::vector<io::GrainField> fields_of_contacts(const FilmResult& film) {
  if (film.fn_error.empty()) return {};
  return {{"fn_error", "N", film.fn_error}, {"ft_error", "N", film.ft_error}, {"presence", "1", film.presence}};
}

std::vector<io::GrainField> derived_fields(const FieldResult& result) {
  const bool loaded = result.field.size() > 0;
  StressField none;
  if (!loaded)
    for (auto* component : {&none.ux, &none.uy, &none.xx, &none.yy, &none.xy}) component->assign(result.map.size(), 0.0);
  const auto rows = stress::measure_grains(result.map, loaded ? result.field : none, 0, 1);
  std::vector<double> x, y;
  for (const Vec2& centre : rows.centre) x.push_back(centre.x), y.push_back(centre.y);
  std::vector<io::GrainField> fields{{"nodes", "1", as_doubles(rows.nodes)}, {"whole", "1", as_doubles(rows.whole)}, {"x", "m", x}, {"y", "m", y}};
  if (!loaded) return fields;
  fields.push_back({"sigma_xx", "Pa", component(rows.stress, &Tensor2::xx)});
  fields.push_back({"sigma_yy", "Pa", component(rows.stress, &Tensor2::yy)});
  fields.push_back({"sigma_xy", "Pa", component(rows.stress, &Tensor2::xy)});
  return fields;
}

}  // namespace arenite::study

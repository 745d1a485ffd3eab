#include "study/derived_fields.hpp"

#include "texture/texture.hpp"

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

}  // namespace arenite::study

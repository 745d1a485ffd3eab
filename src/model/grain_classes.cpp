#include "model/grain_classes.hpp"

#include <cmath>

#include "core/mapped.hpp"
#include "statistics/correlation.hpp"

namespace arenite {

template <int D> double mean_radius(const PackingIn<D>& packing, std::int32_t material) {
  const auto counts =
      mapped<std::uint8_t>(packing.grains.material, [&](auto m) { return material < 0 || m == material; });
  const double mean = statistics::mean_of_known(packing.grains.radius, counts);
  return std::isfinite(mean) ? mean : 0;
}

template <int D> std::optional<ClassMaterials> classes_by_radius(const PackingIn<D>& packing) {
  if (packing.materials.size() != 2) return std::nullopt;
  const double a = mean_radius(packing, 0), b = mean_radius(packing, 1);
  if (a == 0 || b == 0 || a == b) return std::nullopt;
  return a > b ? ClassMaterials{0, 1} : ClassMaterials{1, 0};
}

template <int D>
std::vector<GrainClass> classes_of(const PackingIn<D>& packing, const std::optional<ClassMaterials>& materials) {
  if (!materials) return {};
  return mapped(packing.grains.material, [&](std::int32_t m) {
    return m == materials->large ? GrainClass::large : m == materials->small ? GrainClass::small : GrainClass::none;
  });
}

template double mean_radius(const PackingIn<2>&, std::int32_t);
template double mean_radius(const PackingIn<3>&, std::int32_t);
template std::optional<ClassMaterials> classes_by_radius(const PackingIn<2>&);
template std::optional<ClassMaterials> classes_by_radius(const PackingIn<3>&);
template std::vector<GrainClass> classes_of(const PackingIn<2>&, const std::optional<ClassMaterials>&);
template std::vector<GrainClass> classes_of(const PackingIn<3>&, const std::optional<ClassMaterials>&);

SampleLengths sample_lengths(double large_radius) {
  return {SampleLengths::gap_over_radius * large_radius, SampleLengths::window_over_radius * large_radius};
}

}  // namespace arenite

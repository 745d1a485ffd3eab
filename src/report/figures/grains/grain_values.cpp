#include "report/figures/grains/grain_values.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/mapped.hpp"
#include "grains/fields/loading.hpp"
#include "grains/fields/stage_numbers.hpp"
#include "grains/texture/grain_quantities.hpp"
#include "grains/texture/spheres/spheres.hpp"
#include "grains/texture/texture.hpp"
#include "statistics/histogram.hpp"

namespace arenite::report::figures {
namespace {

using Values = std::vector<double>;

Values normalised_stresses(const StageResult& stage, const Packing& packing) {
  return texture::grain_rows(packing, fields::texture_options(stage)).per_grain.sigma_norm;
}
Values normalised_stresses(const SphereResult& stage, const PackingIn<3>& packing) {
  return texture::grain_rows(packing, texture::sphere_options(stage.asked)).per_grain.sigma_norm;
}

template <int D> bool has_forces(const PackingIn<D>& packing) {
  return std::ranges::any_of(packing.contacts.fn, [](double force) { return force != 0; });
}

/// The states of a stage up to this one.
template <int D> auto until(const StageResultIn<D>& stage, const SnapshotIn<D>& state) {
  std::vector<const SnapshotIn<D>*> states;
  for (const SnapshotIn<D>& one : stage.snapshots)
    if (one.time < state.time) states.push_back(&one);
  states.push_back(&state);
  return states;
}

template <int D> Values ways(const StageResultIn<D>& stage, const SnapshotIn<D>& state) {
  const auto* time = stage.history.find("time");
  const auto* strain = stage.history.find("shear_strain");
  const auto all = texture::displacements(mapped(until(stage, state), [&](const SnapshotIn<D>* one) {
    return texture::ShearedIn<D>{&one->packing, time && strain ? fields::at_time(*time, *strain, one->time) : 0.0};
  }));
  return mapped(all.back(), [](const Vec<D>& way) { return norm(way); });
}

Values turns(const StageResult& stage, const Snapshot& state) {
  return texture::rotations(mapped(until(stage, state), [](const Snapshot* one) { return &one->packing; })).back();
}
Values turns(const SphereResult& /*stage*/, const SnapshotIn<3>& /*state*/) { return {}; }

bool has(const texture::GrainQuantity& quantity, const Packing* /*of*/) {
  return quantity.of || !quantity.formula.empty();
}
bool has(const texture::GrainQuantity& quantity, const PackingIn<3>* /*of*/) { return quantity.of_spheres; }

}  // namespace

template <int D> Values grain_values(const StageResultIn<D>& stage, const SnapshotIn<D>& state, std::string_view name) {
  const PackingIn<D>& packing = state.packing;
  if (name == "stress") return has_forces(packing) ? normalised_stresses(stage, packing) : Values{};
  if (name == "displacement") return ways(stage, state);
  if (name == "rotation") return turns(stage, state);
  if (name == "mobilisation") {
    if (!std::isfinite(stage.asked.friction)) return {};
    return texture::mobilisations(packing, stage.asked.friction);
  }
  return has(texture::grain_quantity(name), &packing) ? texture::values_of(packing, name) : Values{};
}

template Values grain_values(const StageResult& stage, const Snapshot& state, std::string_view name);
template Values grain_values(const SphereResult& stage, const SnapshotIn<3>& state, std::string_view name);

double most_of(const Values& values) {
  Values known;
  for (const double value : values)
    if (std::isfinite(value)) known.push_back(std::abs(value));
  return known.empty() ? 0 : statistics::exact_quantiles(std::move(known), {0.99}).front();
}

}  // namespace arenite::report::figures

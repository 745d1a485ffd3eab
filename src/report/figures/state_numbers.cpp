#include "report/figures/state_numbers.hpp"

#include "grains/fields/stage_numbers.hpp"
#include "grains/texture/spheres/spheres.hpp"
#include "grains/texture/view.hpp"
#include "report/figures/drawing.hpp"
#include "thermal/inference/force_certainty.hpp"

namespace arenite::report::figures {
namespace {

/// What it lacks, and numbers with errors.
void take_over(Numbers& out, const Numbers& known) {
  for (const auto& [name, number] : known.items())
    if (!out.contains(name) || number.contains("error")) out[name] = number;
    else if (number.is_tree()) take_over(out[name], number);
}

Numbers with_stored(Numbers numbers, const StageResult& stage, const Snapshot& state) {
  numbers.erase("by_grain");
  if (&state == &stage.snapshots.back()) take_over(numbers, stage.texture);
  return numbers;
}

}  // namespace

Numbers state_numbers(const StageResult& stage, const Snapshot& state, const texture::Texture& texture) {
  return with_stored(texture::numbers(texture, true), stage, state);
}

Numbers state_numbers(const StageResult& stage, const Snapshot& state, bool curves) {
  texture::Options options = fields::texture_options(stage);
  if (!curves) options.rev.sizes = 0;
  return with_stored(texture::numbers(texture::measure(state.packing, options), curves), stage, state);
}

texture::ForceScale force_scale(const Packing& packing, const Numbers& numbers) {
  return texture::force_scale(packing.contacts, estimate_at(numbers, "/force/mean_N").value);
}

texture::ForceScale force_scale(const FilmResult& film) {
  return texture::force_scale(film.packing.contacts, estimate_at(film.numbers, "/forces/mean_N").value,
                              inference::doubtful_contacts(film));
}

texture::ForceScale force_scale(const SphereResult& stage, const SnapshotIn<3>& state) {
  const double known = &state == &stage.snapshots.back() ? estimate_at(stage.texture, "/force/mean_N").value : 0;
  if (known > 0) return texture::force_scale(state.packing.contacts, known);
  const texture::SphereOptions options = texture::sphere_options(stage.asked);
  return texture::force_scale(state.packing.contacts, texture::SphereView(state.packing, options).mean_force);
}

}  // namespace arenite::report::figures

#include "grains/fields/friction.hpp"

#include <algorithm>
#include <cmath>

#include "core/problems.hpp"
#include "grains/dem/laws/friction_coefficients.hpp"
#include "grains/texture/view.hpp"
#include "model/periodic_images.hpp"
#include "statistics/jackknife.hpp"

namespace arenite::fields {
namespace {

using statistics::unknown;

void check(const FrictionOptions& options) {
  const double least = std::min(options.friction, options.wall_friction.value_or(options.friction));
  if (!(least >= 0)) throw refusal("a friction coefficient of {:g}; give 0 or more", least);
  if (!(options.tolerance >= 0 && options.tolerance < 1))
    throw refusal("contacts slide within {:g} of the Coulomb limit; give a fraction from 0 to below 1",
                  options.tolerance);
  if (options.bins < 1) throw refusal("{} bins; give at least one", options.bins);
}

/// Blocks of the box that contacts lie in; each its own where the box is not known or too small to be cut.
std::vector<int> blocks_of(const Packing& packing) {
  const Contacts& contacts = packing.contacts;
  const bool known = packing.domain.width() > 0 && packing.domain.height() > 0;
  const texture::BlockGrid blocks{box_of(packing.domain), known ? texture::blocks_per_side(packing.grains.size()) : 1};
  std::vector<int> block(contacts.size());
  for (std::size_t c = 0; c < block.size(); ++c)
    block[c] = blocks.block_of(packing.domain.wrapped(packing.grains.position[contacts.i[c]] + contacts.lever_i(c)), c);
  return block;
}

statistics::Curve density_of(const FrictionState& state, const statistics::Items& known, int bins) {
  std::vector<double> count(static_cast<std::size_t>(bins), 0);
  for (const std::size_t c : known) ++count[std::min<double>(bins - 1, state.mobilisation[c] * bins)];
  statistics::Curve curve;
  for (int k = 0; k < bins && !known.empty(); ++k) {
    const double scale = bins / static_cast<double>(known.size()), n = count[k];
    curve.x.push_back((k + 0.5) / bins);
    curve.y.push_back(n * scale);
    curve.error.push_back(std::sqrt(n) * scale);
  }
  return curve;
}

}  // namespace

void declare(ParameterVisitor& v, FrictionOptions& options) {
  dem::declare_friction(v, options.friction, options.wall_friction);
}

FrictionState measure_friction(const Packing& packing, const FrictionOptions& options) {
  check(options);
  const Contacts& contacts = packing.contacts;
  FrictionState state;
  statistics::Items known, between_grains;
  const auto slides = [&](std::size_t c) { return state.mobilisation[c] >= 1 - options.tolerance; };  // false for NaN
  for (std::size_t c = 0; c < contacts.size(); ++c) {
    const double mu = contacts.is_wall(c) ? options.wall_friction.value_or(options.friction) : options.friction;
    const bool rubs = contacts.fn[c] > 0 && mu > 0;
    state.mobilisation.push_back(rubs ? std::abs(contacts.ft[c]) / (mu * contacts.fn[c]) : unknown);
    state.power.push_back(-contacts.ft[c] * contacts.sliding_velocity[c]);
    if (rubs) known.push_back(c);
    if (rubs && !contacts.is_wall(c)) between_grains.push_back(c);
    if (std::isnan(state.power[c])) continue;
    ++state.known_powers;
    state.total_power += state.power[c];
    if (slides(c)) state.sliding_power += state.power[c];
  }
  if (state.known_powers == 0) state.total_power = state.sliding_power = unknown;
  state.contacts = known.size();
  const std::vector<int> block = blocks_of(packing);
  state.mean = statistics::mean(known, block, [&](std::size_t c) { return state.mobilisation[c]; });
  state.sliding = statistics::mean(known, block, [&](std::size_t c) { return slides(c) ? 1.0 : 0.0; });
  state.sliding_grains = statistics::mean(between_grains, block, [&](std::size_t c) { return slides(c) ? 1.0 : 0.0; });
  state.density = density_of(state, known, options.bins);
  return state;
}

}  // namespace arenite::fields

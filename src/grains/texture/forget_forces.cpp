#include <algorithm>

#include "grains/texture/texture.hpp"

namespace arenite::texture {

void forget_forces(Texture& t) {
  const auto by_strength = [](const auto& named) {
    const std::string& name = named.first;
    return name.ends_with("strong") || name.ends_with("weak");
  };
  t.fabric.erase(std::remove_if(t.fabric.begin(), t.fabric.end(), by_strength), t.fabric.end());
  for (auto& [name, set] : t.fabric) {
    set.a_n = set.theta_n_deg = set.a_t = set.a_c_signed = {};
    set.sector_force.assign(set.sector_force.size(), 0);
  }
  const auto rattling = [](const auto& named) { return named.first == "all without rattlers"; };
  auto& mean = t.coordination.mean;
  mean.erase(std::remove_if(mean.begin(), mean.end(), rattling), mean.end());
  t.coordination.rattlers = {};
  t.load_axis_deg = unknown;
  t.threshold = {};
  t.force = {};
  t.stress = {};
  t.sigma_norm = {};
  t.quality = {};
  std::fill(t.per_grain.rattler.begin(), t.per_grain.rattler.end(), std::uint8_t{0});
  t.per_grain.sigma.clear();
  t.per_grain.sigma_hyd.clear();
  t.per_grain.sigma_norm.assign(t.per_grain.sigma_norm.size(), unknown);
}

}  // namespace arenite::texture

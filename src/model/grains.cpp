#include "model/grains.hpp"

namespace arenite {

void Grains::resize(std::size_t n) {
  const std::size_t old = size();
  id.resize(n);
  for (std::size_t i = old; i < n; ++i) id[i] = static_cast<std::int64_t>(i);
  for (auto* a : {&x, &y, &radius, &angle, &vx, &vy, &omega}) a->resize(n, 0.0);
  material.resize(n, 0);
  zone.resize(n, 0);
}

}  // namespace arenite

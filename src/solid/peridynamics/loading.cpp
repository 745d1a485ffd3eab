#include "solid/peridynamics/loading.hpp"

#include "core/error.hpp"

namespace arenite::peridynamics {

Vec2 direction_of(Loading loading) {
  switch (loading) {
    case Loading::tension: return {0, 1};
    case Loading::compression: return {0, -1};
    case Loading::shear: break;
  }
  return {1, 0};
}

std::vector<std::uint8_t> prescribed_rows(int height, Loading loading, LowerEdge lower) {
  if (loading == Loading::shear && lower == LowerEdge::sliding)
    throw InputError("a lower edge that slides carries no shear; fix it, or choose tension or compression");
  std::vector<std::uint8_t> rows(static_cast<std::size_t>(height), nothing_prescribed);
  rows.front() = lower == LowerEdge::sliding ? y_prescribed : both_prescribed;
  rows.back() = both_prescribed;
  return rows;
}

}  // namespace arenite::peridynamics

#include "solid/statics/block_diagonal.hpp"

namespace arenite::statics {

namespace {

Block inverse_of(Block b, std::uint8_t prescribed, bool& loose) {
  if (prescribed == both_prescribed) return {0, 0, 0};
  if (prescribed & x_prescribed) return {0, 0, b.yy > 0 ? 1 / b.yy : 0};
  if (prescribed & y_prescribed) return {b.xx > 0 ? 1 / b.xx : 0, 0, 0};
  const double trace = b.xx + b.yy, determinant = b.xx * b.yy - b.xy * b.xy;
  if (determinant > 1e-9 * trace * trace) return {b.yy / determinant, -b.xy / determinant, b.xx / determinant};
  loose = true;
  if (!(trace > 0)) return {0, 0, 0};
  const double s = 1 / (trace * trace);  // rank one: B/trace^2 is its pseudo-inverse
  return {s * b.xx, s * b.xy, s * b.yy};
}

}  // namespace

InverseDiagonal inverse_diagonal(const Grid& grid, const BlockDiagonal<double>& diagonal,
                                 const std::vector<std::uint8_t>& prescribed) {
  InverseDiagonal inverse{BlockDiagonal<float>(grid.padded_size())};
  grid.each([&](std::ptrdiff_t i, int y) {
    if (!(diagonal.xx[i] + diagonal.yy[i] > 0)) return;
    bool loose = false;
    inverse.blocks.set(i, inverse_of({diagonal.xx[i], diagonal.xy[i], diagonal.yy[i]}, prescribed[y], loose));
    inverse.loose += loose;
  });
  return inverse;
}

}  // namespace arenite::statics

#include "thermal/thermography/segment_phasors.hpp"

#include <cmath>

#include "thermal/thermography/harmonic_fit.hpp"

namespace arenite::thermography {

using statistics::Matrix;

Matrix segment_fit(const SegmentSums& s, std::size_t k) {
  const Matrix g = pass_weights(s, k), normal = times_transposed(g, g);
  return solve(normal, statistics::identity(g.rows(), g.rows())).part(1, 2);
}

bool phasors_of(const SegmentSums& s, const std::vector<Matrix>& fits, std::size_t p, Matrix& phasors, std::size_t at) {
  const SegmentView view = s.view();
  const float* plane = view.sums + view.at(p, 0, 0);
  const std::size_t segments = s.segments();
  double spread = 0, power = 0;
  for (std::size_t k = 0; k < segments; ++k, plane += view.planes * chunk) {
    double c = 0, sn = 0;
    for (std::size_t m = 0; m <= s.functions; ++m) {
      const auto v = static_cast<double>(plane[m * chunk]);
      c += fits[k](m, 0) * v, sn += fits[k](m, 1) * v;
    }
    const auto sum = static_cast<double>(plane[0]);
    spread += static_cast<double>(plane[(s.functions + 1) * chunk]) - sum * sum / s.frames_of(k);
    c *= s.frames_of(k), sn *= s.frames_of(k);
    power += c * c + sn * sn;
    phasors(k, at) = phasors(segments + k, at + 1) = c;
    phasors(k, at + 1) = sn;
    phasors(segments + k, at) = -sn;
  }
  if (!(spread > 0) || !std::isfinite(spread) || !std::isfinite(power)) return false;
  for (double* each = phasors.column(at); each != phasors.column(at + 2); ++each) *each /= std::sqrt(spread);
  return true;
}

}  // namespace arenite::thermography

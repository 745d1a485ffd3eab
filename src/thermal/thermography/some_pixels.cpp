#include "thermal/thermography/some_pixels.hpp"

#include <algorithm>
#include <cmath>

namespace arenite::thermography {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

MatrixXd some_pixels(FilmSource& film, const Progress& progress) {
  const auto frames = static_cast<std::size_t>(film.info().frames), pixels = film.info().pixels();
  const std::size_t most = std::clamp<std::size_t>((std::size_t{1} << 25) / std::max<std::size_t>(frames, 1), 64, 1024);  // 256 MB
  const std::size_t every = (pixels + most - 1) / most, count = (pixels + every - 1) / every;
  MatrixXd series(static_cast<Index>(count), static_cast<Index>(frames));
  const std::size_t at_once = std::clamp<std::size_t>((std::size_t{1} << 22) / pixels, 1, 256);
  FrameBlock block;
  for (std::size_t n = 0; n < frames; n += at_once) {
    const std::size_t here = std::min(at_once, frames - n);
    film.read(static_cast<std::int64_t>(n), here, block);
    for (std::size_t f = 0; f < here; ++f)
      for (std::size_t i = 0; i < count; ++i) {
        const std::size_t at = f * pixels + i * every;
        series(static_cast<Index>(i), static_cast<Index>(n + f)) = block.value.empty() ? static_cast<double>(block.level[at]) : static_cast<double>(block.value[at]);
      }
    if (progress && !progress(static_cast<double>(n + here) / static_cast<double>(frames))) return {};
  }
  const VectorXd first = series.col(0);
  series.colwise() -= first;
  Index used = 0;
  const Index last = series.cols() - 1;
  for (Index i = 0; i < series.rows(); ++i) {
    const double noise = std::sqrt((series.row(i).tail(last) - series.row(i).head(last)).squaredNorm() / (2 * static_cast<double>(last)));
    if (noise > 0 && std::isfinite(noise)) series.row(used++) = series.row(i).eval() / noise;
  }
  return series.topRows(used);
}

}  // namespace arenite::thermography

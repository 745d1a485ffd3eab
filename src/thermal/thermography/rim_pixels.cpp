#include "thermal/thermography/rim_pixels.hpp"

#include <Eigen/Dense>
#include <numbers>

namespace arenite::thermography {

namespace {

/// Width of a rim that lens and pixels blur: the share inside falls off as erfc(distance/blur)/2.
constexpr double blur = 0.8;
/// Closer to another grain than this a pixel is left out; its rim is told apart up to the reach.
constexpr double margin = 0.6, reach_of_others = 2.2;

double share_inside(double out) { return 0.5 * std::erfc(out / blur); }
double slope_of_share(double out) { return -std::exp(-out * out / (blur * blur)) / (blur * std::sqrt(std::numbers::pi)); }

void add(const PictureGrains& g, std::size_t i, const std::vector<std::size_t>& neighbours, double rim, double x, double y, RimPixels& pixels) {
  const double dx = x - g.x[i], dy = y - g.y[i], out = std::hypot(dx, dy) - g.radius[i];
  if (std::abs(out) > rim) return;
  std::vector<OtherRim> others;
  for (const std::size_t j : neighbours) {
    const double r = std::hypot(x - g.x[j], y - g.y[j]), away = r - g.radius[j];
    if (away < margin) return;
    if (away > reach_of_others) continue;
    const double slope = slope_of_share(away) / r;
    others.push_back({pixels.x.size(), j, share_inside(away), slope * (x - g.x[j]), slope * (y - g.y[j])});
  }
  pixels.others.insert(pixels.others.end(), others.begin(), others.end());
  pixels.x.push_back(x);
  pixels.y.push_back(y);
  pixels.from_centre_x.push_back(dx / g.radius[i]);
  pixels.from_centre_y.push_back(dy / g.radius[i]);
  pixels.inside.push_back(share_inside(out));
  pixels.weight.push_back(1 - std::pow(out / (rim + 0.5), 2));
}

}  // namespace

std::vector<RimPixels> rim_pixels(const PictureGrains& g, int width, int height, double rim) {
  std::vector<RimPixels> rims(g.size());
  for (std::size_t i = 0; i < g.size(); ++i) {
    const double reach = g.radius[i] + rim;
    std::vector<std::size_t> neighbours;
    for (std::size_t j = 0; j < g.size(); ++j)
      if (j != i && std::hypot(g.x[j] - g.x[i], g.y[j] - g.y[i]) < reach + g.radius[j] + reach_of_others) neighbours.push_back(j);
    const auto first = [](double v) { return std::max(0, static_cast<int>(std::ceil(v))); };
    for (int row = first(g.y[i] - reach); row <= std::min(height - 1, static_cast<int>(std::floor(g.y[i] + reach))); ++row)
      for (int column = first(g.x[i] - reach); column <= std::min(width - 1, static_cast<int>(std::floor(g.x[i] + reach))); ++column)
        add(g, i, neighbours, rim, column, row, rims[i]);
  }
  return rims;
}

SwingOfPixels::SwingOfPixels(const PhasePictures& p, double cos_x, double sin_x, double cos_y, double sin_y) {
  const auto n = static_cast<Eigen::Index>(p.size());
  Eigen::MatrixXd design(n, 5);
  for (std::size_t k = 0; k < p.size(); ++k) {
    dx_.push_back(cos_x * p.cosine[k] + sin_x * p.sine[k]);
    dy_.push_back(cos_y * p.cosine[k] + sin_y * p.sine[k]);
    design.row(static_cast<Eigen::Index>(k)) << 1, p.cosine[k], p.sine[k], p.cosine2[k], p.sine2[k];
  }
  const Eigen::VectorXd frames = Eigen::Map<const Eigen::VectorXd>(p.frames.data(), n);
  const Eigen::MatrixXd weighed = frames.asDiagonal() * design, fit = (design.transpose() * weighed).ldlt().solve(weighed.transpose());
  fit_.resize(5 * p.size());
  for (Eigen::Index m = 0; m < 5; ++m)
    for (Eigen::Index k = 0; k < n; ++k) fit_[static_cast<std::size_t>(m * n + k)] = fit(m, k);
}

Followed SwingOfPixels::follow(const PhasePictures& p, double x, double y) const {
  const std::size_t n = p.size();
  double a[5] = {}, frames = 0, noise = 0;
  Followed f;
  std::vector<double> value(n);
  for (std::size_t k = 0; k < n; ++k) {
    const Resampled here(p.width, p.height, x + dx_[k], y + dy_[k]);
    double slope_x = 0, slope_y = 0;
    value[k] = here.of(p.picture(k), slope_x, slope_y);
    for (std::size_t m = 0; m < 5; ++m) a[m] += fit_[m * n + k] * value[k];
    frames += p.frames[k];
    noise += p.frames[k] * here.noise();
    f.slope_x += p.frames[k] * slope_x;
    f.slope_y += p.frames[k] * slope_y;
  }
  double rest = 0;
  for (std::size_t k = 0; k < n; ++k) {
    const double fitted = a[0] + a[1] * p.cosine[k] + a[2] * p.sine[k] + a[3] * p.cosine2[k] + a[4] * p.sine2[k];
    rest += p.frames[k] * (value[k] - fitted) * (value[k] - fitted);
  }
  f.mean = a[0], f.cosine = a[1], f.sine = a[2], f.cosine2 = a[3], f.sine2 = a[4];
  f.slope_x /= frames, f.slope_y /= frames;
  f.variance = n > 5 ? rest / static_cast<double>(n - 5) * frames / noise : 0;
  return f;
}

}  // namespace arenite::thermography

#include "imaging/disk_model.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace arenite::imaging {
namespace {

constexpr double least_radius = 1.0, longest_step = 0.5;  // pixels
constexpr double cut = 2.5;                               // residuals beyond so many standard deviations count less

double median_of(std::vector<double> values) {
  if (values.empty()) return 0;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// Huber's weight of a residual.
double weight_of(double residual, double noise) {
  const double size = std::abs(residual), most = cut * noise;
  return size <= most || size == 0 ? 1 : most / size;
}

}  // namespace

DiskModel::DiskModel(const FloatImage& image, double blur) : image_(image), blur_(blur) { refresh(); }

DiskModel::Window DiskModel::window(const Disk& disk) const {
  const double reach = disk.radius + 3 * blur_ + 1.5;
  return {std::max(0, static_cast<int>(std::ceil(disk.x - reach))), std::min(image_.width - 1, static_cast<int>(disk.x + reach)),
          std::max(0, static_cast<int>(std::ceil(disk.y - reach))), std::min(image_.height - 1, static_cast<int>(disk.y + reach))};
}

/// C of a pixel; `edge` = dC/dr, (nx, ny) = direction from the centre.
double DiskModel::cover(const Disk& disk, int x, int y, double& edge, double& nx, double& ny) const {
  const double dx = x - disk.x, dy = y - disk.y, q = std::hypot(dx, dy);
  nx = q > 0 ? dx / q : 0;
  ny = q > 0 ? dy / q : 0;
  const double u = (disk.radius - q - blur_ * blur_ / (2 * std::max(q, blur_))) / blur_;
  edge = 0;
  if (u > 5) return 1;
  if (u < -5) return 0;
  edge = std::exp(-0.5 * u * u) / (blur_ * std::sqrt(2 * std::numbers::pi));
  return 0.5 * std::erfc(-u / std::numbers::sqrt2);
}

void DiskModel::spread(const Disk& disk, double sign) {
  const Window w = window(disk);
  double edge, nx, ny;
  for (int y = w.y0; y <= w.y1; ++y)
    for (int x = w.x0; x <= w.x1; ++x) {
      const double c = sign * cover(disk, x, y, edge, nx, ny);
      const std::size_t at = image_.index(x, y);
      covered_[at] += static_cast<float>(c);
      light_[at] += static_cast<float>(c * disk.level);
    }
}

double DiskModel::left(std::size_t pixel) const {
  return static_cast<double>(image_.value[pixel]) - static_cast<double>(light_[pixel]) -
         (1.0 - static_cast<double>(covered_[pixel])) * static_cast<double>(background_[pixel]);
}

void DiskModel::add(const Circle& circle) {
  Disk disk{circle.x, circle.y, circle.radius, 0, 0, 0};
  std::vector<double> inside;
  const Window w = window(disk);
  for (int y = w.y0; y <= w.y1; ++y)
    for (int x = w.x0; x <= w.x1; ++x)
      if (std::hypot(x - disk.x, y - disk.y) < std::max(0.75, 0.6 * disk.radius)) inside.push_back(static_cast<double>(image_.value[image_.index(x, y)]));
  disk.level = median_of(std::move(inside));
  disks_.push_back(disk);
}

void DiskModel::remove(const std::vector<char>& which) {
  std::size_t kept = 0;
  for (std::size_t k = 0; k < disks_.size(); ++k)
    if (which[k] == 0) disks_[kept++] = disks_[k];
  disks_.resize(kept);
}

void DiskModel::refresh() {
  std::vector<double> radii;
  for (const Disk& disk : disks_) radii.push_back(disk.radius);
  spacing_ = std::clamp(static_cast<int>(12 * median_of(radii)), 32, 4096);
  columns_ = image_.width / spacing_ + 2;
  rows_ = image_.height / spacing_ + 2;
  covered_.assign(image_.size(), 0.0F);
  light_ = background_ = covered_;
  for (const Disk& disk : disks_) spread(disk, 1);
  node_.assign(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_), 0.0);
  for (int i = 0; i < 4; ++i) fit_background();
  measure_noise();
}

double DiskModel::background(double x, double y) const {
  const double u = std::max(0.0, x / spacing_), v = std::max(0.0, y / spacing_);
  const int c = std::min(static_cast<int>(u), columns_ - 2), r = std::min(static_cast<int>(v), rows_ - 2);
  const double a = u - c, b = v - r;
  const auto at = [&](int i, int j) { return node_[static_cast<std::size_t>(i + columns_ * j)]; };
  return (1 - b) * ((1 - a) * at(c, r) + a * at(c + 1, r)) + b * ((1 - a) * at(c, r + 1) + a * at(c + 1, r + 1));
}

void DiskModel::draw_background() {
  for (int y = 0; y < image_.height; ++y)
    for (int x = 0; x < image_.width; ++x) background_[image_.index(x, y)] = static_cast<float>(background(x, y));
}

/// One lumped least-squares step of every node on the pixels near disks, as far as these do not cover them.
void DiskModel::fit_background() {
  std::vector<char> near(image_.size(), disks_.empty() ? 1 : 0);
  for (const Disk& disk : disks_) {
    const Window w = window(disk);
    for (int y = w.y0; y <= w.y1; ++y) std::fill_n(near.begin() + static_cast<std::ptrdiff_t>(image_.index(w.x0, y)), w.x1 - w.x0 + 1, 1);
  }
  std::vector<double> top(node_.size(), 0.0), bottom(node_.size(), 1e-12);
  double all_top = 0, all_bottom = 1e-12;
  for (int y = 0; y < image_.height; ++y)
    for (int x = 0; x < image_.width; ++x) {
      const std::size_t at = image_.index(x, y);
      const double free = std::clamp(1.0 - static_cast<double>(covered_[at]), 0.0, 1.0);
      if (near[at] == 0 || free < 0.02) continue;
      const double gap = left(at), w = noise_ > 0 ? weight_of(gap, noise_) : 1;
      const int c = x / spacing_, r = y / spacing_;
      const double a = static_cast<double>(x) / spacing_ - c, b = static_cast<double>(y) / spacing_ - r;
      const double share[4] = {(1 - a) * (1 - b), a * (1 - b), (1 - a) * b, a * b};
      for (int k = 0; k < 4; ++k) {
        const auto n = static_cast<std::size_t>(c + k % 2 + columns_ * (r + k / 2));
        top[n] += w * share[k] * free * gap;
        bottom[n] += w * share[k] * free * free;
      }
      all_top += w * free * gap;
      all_bottom += w * free * free;
    }
  const double few = 0.02 * all_bottom / static_cast<double>(node_.size());  // a node that sees little follows all
  for (std::size_t n = 0; n < node_.size(); ++n) node_[n] += (top[n] + few * all_top / all_bottom) / (bottom[n] + few);
  draw_background();
}

/// One damped step of a disk; its size in pixels.
double DiskModel::step(Disk& disk) {
  const Window w = window(disk);
  const double deep = disk.radius - std::max(3.0, 5 * blur_);  // farther inside nothing is learned of the rim
  Eigen::Matrix4d normal = Eigen::Matrix4d::Zero();
  Eigen::Vector4d right = Eigen::Vector4d::Zero();
  for (int y = w.y0; y <= w.y1; ++y)
    for (int x = w.x0; x <= w.x1; ++x) {
      const double far = std::hypot(x - disk.x, y - disk.y);
      if (far < deep) continue;
      double edge, nx, ny;
      const double c = cover(disk, x, y, edge, nx, ny);
      if (c < 1e-5) continue;
      const std::size_t at = image_.index(x, y);
      const double contrast = disk.level - static_cast<double>(background_[at]), gap = left(at);
      const Eigen::Vector4d j(contrast * edge * nx, contrast * edge * ny, contrast * edge, c);
      const double weight = weight_of(gap, noise_);
      normal += weight * j * j.transpose();
      right += weight * gap * j;
    }
  const double trace = normal.trace();
  if (!(trace > 0)) return 0;
  const double variance = std::max(noise_ * noise_, 1e-12 * trace);
  if (disk.prior_error > 0) {
    const double stiff = variance / (disk.prior_error * disk.prior_error);
    normal(2, 2) += stiff;
    right(2) += stiff * (disk.prior_radius - disk.radius);
  }
  for (int i = 0; i < 4; ++i) normal(i, i) *= 1.02;
  for (int i = 0; i < 3; ++i) normal(i, i) += 1e-3 * (normal(0, 0) + normal(1, 1)) + 1e-30;
  Eigen::Vector4d move = normal.ldlt().solve(right);
  if (!move.allFinite()) return 0;
  const double size = move.head<3>().norm();
  if (size > longest_step) move *= longest_step / size;
  spread(disk, -1);
  disk.x += move(0);
  disk.y += move(1);
  disk.radius = std::max(least_radius, disk.radius + move(2));
  disk.level += move(3);
  spread(disk, 1);
  return std::min(size, longest_step);
}

void DiskModel::fit_blur() {
  double top = 0, bottom = 0;
  for (const Disk& disk : disks_) {
    const Window w = window(disk);
    for (int y = w.y0; y <= w.y1; ++y)
      for (int x = w.x0; x <= w.x1; ++x) {
        double edge, nx, ny;
        cover(disk, x, y, edge, nx, ny);
        if (edge == 0) continue;
        const std::size_t at = image_.index(x, y);
        const double q = std::hypot(x - disk.x, y - disk.y);
        const double slope = -(disk.level - static_cast<double>(background_[at])) * edge *
                             ((disk.radius - q) / blur_ + blur_ / (2 * std::max(q, blur_)));
        const double gap = left(at), weight = weight_of(gap, noise_);
        top += weight * slope * gap;
        bottom += weight * slope * slope;
      }
  }
  if (!(bottom > 0)) return;
  const double before = blur_;
  blur_ = std::clamp(blur_ + std::clamp(0.7 * top / bottom, -0.1, 0.1), 0.3, 4.0);
  if (blur_ == before) return;
  covered_.assign(image_.size(), 0.0F);
  light_ = covered_;
  for (const Disk& disk : disks_) spread(disk, 1);
}

void DiskModel::measure_noise() {
  std::vector<double> size;
  for (const Disk& disk : disks_) {
    const Window w = window(disk);
    for (int y = w.y0; y <= w.y1; ++y)
      for (int x = w.x0; x <= w.x1; ++x)
        if (std::abs(std::hypot(x - disk.x, y - disk.y) - disk.radius) < 2 * blur_) size.push_back(std::abs(left(image_.index(x, y))));
  }
  noise_ = median_of(std::move(size)) / 0.6744897501960817;
}

void DiskModel::fit(int sweeps) {
  for (int sweep = 0; sweep < sweeps; ++sweep) {
    double most = 0;
    for (Disk& disk : disks_) most = std::max(most, step(disk));
    fit_background();
    fit_blur();
    measure_noise();
    if (most < 1e-3) break;
  }
}

FloatImage DiskModel::residual() const {
  FloatImage image{image_.width, image_.height, std::vector<float>(image_.size())};
  for (std::size_t i = 0; i < image.size(); ++i) image.value[i] = static_cast<float>(left(i));
  return image;
}

}  // namespace arenite::imaging

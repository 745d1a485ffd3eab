#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "thermal/imaging/disk_model.hpp"

namespace arenite::imaging {
namespace {

using Matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic>;

}  // namespace

/// The picture at a place (linear between pixels) with every other disk taken away, minus the background.
double DiskModel::alone(const Disk& disk, double x, double y) const {
  const int c = static_cast<int>(std::floor(x)), r = static_cast<int>(std::floor(y));
  double sum = 0, edge, nx, ny;
  for (int j = r; j <= r + 1; ++j)
    for (int i = c; i <= c + 1; ++i) {
      if (i < 0 || j < 0 || i >= image_.width || j >= image_.height) return std::nan("");
      const std::size_t at = image_.index(i, j);
      const double own = (disk.level - static_cast<double>(background_[at])) * cover(disk, i, j, edge, nx, ny);
      sum += (1 - std::abs(x - i)) * (1 - std::abs(y - j)) * (left(at) + own);
    }
  return sum;
}

std::vector<DiskModel::Evidence> DiskModel::evidence() const {
  std::vector<Evidence> all;
  for (const Disk& disk : disks_) {
    Evidence e;
    e.contrast = disk.level - background(disk.x, disk.y);
    const int angles = std::max(16, static_cast<int>(2 * std::numbers::pi * disk.radius));
    const double inner = disk.radius - 1 - blur_, outer = disk.radius + 1 + blur_;
    int seen = 0;
    for (int k = 0; k < angles; ++k) {
      const double a = 2 * std::numbers::pi * k / angles, ux = std::cos(a), uy = std::sin(a);
      const double fall = alone(disk, disk.x + inner * ux, disk.y + inner * uy) - alone(disk, disk.x + outer * ux, disk.y + outer * uy);
      if (fall / e.contrast > 0.5) ++seen;
    }
    e.rim = static_cast<double>(seen) / angles;
    const Window w = window(disk);
    double with = 0, without = 0, edge, nx, ny;
    for (int y = w.y0; y <= w.y1; ++y)
      for (int x = w.x0; x <= w.x1; ++x) {
        const std::size_t at = image_.index(x, y);
        const double c = cover(disk, x, y, edge, nx, ny), rest = left(at);
        if (c < 0.5) continue;  // what neighbours cover says nothing against this one
        const double own = (disk.level - static_cast<double>(background_[at])) * c;
        with += rest * rest;
        without += (rest + own) * (rest + own);
      }
    e.explained = without > 0 ? 1 - with / without : 0;
    all.push_back(e);
  }
  return all;
}

std::vector<DiskModel::Errors> DiskModel::errors() const {
  const auto n = disks_.size();
  std::vector<std::vector<std::size_t>> near(n);
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < n; ++j)
      if (std::hypot(disks_[i].x - disks_[j].x, disks_[i].y - disks_[j].y) < disks_[i].radius + disks_[j].radius + 4 * blur_ + 1 && i != j)
        near[i].push_back(j);
  // Blocks of the normal matrix between each disk and itself (first) and its neighbours.
  std::vector<std::vector<Eigen::Matrix4d>> block(n);
  const auto slope = [&](const Disk& d, int x, int y) {
    double edge, nx, ny;
    const double c = cover(d, x, y, edge, nx, ny);
    const double contrast = d.level - static_cast<double>(background_[image_.index(x, y)]);
    return Eigen::Vector4d(contrast * edge * nx, contrast * edge * ny, contrast * edge, c);
  };
  for (std::size_t i = 0; i < n; ++i) {
    block[i].assign(near[i].size() + 1, Eigen::Matrix4d::Zero());
    const Window w = window(disks_[i]);
    for (int y = w.y0; y <= w.y1; ++y)
      for (int x = w.x0; x <= w.x1; ++x) {
        const Eigen::Vector4d own = slope(disks_[i], x, y);
        if (own(3) < 1e-5) continue;
        block[i][0] += own * own.transpose();
        for (std::size_t k = 0; k < near[i].size(); ++k) block[i][k + 1] += own * slope(disks_[near[i][k]], x, y).transpose();
      }
    if (disks_[i].prior_error > 0) block[i][0](2, 2) += noise_ * noise_ / (disks_[i].prior_error * disks_[i].prior_error);
  }
  std::vector<Errors> errors;
  for (std::size_t i = 0; i < n; ++i) {
    std::vector<std::size_t> group{i};
    group.insert(group.end(), near[i].begin(), near[i].end());
    const auto size = static_cast<Eigen::Index>(4 * group.size());
    Matrix normal = Matrix::Zero(size, size);
    for (std::size_t a = 0; a < group.size(); ++a)
      for (std::size_t b = 0; b < group.size(); ++b) {
        const std::size_t p = group[a], q = group[b];
        const auto at = std::find(near[p].begin(), near[p].end(), q);
        if (p == q) normal.block<4, 4>(4 * static_cast<Eigen::Index>(a), 4 * static_cast<Eigen::Index>(b)) = block[p][0];
        else if (at != near[p].end())
          normal.block<4, 4>(4 * static_cast<Eigen::Index>(a), 4 * static_cast<Eigen::Index>(b)) = block[p][static_cast<std::size_t>(at - near[p].begin()) + 1];
      }
    normal = 0.5 * (normal + normal.transpose()).eval();
    normal.diagonal().array() += 1e-9 * normal.diagonal().maxCoeff();
    const Matrix first = Matrix::Identity(size, 4);
    const Matrix variance = noise_ * noise_ * normal.ldlt().solve(first);
    const auto root = [](double v) { return std::sqrt(std::max(0.0, v)); };
    errors.push_back({root(0.5 * (variance(0, 0) + variance(1, 1))), root(variance(2, 2)), root(variance(3, 3))});
  }
  return errors;
}

}  // namespace arenite::imaging

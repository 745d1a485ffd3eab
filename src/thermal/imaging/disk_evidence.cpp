#include <algorithm>
#include <cmath>
#include <numbers>

#include "statistics/least_squares.hpp"
#include "thermal/imaging/disk_model.hpp"

namespace arenite::imaging {
/// The picture at a place (linear between pixels) with every other disk taken away, minus the background.
double DiskModel::alone(const Disk& disk, double x, double y) const {
  const int c = static_cast<int>(std::floor(x)), r = static_cast<int>(std::floor(y));
  double sum = 0;
  for (int j = r; j <= r + 1; ++j)
    for (int i = c; i <= c + 1; ++i) {
      if (i < 0 || j < 0 || i >= image_.width || j >= image_.height) return std::nan("");
      const std::size_t at = image_.index(i, j);
      const double own = (disk.level - static_cast<double>(background_[at])) * cover(disk, i, j).share;
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
    double with = 0, without = 0;
    each(disk, [&](int x, int y, std::size_t at) {
      const double c = cover(disk, x, y).share, rest = left(at);
      if (c < 0.5) return;  // what neighbours cover says nothing against this one
      const double own = (disk.level - static_cast<double>(background_[at])) * c;
      with += rest * rest;
      without += (rest + own) * (rest + own);
    });
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
  using Slope = std::array<double, 4>;
  using Block = std::array<Slope, 4>;  // of the normal matrix, between each disk and itself (first) and its neighbours
  std::vector<std::vector<Block>> block(n);
  const auto slope = [&](const Disk& d, int x, int y) {
    const auto [c, edge, nx, ny] = cover(d, x, y);
    const double contrast = d.level - static_cast<double>(background_[image_.index(x, y)]);
    return Slope{contrast * edge * nx, contrast * edge * ny, contrast * edge, c};
  };
  const auto add = [](Block& b, const Slope& own, const Slope& other) {
    for (std::size_t i = 0; i < 4; ++i)
      for (std::size_t j = 0; j < 4; ++j) b[i][j] += own[i] * other[j];
  };
  for (std::size_t i = 0; i < n; ++i) {
    block[i].resize(near[i].size() + 1);
    each(disks_[i], [&](int x, int y, std::size_t) {
      const Slope own = slope(disks_[i], x, y);
      if (own[3] < 1e-5) return;
      add(block[i][0], own, own);
      for (std::size_t k = 0; k < near[i].size(); ++k) add(block[i][k + 1], own, slope(disks_[near[i][k]], x, y));
    });
    if (disks_[i].prior_error > 0) block[i][0][2][2] += noise_ * noise_ / (disks_[i].prior_error * disks_[i].prior_error);
  }
  std::vector<Errors> errors;
  for (std::size_t i = 0; i < n; ++i) {
    std::vector<std::size_t> group{i};
    group.insert(group.end(), near[i].begin(), near[i].end());
    statistics::Matrix normal(4 * group.size(), 4 * group.size());
    for (std::size_t a = 0; a < group.size(); ++a)
      for (std::size_t b = 0; b < group.size(); ++b) {
        const auto& others = near[group[a]];
        const auto at = std::find(others.begin(), others.end(), group[b]);
        if (a != b && at == others.end()) continue;
        const Block& own = block[group[a]][a == b ? 0 : static_cast<std::size_t>(at - others.begin()) + 1];
        for (std::size_t k = 0; k < 4; ++k)
          for (std::size_t l = 0; l < 4; ++l) normal(4 * a + k, 4 * b + l) += 0.5 * own[k][l], normal(4 * b + l, 4 * a + k) += 0.5 * own[k][l];
      }
    double most = 0;
    for (std::size_t k = 0; k < normal.rows(); ++k) most = std::max(most, normal(k, k));
    for (std::size_t k = 0; k < normal.rows(); ++k) normal(k, k) += 1e-9 * most;
    const statistics::Matrix inverse = solve_symmetric(normal, statistics::identity(normal.rows(), 4));
    const auto error = [&](double inverse_of_normal) { return noise_ * std::sqrt(std::max(0.0, inverse_of_normal)); };
    errors.push_back({error(0.5 * (inverse(0, 0) + inverse(1, 1))), error(inverse(2, 2)), error(inverse(3, 3))});
  }
  return errors;
}

}  // namespace arenite::imaging

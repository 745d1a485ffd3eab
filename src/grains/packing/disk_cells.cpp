#include "grains/packing/disk_cells.hpp"

namespace arenite::packing {

namespace {

int cells_along(double length, double size) { return std::max(1, static_cast<int>(std::min(length / size, 20000.0))); }

}  // namespace

DiskCells::DiskCells(const geometry::Box& box, double size)
    : box_(box), columns_(cells_along(box.width, size)), rows_(cells_along(box.height, size)),
      per_width_(columns_ / box.width), per_height_(rows_ / box.height),
      first_(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_), -1) {}

void DiskCells::add(const Disk& disk) {
  // A centre on the far edge rounds into a cell of its own; the last one holds it.
  const int r = std::clamp(row(disk.centre.y), 0, rows_ - 1), c = std::clamp(column(disk.centre.x), 0, columns_ - 1);
  std::int32_t& first = first_[static_cast<std::size_t>(r * columns_ + c)];
  member_.push_back({disk, first});
  first = static_cast<std::int32_t>(member_.size()) - 1;
  largest_ = std::max(largest_, disk.radius);
}

}  // namespace arenite::packing

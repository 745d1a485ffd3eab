#pragma once
#include "core/parameters.hpp"
#include "model/shapes.hpp"

namespace arenite::packing {

struct DiskShape {
  static constexpr Word word{"disk", "a disk"};
  void declare(ParameterVisitor& /*visitor*/) {}
  bool operator==(const DiskShape&) const = default;

  Shape make() const { return {{{}}, {1}, false}; }
};

}  // namespace arenite::packing

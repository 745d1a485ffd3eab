#pragma once
#include <vector>

namespace arenite::stress {

/// What of a node's stress is looked at; hydrostatic is (xx + yy)/2.
enum class Component { yy, xx, xy, hydrostatic };
inline constexpr Component all_components[] = {Component::yy, Component::xx, Component::xy, Component::hydrostatic};

/// Choices that the definitions leave open.
struct StressOptions {
  std::vector<Component> components{Component::yy};
  int clamp_rows = 4;               ///< left out at the lower and the upper edge
  bool leave_out_surface = false;   ///< nodes with a neighbour (of eight) of another phase or grain
  bool leave_out_unloaded = false;  ///< nodes without any stress: parts that no bond ties to a clamp
  bool mean_over_area = false;      ///< the sample's mean counts the void as zero stress: the mean over the whole area;
                                    ///< otherwise over particles and matrix, so that a mean over classes is 1
  int blocks = 6;                   ///< a side, for errors by leaving one block out
  bool operator==(const StressOptions&) const = default;
};

}  // namespace arenite::stress

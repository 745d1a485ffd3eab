#include "grains/fields/stage_numbers.hpp"

namespace arenite::fields {
namespace {

Numbers texture_numbers(const StageEnd& end) { return texture::numbers(end.texture); }

/// Every statistic that there is, in the order of their numbers.
constexpr StageStatistic* statistics[] = {texture_numbers, flow_numbers, cohesion_numbers};

}  // namespace

Numbers stage_numbers(const StageEnd& end) {
  Numbers numbers = Numbers::tree();
  for (StageStatistic* statistic : statistics) numbers.update(statistic(end));
  return numbers;
}

}  // namespace arenite::fields

#include "grains/dem/parts/attitudes.hpp"

#include <cstdint>

#include "grains/dem/sample.hpp"

namespace arenite::dem {

void Attitudes<3>::follow(const SampleIn<3>& s, const ThreadPool& pool) {
  const bool begins = now.size() != s.count;
  if (begins) now.assign(s.count, {}), seen.resize(s.count);
  pool.for_ranges(s.count, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) {
      const std::int32_t grain = s.record[k].grain;
      const Vec3 angle = s.angle[k];
      if (!begins) now[grain] = normalised(geometry::rotation_by(angle - seen[grain]) * now[grain]);
      seen[grain] = angle;
    }
  });
}

}  // namespace arenite::dem

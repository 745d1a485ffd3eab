#pragma once
#include <cstdint>
#include <unordered_map>

#include "io/sample/formats.hpp"

namespace arenite::io {

/// Places of grains by their ids; only looked up, never walked through.
using GrainIndex = std::unordered_map<std::int64_t, std::int32_t>;

/// Makes contacts of the rows, for the packing of the sample, whose grains and domain are there.
void add_contacts(const RawContacts& raw, const RawGrains& grains, const GrainIndex& index,
                  const SampleOptions& options, Sample& sample, Problems& problems);

}  // namespace arenite::io

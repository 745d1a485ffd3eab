#pragma once
#include <cstdint>
#include <unordered_map>

#include "io/sample/formats.hpp"

namespace arenite::io {

/// Places of grains by their ids; only looked up, never walked through.
using GrainIndex = std::unordered_map<std::int64_t, std::int32_t>;

/// Makes contacts of the rows, for the packing of the sample, whose grains and domain are there.
template <int D>
void add_contacts(const RawContacts& raw, const Laid<D>& laid, const GrainIndex& index, const SampleOptions& options,
                  SampleIn<D>& sample, Problems& problems);

}  // namespace arenite::io

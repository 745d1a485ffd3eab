#pragma once
#include "grains/dem/sample.hpp"

namespace arenite::dem {

/// Goes on by so many steps.
template <int D> void advance(SampleIn<D>& sample, const ThreadPool& pool, std::int64_t steps);

}  // namespace arenite::dem

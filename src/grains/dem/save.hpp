#pragma once
#include <cstdint>
#include <vector>

#include "grains/dem/sample.hpp"

namespace arenite::dem {

/// Every bit that decides the future of a sample, beside its start and parameters. The list is not among them: it
/// follows from where the disks were when it was built, so that restoring lists the same slots in the same order. A
/// sample made from the same start and parameters and then restored goes on with the same bits as if it had never
/// stopped.
template <int D> std::vector<std::uint8_t> save_sample(const SampleIn<D>& sample);

/// Throws InputError if the bytes are not a state of this sample (cut short, other grains, other step, written by
/// another version); the sample is then as it was.
template <int D> void restore_sample(SampleIn<D>& sample, const std::vector<std::uint8_t>& bytes);

/// Of every bit that decides the future.
template <int D> std::uint64_t state_hash(const SampleIn<D>& sample);

}  // namespace arenite::dem

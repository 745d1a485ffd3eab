#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <vector>

#include "core/error.hpp"
#include "io/volume/volume.hpp"

/// Bytes as a volume, read layer by layer.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace arenite;
  try {
    const auto volume = io::open_volume(io::bytes_in_memory({reinterpret_cast<const char*>(data), size}, "volume"), {});
    const io::VolumeFacts& facts = volume->facts();
    if (facts.width < 1 || facts.height < 1 || facts.depth < 1) std::abort();
    if (facts.dx && !(*facts.dx > 0)) std::abort();
    std::vector<std::int32_t> layer(facts.slice());
    for (int z = 0; z < facts.depth; ++z) volume->read(z, layer);
  } catch (const InputError& error) {
    if (error.problems().empty()) std::abort();
  }
  return 0;
}

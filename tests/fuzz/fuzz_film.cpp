#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>
#include <utility>

#include "core/error.hpp"
#include "io/film/film.hpp"
#include "io/film/formats.hpp"

namespace {

using namespace arenite;

/// Small enough that a run is quick; the rule is the same for any limit.
constexpr std::int64_t most_pixels = 1 << 14;

void examine(FilmSource& film) {
  const FilmInfo& info = film.info();
  if (info.width <= 0 || info.height <= 0 || info.frames <= 0 || static_cast<std::int64_t>(info.pixels()) > most_pixels)
    std::abort();
  if (!info.time.empty() && static_cast<std::int64_t>(info.time.size()) != info.frames) std::abort();
  for (std::size_t i = 1; i < info.time.size(); ++i)
    if (!(info.time[i] > info.time[i - 1])) std::abort();
  io::frame_intervals(info);
  FrameBlock block;
  const auto few = std::min<std::int64_t>(info.frames, 4);
  for (const std::int64_t first : {std::int64_t{0}, info.frames - few}) {
    film.read(first, static_cast<std::size_t>(few), block);
    const std::size_t pixels = static_cast<std::size_t>(few) * info.pixels();
    if (block.level.size() + block.value.size() != pixels || block.value.empty() == info.floating) std::abort();
  }
}

const io::FilmFormat* format = nullptr;

}  // namespace

/// The program has a name a format, as the list has it: fuzz_film_ptw reads films of the format ptw.
extern "C" int LLVMFuzzerInitialize(int* /*argc*/, char*** argv) {
#define ARENITE_NAMED_FORMAT(word) {"_film_" #word, &io::films::word},
  constexpr std::pair<std::string_view, const io::FilmFormat*> formats[] = {ARENITE_FILM_FORMATS(ARENITE_NAMED_FORMAT)};
  const std::string_view program = **argv;
  for (const auto& [ending, known] : formats)
    if (program.ends_with(ending)) format = known;
  if (format == nullptr) std::abort();
  return 0;
}

/// Any bytes are a film of the format or an InputError.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  io::FilmChoice choice;
  choice.most_pixels = most_pixels;
  try {
    examine(*format->open(io::bytes_in_memory(std::string(reinterpret_cast<const char*>(data), size), "film"), choice));
  } catch (const InputError& error) {
    if (error.problems().empty()) std::abort();
  }
  return 0;
}

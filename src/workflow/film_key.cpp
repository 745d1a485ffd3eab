#include "workflow/film_key.hpp"

#include <algorithm>
#include <fstream>
#include <string_view>

#include "core/hash.hpp"
#include "io/film.hpp"
#include "io/read_file.hpp"
#include "workflow/film_correction.hpp"

namespace arenite::study {
namespace {

namespace fs = std::filesystem;

/// Counts up whenever the same film and recipe give other numbers.
constexpr std::int64_t film_version = 4;

/// The bytes of a file that need not fit into memory.
void add_file(HashBuilder& hash, const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::string part(std::size_t{8} << 20, '\0');
  while (file.read(part.data(), static_cast<std::streamsize>(part.size())) || file.gcount() > 0)
    hash.add("part", content_hash(std::string_view(part).substr(0, static_cast<std::size_t>(file.gcount()))));
}

template <class T>
std::string_view bytes_of(const std::vector<T>& values) {
  return {reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T)};
}

void add_frames(HashBuilder& hash, FilmSource& source) {
  const std::int64_t frames = source.info().frames;
  constexpr std::int64_t together = 32;
  FrameBlock block;
  for (std::int64_t k = 0; k < frames; k += together) {
    source.read(k, static_cast<std::size_t>(std::min(together, frames - k)), block);
    hash.add("levels", content_hash(bytes_of(block.level)));
    hash.add("values", content_hash(bytes_of(block.value)));
  }
}

/// What a film says about itself may stand beside its frames, in another file.
void add_info(HashBuilder& hash, const FilmInfo& info) {
  hash.add("width", std::int64_t{info.width}).add("height", std::int64_t{info.height}).add("frames", info.frames);
  hash.add("frame_rate", info.frame_rate).add("integration", info.integration).add("bits", std::int64_t{info.bits});
  hash.add("floating", std::int64_t{info.floating}).add("quantity", static_cast<std::int64_t>(info.quantity));
  hash.add("emissivity", info.emissivity).add("ambient", info.ambient);
  hash.add("band_low", info.band_low).add("band_high", info.band_high);
  hash.add("time", content_hash(bytes_of(info.time)));
}

void add_film(HashBuilder& hash, const char* name, const fs::path& path, FilmSource& source) {
  hash.add("film", name);
  add_info(hash, source.info());
  // A raw film may be named by the file that describes its frames.
  if (fs::is_regular_file(path) && source.info().format != "raw") add_file(hash, path);
  else add_frames(hash, source);
}

}  // namespace

std::string film_key(const fs::path& film, FilmSource& source, const FilmRecipe& recipe) {
  HashBuilder hash;
  hash.add("film version", film_version).add("recipe", to_toml(recipe));
  add_film(hash, "film", film, source);
  const auto beside = [&](const std::string& file) { return fs::path(recipe.source_file).parent_path() / file; };
  const auto add_plate = [&](const char* name, const std::string& file) {
    if (!file.empty()) add_film(hash, name, beside(file), *io::open_film(beside(file), reading_of(recipe)));
  };
  const auto add = [&](const char* name, const std::string& file) {
    if (!file.empty()) hash.add(name, content_hash(io::read_file(beside(file))));
  };
  add_plate("cold", recipe.correction.cold);
  add_plate("warm", recipe.correction.warm);
  add("curve", recipe.temperature.curve);
  add("grains", recipe.picture.grains);
  add("optical", recipe.picture.optical);
  if (recipe.twin) add("twin", recipe.twin->recipe);
  return hash.hex();
}

}  // namespace arenite::study

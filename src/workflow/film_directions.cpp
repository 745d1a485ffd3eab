#include "workflow/film_directions.hpp"

#include "grains/texture/texture.hpp"

namespace arenite::study {
namespace {


Numbers directions_of(const Packing& packing) {
  texture::Options options;
  options.rev_sizes = 0;
  const Numbers measured = texture::numbers(texture::measure(packing, options), true);
  Numbers out = Numbers::tree();
  if (!measured.contains("fabric")) return out;
  for (const char* key : {"contacts", "a_c", "theta_c_deg", "a_c_noise", "sectors"})
    if (measured["fabric"].contains(key)) out[key] = measured["fabric"][key];
  return out;
}

}  // namespace

Numbers film_directions(const FilmResult& film, const Packing* twin) {
  Numbers out = Numbers::tree();
  const auto add = [&](const char* name, const Packing& packing) {
    if (Numbers directions = directions_of(packing); directions.value("contacts", 0) > 0) out[name] = std::move(directions);
  };
  if (film.packing.contacts.size() == 0) return out;
  add("film", film.packing);
  if (twin) add("twin", *twin);
  return out;
}

}  // namespace arenite::study

#include "study/film_directions.hpp"

#include "texture/texture.hpp"

namespace arenite::study {
namespace {

using Json = nlohmann::ordered_json;

Json directions_of(const Packing& packing) {
  texture::Options options;
  options.rev_sizes = 0;
  const Json measured = Json::parse(texture::to_json(texture::measure(packing, options), true));
  Json out = Json::object();
  if (!measured.contains("fabric")) return out;
  for (const char* key : {"contacts", "a_c", "theta_c_deg", "a_c_noise", "sectors"})
    if (measured["fabric"].contains(key)) out[key] = measured["fabric"][key];
  return out;
}

}  // namespace

Packing without_absent(const FilmResult& film) {
  Packing packing = film.packing;
  packing.contacts = {};
  const Contacts& all = film.packing.contacts;
  for (std::size_t c = 0; c < all.size(); ++c)
    if (film.absent.empty() || !film.absent[c]) packing.contacts.add(all.i[c], all.j[c], all.normal(c), all.fn[c], all.ft[c], all.arm_i[c], all.arm_j[c]);
  return packing;
}

nlohmann::ordered_json film_directions(const FilmResult& film, const Packing* twin) {
  Json out = Json::object();
  const auto add = [&](const char* name, const Packing& packing) {
    if (Json directions = directions_of(packing); directions.value("contacts", 0) > 0) out[name] = std::move(directions);
  };
  if (film.packing.contacts.size() == 0) return out;
  add("film", without_absent(film));
  if (twin) add("twin", *twin);
  return out;
}

}  // namespace arenite::study

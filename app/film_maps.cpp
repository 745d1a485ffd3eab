#include "film_maps.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "io/film_writer.hpp"
#include "workflow/result_folder.hpp"

namespace arenite::app {

void write_maps(const std::string& folder, const std::string& format, const FilmMaps& maps) {
  study::make_folder(folder);
  const char* ending = format == "hdf5" ? ".h5" : format == "npy" ? ".npy" : ".tif";
  for (const auto& [name, map] : maps.named) {
    if (map->empty()) continue;
    Film film;
    film.about.width = maps.width;
    film.about.height = maps.height;
    film.about.frames = 1;
    film.about.floating = true;
    film.value = *map;
    io::write_film(std::filesystem::path(folder) / (std::string(name) + ending), film);
  }
}

}  // namespace arenite::app

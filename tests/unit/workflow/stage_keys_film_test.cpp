#include "workflow/stage_keys.hpp"

#include <gtest/gtest.h>

#include <fstream>

#include "io/film/film.hpp"
#include "recipe/film_recipe.hpp"
#include "support/temporary_folder.hpp"

namespace {
using namespace arenite;

std::string key_of(const std::filesystem::path& film, const recipe::FilmRecipe& recipe = recipe::film_template()) {
  recipe::FilmRecipe alone = recipe;
  alone.correction = {};
  alone.picture.optical.clear();
  alone.simulation.reset();
  workflow::KnownFilms known;
  return workflow::film_key(film, *io::open_film(film), alone, known);
}

void write(const std::filesystem::path& file, const std::string& text) {
  std::ofstream(file, std::ios::binary) << text;
}

TEST(FilmKey, NoticesAChangedFrameOfASeries) {
  const test::TemporaryFolder folder;
  std::filesystem::create_directory(folder / "frames");
  for (const char* name : {"f1.csv", "f2.csv"}) write(folder / "frames" / name, "20.0,21.0\n22.0,23.0\n");
  const std::string before = key_of(folder / "frames");
  EXPECT_EQ(key_of(folder / "frames"), before);
  write(folder / "frames" / "f2.csv", "20.0,21.0\n22.0,23.5\n");
  EXPECT_NE(key_of(folder / "frames"), before);
}

TEST(FilmKey, NoticesChangedFramesAndSidecarOfARawFilm) {
  const test::TemporaryFolder folder;
  write(folder / "film.raw", std::string(2 * 2 * 2 * 2, '\1'));
  const std::string about = "width = 2\nheight = 2\ntype = \"uint16\"\nframe_rate = \"100 Hz\"\n";
  write(folder / "film.toml", about);
  const std::string before = key_of(folder / "film.raw");
  EXPECT_EQ(key_of(folder / "film.raw"), before);
  write(folder / "film.raw", std::string(15, '\1') + "\2");
  const std::string frame = key_of(folder / "film.raw");
  EXPECT_NE(frame, before);
  write(folder / "film.toml", "width = 2\nheight = 2\ntype = \"uint16\"\nframe_rate = \"50 Hz\"\n");
  EXPECT_NE(key_of(folder / "film.raw"), frame);
}

TEST(FilmKey, FollowsFromChangedKeysOnly) {
  const test::TemporaryFolder folder;
  std::filesystem::create_directory(folder / "frames");
  for (const char* name : {"f1.csv", "f2.csv"}) write(folder / "frames" / name, "20.0,21.0\n22.0,23.0\n");
  const recipe::FilmRecipe plain = recipe::film_template();
  const std::string text = to_toml(plain), before = key_of(folder / "frames");
  EXPECT_EQ(
      key_of(folder / "frames", recipe::parse_film_recipe(text, "r.toml", {"lockin.drift=4", "forces.friction=0.3"})),
      before);
  EXPECT_NE(key_of(folder / "frames", recipe::parse_film_recipe(text, "r.toml", {"lockin.drift=3"})), before);
  EXPECT_NE(key_of(folder / "frames", recipe::parse_film_recipe(text, "r.toml", {"lockin.phase=90 deg"})), before);
}

}  // namespace

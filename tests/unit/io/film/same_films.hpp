#pragma once
#include <cstdint>
#include <memory>
#include <string>

#include "io/film/formats.hpp"
#include "support/films.hpp"

namespace arenite::io {

/// What was read is what the film holds, at once, in blocks of two and one frame by itself.
inline void expect_same(FilmSource& read, const Film& film) {
  ASSERT_EQ(read.info().width, film.about.width);
  ASSERT_EQ(read.info().height, film.about.height);
  ASSERT_EQ(read.info().frames, film.about.frames);
  ASSERT_EQ(read.info().floating, film.about.floating);
  const FrameBlock all = test::all_of(read);
  EXPECT_EQ(all.level, film.level);
  EXPECT_EQ(all.value, film.value);
  FrameBlock part;
  for (std::int64_t f = film.about.frames - 1; f >= 0; --f) {
    read.read(f, 1, part);
    EXPECT_EQ(part.first, f);
    for (std::size_t p = 0; p < film.about.pixels(); ++p) {
      const std::size_t at = static_cast<std::size_t>(f) * film.about.pixels() + p;
      if (film.about.floating) EXPECT_EQ(part.value[p], film.value[at]);
      else EXPECT_EQ(part.level[p], film.level[at]);
    }
  }
  EXPECT_THROW(read.read(film.about.frames, 1, part), std::out_of_range);
}

inline std::unique_ptr<FilmSource> opened(const std::string& bytes, const FilmChoice& choice = {}) {
  return open_film(bytes_in_memory(bytes, "film"), choice);
}

inline Film as_floating(Film film) {
  film.about.floating = true;
  film.value.assign(film.level.begin(), film.level.end());
  film.level.clear();
  return film;
}

}  // namespace arenite::io

#pragma once
#include <tiffio.h>

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "model/film.hpp"
#include "support/films.hpp"

namespace arenite::io {

/// A page for each image, the first with a description.
inline void write_pages(const std::filesystem::path& path, const Film& film, const std::string& description) {
  TIFF* tiff = TIFFOpen(path.c_str(), "w");
  for (std::int64_t f = 0; f < film.about.frames; ++f) {
    TIFFSetField(tiff, TIFFTAG_IMAGEWIDTH, film.about.width);
    TIFFSetField(tiff, TIFFTAG_IMAGELENGTH, film.about.height);
    TIFFSetField(tiff, TIFFTAG_BITSPERSAMPLE, 16);
    TIFFSetField(tiff, TIFFTAG_SAMPLESPERPIXEL, 1);
    TIFFSetField(tiff, TIFFTAG_PHOTOMETRIC, PHOTOMETRIC_MINISBLACK);
    TIFFSetField(tiff, TIFFTAG_ROWSPERSTRIP, film.about.height);
    if (f == 0) TIFFSetField(tiff, TIFFTAG_IMAGEDESCRIPTION, description.c_str());
    std::vector<std::uint16_t> image(film.level.begin() + f * 20, film.level.begin() + (f + 1) * 20);
    TIFFWriteEncodedStrip(tiff, 0, image.data(), 40);
    TIFFWriteDirectory(tiff);
  }
  TIFFClose(tiff);
}

}  // namespace arenite::io

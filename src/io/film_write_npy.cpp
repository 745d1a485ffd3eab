#include <fmt/format.h>

#include "io/film_writers.hpp"

namespace arenite::io {
namespace {

constexpr std::size_t header_size = 128;

class NpyFilmWriter : public FilmWriter {
 public:
  NpyFilmWriter(const std::filesystem::path& path, const FilmInfo& info) : file_(path), info_(info) { file_.write(header()); }
  void append(const FrameBlock& block) override {
    file_.write(pixel_bytes(info_, block));
    frames_ += block.frames;
  }
  void finish() override {
    file_.overwrite(0, header());
    file_.commit();
  }

 private:
  std::string header() const {
    std::string text("\x93NUMPY\x01\0v\0", 10);
    text += fmt::format("{{'descr': '{}', 'fortran_order': False, 'shape': ({}, {}, {}), }}", info_.floating ? "<f4" : "<u2", frames_,
                        info_.height, info_.width);
    text.resize(header_size - 1, ' ');
    return text + '\n';
  }

  AtomicFile file_;
  FilmInfo info_;
  std::size_t frames_ = 0;
};
static_assert(header_size - 10 == 'v');

}  // namespace

FilmWriterPointer create_npy_film(const std::filesystem::path& path, const FilmInfo& info) { return std::make_unique<NpyFilmWriter>(path, info); }

}  // namespace arenite::io

#include <fmt/format.h>

#include "io/film_writers.hpp"

namespace arenite::io {
namespace {

/// Digits left free for the number of frames, which is known at the end.
constexpr std::size_t count_width = 12;

class SfmovFilmWriter : public FilmWriter {
 public:
  SfmovFilmWriter(const std::filesystem::path& path, const FilmInfo& info) : file_(path), info_(info) { file_.write(header()); }
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
    std::string text = fmt::format("HdSize auto\r\nNumDPs {:0{}}\r\nxPixls {}\r\nyPixls {}\r\nDaType {}\r\n", frames_, count_width, info_.width,
                                   info_.height, info_.floating ? "Flt32" : "UInt16");
    if (info_.bits > 0) text += fmt::format("ADBits {}\r\n", info_.bits);
    if (info_.frame_rate > 0) text += fmt::format("FRate_0 {}\r\n", info_.frame_rate);
    if (info_.integration > 0) text += fmt::format("ITime_0 {}\r\n", info_.integration * 1e3);
    return text + "DATA\r\n";
  }

  AtomicFile file_;
  FilmInfo info_;
  std::size_t frames_ = 0;
};

}  // namespace

FilmWriterPointer create_sfmov_film(const std::filesystem::path& path, const FilmInfo& info) { return std::make_unique<SfmovFilmWriter>(path, info); }

}  // namespace arenite::io

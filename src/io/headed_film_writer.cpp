#include "io/headed_film_writer.hpp"

namespace arenite::io {
namespace {

using Header = std::string (*)(const FilmInfo&, std::size_t frames);

class HeadedFilmWriter : public FilmWriter {
 public:
  HeadedFilmWriter(const std::filesystem::path& path, const FilmInfo& info, Header header) : file_(path), info_(info), header_(header) {
    file_.write(header_(info_, 0));
  }
  void append(const FrameBlock& block) override {
    file_.write(pixel_bytes(info_, block));
    frames_ += block.frames;
  }
  void finish() override {
    file_.overwrite(0, header_(info_, frames_));
    file_.commit();
  }

 private:
  AtomicFile file_;
  FilmInfo info_;
  Header header_;
  std::size_t frames_ = 0;
};

}  // namespace

FilmWriterPointer create_headed_film(const std::filesystem::path& path, const FilmInfo& info, Header header) {
  return std::make_unique<HeadedFilmWriter>(path, info, header);
}

}  // namespace arenite::io

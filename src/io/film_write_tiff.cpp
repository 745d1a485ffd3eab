#include <fmt/format.h>

#include <algorithm>

#include "io/film_notes.hpp"
#include "io/film_writers.hpp"

namespace arenite::io {
namespace {

enum Type : std::uint16_t { ascii = 2, short_ = 3, long_ = 4, long8 = 16 };

/// A directory of a page, whose texts lie right after it.
class Directory {
 public:
  Directory(bool large, std::uint64_t at) : large_(large), at_(at) {}
  void number(std::uint16_t tag, Type type, std::uint64_t value) { entries_.push_back({tag, type, value, {}}); }
  void text(std::uint16_t tag, std::string value) { entries_.push_back({tag, ascii, 0, std::move(value) + '\0'}); }

  /// Entries must have come in the order of their tags.
  std::string bytes(bool last) const {
    const std::uint64_t tail = at_ + (large_ ? 8 + 20 * entries_.size() + 8 : 2 + 12 * entries_.size() + 4);
    std::string out, texts;
    large_ ? append<std::uint64_t>(out, entries_.size()) : append<std::uint16_t>(out, static_cast<std::uint16_t>(entries_.size()));
    for (const Entry& entry : entries_) {
      append<std::uint16_t>(out, entry.tag);
      append<std::uint16_t>(out, entry.type);
      place(out, entry.text.empty() ? 1 : entry.text.size());
      const bool inside = entry.text.empty() || entry.text.size() <= (large_ ? 8U : 4U);
      if (entry.text.empty()) {
        place(out, entry.value);
      } else if (inside) {
        out += entry.text + std::string((large_ ? 8 : 4) - entry.text.size(), '\0');
      } else {
        place(out, tail + texts.size());
        texts += entry.text;
      }
    }
    if ((tail + texts.size()) % 2 != 0) texts += '\0';  // directories begin at even places
    place(out, last ? 0 : tail + texts.size());
    return out + texts;
  }

 private:
  struct Entry {
    std::uint16_t tag;
    Type type;
    std::uint64_t value;
    std::string text;
  };
  void place(std::string& out, std::uint64_t value) const {
    large_ ? append<std::uint64_t>(out, value) : append<std::uint32_t>(out, static_cast<std::uint32_t>(value));
  }

  bool large_;
  std::uint64_t at_;
  std::vector<Entry> entries_;
};

/// All pixels one after the other, then the directories of all pages: whether they need 64 bits is known by then.
class TiffFilmWriter : public FilmWriter {
 public:
  TiffFilmWriter(const std::filesystem::path& path, const FilmInfo& info) : file_(path), info_(info) { file_.write(std::string(start, '\0')); }
  void append(const FrameBlock& block) override {
    file_.write(pixel_bytes(info_, block));
    frames_ += block.frames;
  }
  void finish() override {
    const std::uint64_t frame = info_.pixels() * (info_.floating ? 4 : 2), pixels = frame * frames_;
    std::uint64_t at = start + pixels + pixels % 2;
    constexpr std::uint64_t most_a_page = 4096;
    const std::uint64_t announced = static_cast<std::uint64_t>(std::max<std::int64_t>(info_.frames, 0));
    const bool large = at > 0xffffffffU || std::max(frames_, announced) * (frame + most_a_page) > 0xffffffffU;
    file_.overwrite(0, head(large, at));
    if (pixels % 2 != 0) file_.write(std::string(1, '\0'));
    for (std::uint64_t i = 0; i < frames_; ++i) {
      const std::string bytes = directory(large, at, i, start + i * frame, frame);
      file_.write(bytes);
      at += bytes.size();
    }
    file_.commit();
  }

 private:
  static constexpr std::uint64_t start = 16;

  static std::string head(bool large, std::uint64_t first) {
    std::string out = "II";
    if (!large) {
      io::append<std::uint16_t>(out, 42);
      io::append<std::uint32_t>(out, static_cast<std::uint32_t>(first));
      return out;
    }
    io::append<std::uint16_t>(out, 43);
    io::append<std::uint32_t>(out, 8);
    io::append<std::uint64_t>(out, first);
    return out;
  }

  std::string directory(bool large, std::uint64_t at, std::uint64_t frame, std::uint64_t pixels, std::uint64_t size) const {
    std::string notes = frame == 0 ? film_notes(info_) : "";
    if (frame < info_.time.size()) notes += fmt::format("time = {:.9f}\n", info_.time[frame]);
    Directory directory(large, at);
    directory.number(256, long_, static_cast<std::uint64_t>(info_.width));
    directory.number(257, long_, static_cast<std::uint64_t>(info_.height));
    directory.number(258, short_, info_.floating ? 32 : 16);
    directory.number(259, short_, 1);                      // not compressed
    directory.number(262, short_, 1);                      // black is the smallest
    if (!notes.empty()) directory.text(270, notes);
    directory.number(273, large ? long8 : long_, pixels);  // one strip
    directory.number(277, short_, 1);
    directory.number(278, long_, static_cast<std::uint64_t>(info_.height));
    directory.number(279, large ? long8 : long_, size);
    directory.number(339, short_, info_.floating ? 3 : 1);
    return directory.bytes(frame + 1 == frames_);
  }

  AtomicFile file_;
  FilmInfo info_;
  std::uint64_t frames_ = 0;
};

}  // namespace

FilmWriterPointer create_tiff_film(const std::filesystem::path& path, const FilmInfo& info) { return std::make_unique<TiffFilmWriter>(path, info); }

}  // namespace arenite::io

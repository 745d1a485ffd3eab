#include <algorithm>
#include <cmath>

#include "core/error.hpp"
#include "io/film_writers.hpp"

namespace arenite::io {
namespace {

constexpr std::size_t main_header = 3476, frame_header = 1016;

/// The header places that film_ptw.cpp reads; the rest is zero.
class PtwFilmWriter : public FilmWriter {
 public:
  PtwFilmWriter(const std::filesystem::path& path, const FilmInfo& info) : file_(path), info_(info) {
    if (info.floating) throw InputError(path.string(), 0, "cannot hold temperatures: a .ptw film is of levels; write .tif, .npy, .h5 or .sfmov");
    file_.write(header());
  }
  void append(const FrameBlock& block) override {
    const std::string_view bytes = pixel_bytes(info_, block);
    const std::size_t frame = 2 * info_.pixels();
    for (std::size_t i = 0; i < block.frames; ++i) {
      file_.write(stamp(frames_++));
      file_.write(bytes.substr(i * frame, frame));
    }
  }
  void finish() override {
    file_.overwrite(0, header());
    file_.commit();
  }

 private:
  std::string header() const {
    std::string h(main_header, '\0');
    const auto words = static_cast<std::int32_t>(info_.pixels());
    h.replace(0, 3, "CED");
    h.replace(5, 4, "5.60");
    h[10] = 26;
    put<std::int32_t>(h, 11, main_header);
    put<std::int32_t>(h, 15, frame_header);
    put<std::int32_t>(h, 19, words + static_cast<std::int32_t>(frame_header) / 2);
    put<std::int32_t>(h, 23, words);
    put<std::int32_t>(h, 27, static_cast<std::int32_t>(frames_));
    const auto name = [&](std::size_t at, const std::string& text) { h.replace(at, std::min<std::size_t>(text.size(), 19), text, 0, 19); };
    name(44, info_.camera);
    name(64, info_.lens);
    name(84, info_.filter);
    put<float>(h, 141, static_cast<float>(info_.emissivity));
    put<float>(h, 145, static_cast<float>(info_.ambient));
    put<float>(h, 188, static_cast<float>(info_.band_low * 1e6));
    put<float>(h, 192, static_cast<float>(info_.band_high * 1e6));
    put<std::int16_t>(h, 377, static_cast<std::int16_t>(info_.width));
    put<std::int16_t>(h, 379, static_cast<std::int16_t>(info_.height));
    put<std::int16_t>(h, 381, static_cast<std::int16_t>(info_.bits > 0 ? info_.bits : 16));
    put<float>(h, 403, info_.frame_rate > 0 ? static_cast<float>(1 / info_.frame_rate) : 0.0F);
    put<float>(h, 407, static_cast<float>(info_.integration));
    return h;
  }

  /// Microseconds after midnight, in the places of a camera's own headers; zeros without times.
  std::string stamp(std::size_t frame) const {
    std::string h(frame_header, '\0');
    put<std::uint32_t>(h, 292, static_cast<std::uint32_t>(frame + 1));
    if (frame >= info_.time.size()) return h;
    constexpr std::uint64_t day = 86400'000'000;
    const auto us = static_cast<std::uint64_t>(std::llround(info_.time[frame] * 1e6)) % day;
    h[81] = static_cast<char>(us / 3600'000'000);
    h[80] = static_cast<char>(us / 60'000'000 % 60);
    h[83] = static_cast<char>(us / 1'000'000 % 60);
    h[82] = static_cast<char>(us / 10'000 % 100);
    h[160] = static_cast<char>(us / 1000 % 10);
    put<std::uint16_t>(h, 161, static_cast<std::uint16_t>(us % 1000));
    put<std::uint64_t>(h, 301, us);
    return h;
  }

  AtomicFile file_;
  FilmInfo info_;
  std::size_t frames_ = 0;
};

}  // namespace

FilmWriterPointer create_ptw_film(const std::filesystem::path& path, const FilmInfo& info) { return std::make_unique<PtwFilmWriter>(path, info); }

}  // namespace arenite::io

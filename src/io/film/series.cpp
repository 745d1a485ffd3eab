#include <fmt/core.h>
#include <fnmatch.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <numeric>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/problems.hpp"
#include "io/film/file_names.hpp"
#include "io/film/formats.hpp"

namespace arenite::io {

namespace fs = std::filesystem;
namespace {

/// Whether a name fits a pattern in which * stands for anything, and nothing else for what it is not.
bool fits(const std::string& name, std::string_view pattern) {
  std::string exact;
  for (const char c : pattern) exact += c == '*' ? "*" : std::string("\\") + c;
  return ::fnmatch(exact.c_str(), name.c_str(), 0) == 0;
}

constexpr const char* digits = "0123456789";

std::vector<fs::path> members(const fs::path& pattern) {
  const bool folder = fs::is_directory(pattern);
  const fs::path where = folder ? pattern : pattern.has_parent_path() ? pattern.parent_path() : fs::path(".");
  if (!fs::is_directory(where)) refuse(where.string(), "there is no such folder; check its name");
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(where)) {
    const std::string name = entry.path().filename().string();
    if (!entry.is_regular_file() || name.starts_with('.')) continue;
    if (folder ? name.find_first_of(digits) != std::string::npos : fits(name, pattern.filename().string()))
      names.push_back(name);
  }
  std::ranges::sort(names, {}, sorting_key);
  std::vector<fs::path> paths;
  for (const std::string& name : names) paths.push_back(where / name);
  return paths;
}

/// All files have as many frames as the first, which is checked when they are read.
class Series : public KnownFilm {
 public:
  Series(std::vector<fs::path> members, const FilmChoice& choice) : members_(std::move(members)), choice_(choice) {
    const auto rate = std::exchange(choice_.frame_rate, std::nullopt);
    open(0);
    info_ = current_->info();
    each_ = info_.frames;
    info_.frames *= static_cast<std::int64_t>(members_.size());
    info_.time.clear();
    if (!std::exchange(info_.number, {}).empty())
      info_.remarks.emplace_back("Its files number their frames within; in a series these numbers are left aside.");
    if (choice_.in_time && (rate || !take_stamps_of_files()) && !take_times_of_names(rate))
      take_file_numbers(numbers_in_names(members_));
    choice_.frame_rate = rate;
    take_choice(info_, choice_);
  }

  void fill(std::int64_t first, std::size_t count, FrameBlock& block) override {
    for (std::size_t i = 0; i < count;) {
      const std::int64_t frame = first + static_cast<std::int64_t>(i), within = frame % each_;
      open(static_cast<std::size_t>(frame / each_));
      const std::size_t n = std::min(count - i, static_cast<std::size_t>(each_ - within));
      current_->read(within, n, part_);
      std::copy(part_.level.begin(), part_.level.end(),
                block.level.begin() + static_cast<std::ptrdiff_t>(info_.floating ? 0 : i * info_.pixels()));
      std::copy(part_.value.begin(), part_.value.end(),
                block.value.begin() + static_cast<std::ptrdiff_t>(info_.floating ? i * info_.pixels() : 0));
      i += n;
    }
  }

 private:
  /// False where files have no stamps, or none that can be used.
  bool take_stamps_of_files() {
    if (!std::isfinite(current_->info().start) || (each_ > 1 && current_->info().time.empty())) return false;
    std::vector<double> stamp;
    for (std::size_t m = 0; m < members_.size(); ++m) {
      open(m);
      const FilmInfo& it = current_->info();
      for (std::int64_t k = 0; k < each_; ++k)
        stamp.push_back(it.start + (it.time.empty() ? 0 : it.time[static_cast<std::size_t>(k)]));
    }
    take_stamps(info_, std::move(stamp));
    return !info_.time.empty();
  }

  /// With a frame rate they only show which frames are missing. False where names state no times.
  bool take_times_of_names(std::optional<double> rate) {
    std::vector<double> time = each_ == 1 ? times_in_names(members_) : std::vector<double>();
    if (time.empty()) return false;
    if (!rate) {
      info_.remarks.emplace_back("Times of frames are those in the names of its files.");
      take_stamps(info_, std::move(time));
      return true;
    }
    constexpr double aside = 0.35;  // of a frame: more than times rounded to milliseconds leave at usual rates
    std::vector<std::int64_t> frame{0};
    for (std::size_t i = 1; i < time.size(); ++i) {
      const double step = (time[i] - time[i - 1]) * *rate, whole = std::round(step);
      if (whole < 1 || std::abs(step - whole) > aside) {
        info_.remarks.push_back(fmt::format(
            "The times in the names of its files do not fit {:.6g} Hz; frames are taken as consecutive.", *rate));
        return true;
      }
      frame.push_back(frame.back() + static_cast<std::int64_t>(whole));
    }
    take_numbers(info_, std::move(frame));
    return true;
  }

  /// Numbers of all frames from those in the names of their files, in steps of the smallest one. Where most would be
  /// missing the numbers count something else.
  void take_file_numbers(const std::vector<std::int64_t>& file) {
    if (members_.size() < 2) return;
    std::int64_t unit = 0, near = 0;
    for (std::size_t i = 1; i < file.size(); ++i) unit = std::gcd(unit, file[i] - file[i - 1]);
    for (std::size_t i = 1; i < file.size(); ++i) near += file[i] - file[i - 1] == unit ? 2 : -1;
    if (unit <= 0 || near <= 0) {
      info_.remarks.emplace_back(
          "The names of its files do not count frames one by one; frames are taken as consecutive.");
      return;
    }
    if (unit > 1)
      info_.remarks.push_back(fmt::format("The numbers of its files rise by {}, which is taken as one frame.", unit));
    std::vector<std::int64_t> frame;
    for (const std::int64_t n : file)
      for (std::int64_t k = 0; k < each_; ++k) frame.push_back((n - file.front()) / unit * each_ + k);
    take_numbers(info_, std::move(frame));
  }

  void open(std::size_t member) {
    if (current_ && member == number_) return;
    current_ = open_film(open_bytes(members_[member]), choice_);
    number_ = member;
    const FilmInfo& it = current_->info();
    if (each_ > 0 && it.quantity != info_.quantity)
      refuse(members_[member].string(),
             "states another unit of its pixels than {}; all frames of a series must be alike, so give them one",
             members_[0].filename().string());
    if (each_ == 0 ||
        (it.width == info_.width && it.height == info_.height && it.frames == each_ && it.floating == info_.floating))
      return;
    refuse(members_[member].string(),
           "holds {} frames of {} x {} pixels, but {} holds {} of {} x {}; all frames of a series must be alike",
           it.frames, it.width, it.height, members_[0].filename().string(), each_, info_.width, info_.height);
  }

  std::vector<fs::path> members_;
  FilmChoice choice_;
  std::unique_ptr<FilmSource> current_;
  std::size_t number_ = 0;
  std::int64_t each_ = 0;
  FrameBlock part_;
};

class ScaledFilm : public KnownFilm {
 public:
  ScaledFilm(FilmPointer film, double scale, double offset) : film_(std::move(film)), scale_(scale), offset_(offset) {
    info_ = film_->info();
    info_.floating = true;
    info_.bits = 0;
    info_.quantity = FilmQuantity::kelvin;
  }

  void fill(std::int64_t first, std::size_t count, FrameBlock& block) override {
    film_->read(first, count, part_);
    const auto kelvin = [&](auto v) { return static_cast<float>(scale_ * static_cast<double>(v) + offset_); };
    std::transform(part_.level.begin(), part_.level.end(), block.value.begin(), kelvin);
    std::transform(part_.value.begin(), part_.value.end(), block.value.begin(), kelvin);
  }

 private:
  FilmPointer film_;
  double scale_, offset_;
  FrameBlock part_;
};

}  // namespace

std::vector<fs::path> files_of_series(const fs::path& pattern) {
  auto found = members(pattern);
  if (found.empty())
    refuse(pattern.string(),
           "holds no files with numbers in their names, which would be the frames of a film or the slices of a volume; "
           "check the name");
  return found;
}

FilmPointer open_series(const fs::path& pattern, const FilmChoice& choice) {
  return std::make_unique<Series>(files_of_series(pattern), choice);
}

FilmPointer scaled_film(FilmPointer film, const FilmChoice& choice) {
  if (!choice.gives_temperatures()) return film;
  return std::make_unique<ScaledFilm>(std::move(film), choice.scale.value_or(1), choice.offset.value_or(0));
}

}  // namespace arenite::io

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "core/error.hpp"
#include "io/film_formats.hpp"
#include "io/film_notes.hpp"
#include "io/film_times.hpp"
#include "io/hdf5_attributes.hpp"
#include "io/hdf5_foreign.hpp"
#include "io/hdf5_numbers.hpp"
#include "io/own_process.hpp"
#include "io/plain_film.hpp"

namespace arenite::io {
namespace {

H5T_class_t class_of(hid_t set) {
  const auto type = own(H5Dget_type(set), H5Tclose);
  return type ? H5Tget_class(*type) : H5T_NO_CLASS;
}

bool can_be_film(hid_t set) { return shape_of(set).size() == 3 && (class_of(set) == H5T_INTEGER || class_of(set) == H5T_FLOAT); }

std::vector<std::string> films_in(hid_t file) { return datasets_in(file, can_be_film); }

/// Numbers of a chunk, which is read as a whole.
double most_in_chunk(const FilmChoice& choice) { return std::max(2.0 * static_cast<double>(choice.most_pixels), 1e6); }

PlainLayout layout_of(const Hdf5Sample& type) {
  PlainLayout layout;
  layout.sample = type.sample;
  layout.big_endian = type.big_endian;
  return layout;
}

/// One number a frame, in the group of the film.
std::vector<double> times_beside(hid_t file, const Bytes& bytes, const std::string& film, std::int64_t frames) {
  const std::string group = film.substr(0, film.rfind('/') == std::string::npos ? 0 : film.rfind('/') + 1);
  for (const char* name : {"time", "times", "timestamps"}) {
    const auto set = own(H5Dopen2(file, (group + name).c_str(), H5P_DEFAULT), H5Dclose);
    if (!set || shape_of(*set) != std::vector<std::int64_t>{frames} || frames > 100'000'000) continue;
    if (class_of(*set) != H5T_INTEGER && class_of(*set) != H5T_FLOAT) continue;
    Hdf5Numbers numbers(set, group + name, bytes, 1e8);
    std::string stored;
    numbers.read(0, static_cast<hsize_t>(frames), stored);
    std::vector<double> time(static_cast<std::size_t>(frames));
    take_numbers(layout_of(numbers.type()), stored.data(), time.size(), time.data());
    return time;
  }
  return {};
}

std::string chosen(hid_t file, const std::string& name, const FilmChoice& choice) {
  if (!choice.dataset.empty()) return choice.dataset;
  const auto found = films_in(file);
  if (found.size() == 1) return found.front();
  if (found.empty()) throw InputError(name, 0, "is an HDF5 file of another program and holds no dataset of numbers with three dimensions (frames x height x width); give a film");
  throw InputError(name, 0, fmt::format("holds {} datasets that can be films; choose one with --dataset: {}", found.size(), fmt::join(found, ", ")));
}

Hdf5Handle opened(const Bytes& bytes) {
  if (bytes->path() == nullptr) return open_foreign(bytes->text(0, bytes->size()), bytes->name());
  memory_properties();  // silences HDF5's own messages
  const auto access = made(H5Pcreate(H5P_FILE_ACCESS), H5Pclose);
  done(H5Pset_file_locking(*access, false, true));  // a film on a disk that only lets itself be read
  auto id = own(H5Fopen(bytes->path()->c_str(), H5F_ACC_RDONLY, *access), H5Fclose);
  if (!id) throw InputError(bytes->name(), 0, "is an HDF5 file that is cut short or damaged; copy it again");
  return id;
}

Hdf5Handle film_in(const Hdf5Handle& file, const Bytes& bytes, const std::string& name) {
  auto set = own(H5Dopen2(*file, name.c_str(), H5P_DEFAULT), H5Dclose);
  if (!set || !can_be_film(*set))
    throw InputError(bytes->name(), 0, fmt::format("has no dataset \"{}\" of frames x height x width; it has: {}", name, fmt::join(films_in(*file), ", ")));
  return set;
}

/// What the file says of its film.
struct Facts {
  std::string name, notes;
  std::vector<std::int64_t> shape;
  Sample sample = Sample::u16;
  bool big_endian = false;
  double frame_rate = 0, integration = 0;
  std::vector<double> time;
};
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Facts, name, notes, shape, sample, big_endian, frame_rate, integration, time)

Facts look(const Bytes& bytes, const FilmChoice& choice) {
  Facts facts;
  const auto file = opened(bytes);
  facts.name = chosen(*file, bytes->name(), choice);
  const auto set = film_in(file, bytes, facts.name);
  facts.shape = shape_of(*set);
  check_film_size(bytes->name(), facts.shape[2], facts.shape[1], facts.shape[0], choice);
  const Hdf5Numbers numbers(set, facts.name, bytes, most_in_chunk(choice));
  facts.sample = numbers.type().sample;
  facts.big_endian = numbers.type().big_endian;
  facts.notes = text_attribute(*set, "notes");
  for (const hid_t at : {static_cast<hid_t>(*set), static_cast<hid_t>(*file)}) {
    if (facts.frame_rate == 0) facts.frame_rate = number_attribute(at, {"frame_rate", "frame_rate_Hz", "fps"});
    if (facts.integration == 0) facts.integration = number_attribute(at, {"integration", "integration_s"});
  }
  if (!choice.frame_rate) facts.time = times_beside(*file, bytes, facts.name, facts.shape[0]);
  return facts;
}

/// HDF5 trusts what it reads: it is used in a process of its own, which a damaged file may bring down.
class Hdf5Film : public FilmSource {
 public:
  Hdf5Film(const Bytes& bytes, const FilmChoice& choice) : bytes_(bytes), most_(most_in_chunk(choice)) {
    prepare_hdf5();
    take(told([&] { return look(bytes, choice); }), choice);
    FrameBlock last;  // what is cut short lacks it
    read(info_.frames - 1, 1, last);
  }

  const FilmInfo& info() const override { return info_; }

  void read(std::int64_t first, std::size_t count, FrameBlock& block) override {
    prepare(info_, first, count, block);
    const std::size_t pixels = info_.pixels(), at_once = std::max<std::size_t>(1, most_at_once / (pixels * bytes_of(layout_.sample)));
    for (std::size_t n = 0; n < count; n += at_once) {
      const std::size_t part = std::min(at_once, count - n), size = part * pixels * bytes_of(layout_.sample);
      const std::string stored = in_own_process(bytes_->name(), [&] { return frames(static_cast<hsize_t>(first) + n, part); }, size, room());
      if (stored.size() != size) refuse();
      take_pixels(layout_, stored.data(), part * pixels, info_.floating ? nullptr : block.level.data() + n * pixels,
                  info_.floating ? block.value.data() + n * pixels : nullptr);
    }
  }

 private:
  static constexpr std::size_t most_at_once = std::size_t{32} << 20, most_told = std::size_t{2} << 30;  // bytes

  [[noreturn]] void refuse() const { throw InputError(bytes_->name(), 0, "is an HDF5 file that is cut short or damaged; copy it again"); }
  /// A file in memory is copied by HDF5.
  std::size_t room() const { return bytes_->path() != nullptr ? 0 : 3 * static_cast<std::size_t>(bytes_->size()); }

  template <class Work>
  Facts told(const Work& work) const {
    const auto packed = [&] {
      const auto bytes = nlohmann::json::to_cbor(nlohmann::json(work()));
      return std::string(bytes.begin(), bytes.end());
    };
    try {
      return nlohmann::json::from_cbor(in_own_process(bytes_->name(), packed, most_told, room())).template get<Facts>();
    } catch (const nlohmann::json::exception&) {
      refuse();
    }
  }

  void take(const Facts& facts, const FilmChoice& choice) {
    if (facts.shape.size() != 3 || bytes_of(facts.sample) == 0) refuse();
    check_film_size(bytes_->name(), facts.shape[2], facts.shape[1], facts.shape[0], choice);
    name_ = facts.name;
    layout_.sample = facts.sample;
    layout_.big_endian = facts.big_endian;
    info_.format = "hdf5";
    info_.frames = facts.shape[0];
    info_.height = static_cast<int>(facts.shape[1]);
    info_.width = static_cast<int>(facts.shape[2]);
    info_.floating = !is_level(facts.sample);
    if (!info_.floating) info_.bits = static_cast<int>(8 * bytes_of(facts.sample));
    take_notes(facts.notes, info_);
    if (info_.frame_rate == 0) info_.frame_rate = facts.frame_rate;
    if (info_.integration == 0) info_.integration = facts.integration;
    if (!choice.frame_rate) take_stamps(info_, facts.time);
    take_choice(info_, choice);
  }

  /// In the process of its own.
  std::string frames(hsize_t first, hsize_t count) const {
    const auto file = opened(bytes_);
    std::string stored;
    Hdf5Numbers(film_in(file, bytes_, name_), name_, bytes_, most_).read(first, count, stored);
    return stored;
  }

  Bytes bytes_;
  double most_;
  std::string name_;
  PlainLayout layout_;
  FilmInfo info_;
};

}  // namespace

FilmPointer open_hdf5_film(const Bytes& bytes, const FilmChoice& choice) { return std::make_unique<Hdf5Film>(bytes, choice); }

}  // namespace arenite::io

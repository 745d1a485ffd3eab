#include <algorithm>
#include <array>

#include "core/problems.hpp"
#include "io/film/formats.hpp"
#include "io/hdf5/foreign.hpp"

namespace arenite::io {
namespace {

bool holds_numbers(hid_t set) {
  const auto type = own(H5Dget_type(set), H5Tclose);
  return type && (H5Tget_class(*type) == H5T_INTEGER || H5Tget_class(*type) == H5T_FLOAT);
}

bool can_be_film(hid_t set) { return shape_of(set).size() == 3 && holds_numbers(set); }

[[noreturn]] void refuse_damaged(const Bytes& bytes) { refuse(bytes->name(), "is an HDF5 file that is cut short or damaged; copy it again"); }

/// Numbers of a chunk, which is read as a whole.
double most_in_chunk(const FilmChoice& choice) { return std::max(2.0 * static_cast<double>(choice.most_pixels), 1e6); }

/// One number a frame, in the group of the film.
std::vector<double> times_beside(hid_t file, const Bytes& bytes, const std::string& film, std::int64_t frames) {
  const std::string group = film.substr(0, film.rfind('/') == std::string::npos ? 0 : film.rfind('/') + 1);
  for (const char* name : {"time", "times", "timestamps"}) {
    const auto set = own(H5Dopen2(file, (group + name).c_str(), H5P_DEFAULT), H5Dclose);
    if (!set || shape_of(*set) != std::vector<std::int64_t>{frames} || frames > 100'000'000 || !holds_numbers(*set)) continue;
    Hdf5Numbers numbers(set, group + name, bytes, 1e8);
    std::string stored;
    numbers.read(0, static_cast<hsize_t>(frames), stored);
    std::vector<double> time(static_cast<std::size_t>(frames));
    each_number(numbers.number().type, numbers.number().big_endian, stored.data(), time.size(),
                [&](std::size_t i, auto v) { time[i] = static_cast<double>(v); });
    return time;
  }
  return {};
}

/// A film may lie on a disk that only lets itself be read; the one that is written is locked already.
Hdf5Handle without_lock() {
  memory_properties();  // silences HDF5's own messages
  auto access = made(H5Pcreate(H5P_FILE_ACCESS), H5Pclose);
  done(H5Pset_file_locking(*access, false, true));
  return access;
}

Hdf5Handle opened(const Bytes& bytes) {
  if (bytes->path() == nullptr) return open_in_memory(bytes->text(0, bytes->size()), bytes->name());
  auto id = own(H5Fopen(bytes->path()->c_str(), H5F_ACC_RDONLY, *without_lock()), H5Fclose);
  if (!id) refuse_damaged(bytes);
  return id;
}

FoundDataset film_in(const Hdf5Handle& file, const Bytes& bytes, const std::string& name) {
  return find_dataset(*file, bytes->name(), name, can_be_film, "numbers over frames x height x width");
}

/// What the file says of its film.
struct Facts {
  std::string name, notes;
  std::vector<std::int64_t> shape;
  NumberType pixel = NumberType::u16;
  bool big_endian = false;
  double frame_rate = 0, integration = 0;
  std::vector<double> time;
};

/// One list of members for both ways.
template <class Archive> void transfer(Archive& a, Facts& facts) {
  auto pixel = static_cast<std::uint8_t>(facts.pixel), big_endian = static_cast<std::uint8_t>(facts.big_endian);
  a(facts.name), a(facts.notes), a(facts.shape), a(pixel), a(big_endian), a(facts.frame_rate), a(facts.integration), a(facts.time);
  facts.pixel = static_cast<NumberType>(pixel);
  facts.big_endian = big_endian != 0;
}

Facts look(const Bytes& bytes, const FilmChoice& choice) {
  Facts facts;
  const auto file = opened(bytes);
  const auto [name, set] = film_in(file, bytes, choice.dataset);
  facts.name = name;
  facts.shape = shape_of(*set);
  check_film_size(bytes->name(), facts.shape[2], facts.shape[1], facts.shape[0], choice);
  const Hdf5Numbers numbers(set, facts.name, bytes, most_in_chunk(choice));
  facts.pixel = numbers.number().type;
  facts.big_endian = numbers.number().big_endian;
  facts.notes = text_attribute(*set, "notes");
  for (const hid_t at : {static_cast<hid_t>(*set), static_cast<hid_t>(*file)}) {
    if (facts.frame_rate == 0) facts.frame_rate = number_attribute(at, {"frame_rate", "frame_rate_Hz", "fps"});
    if (facts.integration == 0) facts.integration = number_attribute(at, {"integration", "integration_s"});
  }
  if (!choice.frame_rate) facts.time = times_beside(*file, bytes, facts.name, facts.shape[0]);
  return facts;
}

/// HDF5 trusts what it reads: it is used in a process of its own, which a damaged file may bring down.
class Hdf5Film : public KnownFilm {
 public:
  Hdf5Film(const Bytes& bytes, const FilmChoice& choice) : bytes_(bytes), most_(most_in_chunk(choice)) {
    prepare_hdf5();
    const auto facts = [&] { return look(bytes_, choice); };
    take(record_from_sandbox<Facts>(
             bytes_->name(), facts, [](auto& archive, Facts& f) { transfer(archive, f); }, most_told, room()),
         choice);
    FrameBlock last;  // what is cut short lacks it
    read(info_.frames - 1, 1, last);
  }

  void fill(std::int64_t first, std::size_t count, FrameBlock& block) override {
    const std::size_t pixels = info_.pixels(), at_once = std::max<std::size_t>(1, most_at_once / (pixels * bytes_of(layout_.pixel)));
    for (std::size_t n = 0; n < count; n += at_once) {
      const std::size_t part = std::min(at_once, count - n), size = part * pixels * bytes_of(layout_.pixel);
      const std::string stored = in_sandbox(
          bytes_->name(), [&] { return frames(static_cast<hsize_t>(first) + n, part); }, size, room());
      if (stored.size() != size) refuse_damaged(bytes_);
      take_pixels(layout_, stored.data(), part * pixels, block, n * pixels);
    }
  }

 private:
  static constexpr std::size_t most_at_once = std::size_t{32} << 20, most_told = std::size_t{2} << 30;  // bytes

  /// A file in memory is copied by HDF5.
  std::size_t room() const { return bytes_->path() != nullptr ? 0 : 3 * static_cast<std::size_t>(bytes_->size()); }

  void take(const Facts& facts, const FilmChoice& choice) {
    if (facts.shape.size() != 3 || bytes_of(facts.pixel) == 0) refuse_damaged(bytes_);
    name_ = facts.name;
    layout_.pixel = facts.pixel;
    layout_.big_endian = facts.big_endian;
    take_shape(info_, bytes_->name(), facts.shape, facts.pixel, choice);
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
    Hdf5Numbers(film_in(file, bytes_, name_).set, name_, bytes_, most_).read(first, count, stored);
    return stored;
  }

  Bytes bytes_;
  double most_;
  std::string name_;
  PlainLayout layout_;
};

class Hdf5FilmWriter : public FilmWriter {
 public:
  Hdf5FilmWriter(const std::filesystem::path& path, const FilmInfo& info) : file_(path), name_(path.string()), info_(info) {
    const Hdf5Turn turn;
    id_ = own(H5Fcreate(file_.beside().c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, *without_lock()), H5Fclose);
    if (!id_) refuse();
    // The dataset grows frame by frame; no times are stored, so that the same film gives the same bytes.
    constexpr std::size_t chunk_pixels = std::size_t{1} << 18;
    const hsize_t announced = info_.frames > 0 ? static_cast<hsize_t>(info_.frames) : H5S_UNLIMITED;
    const auto size = shape(0), most = shape(H5S_UNLIMITED), chunk = shape(std::clamp<hsize_t>(chunk_pixels / info_.pixels(), 1, announced));
    const auto space = made(H5Screate_simple(3, size.data(), most.data()), H5Sclose);
    const auto creation = timeless(H5P_DATASET_CREATE);
    done(H5Pset_chunk(*creation, 3, chunk.data()));
    set_ = own(H5Dcreate2(*id_, "frames", info_.floating ? H5T_IEEE_F32LE : H5T_STD_U16LE, *space, H5P_DEFAULT, *creation, H5P_DEFAULT), H5Dclose);
    if (!set_) refuse();
  }

  ~Hdf5FilmWriter() override {
    const Hdf5Turn turn;
    set_.reset();
    id_.reset();
  }
  Hdf5FilmWriter(const Hdf5FilmWriter&) = delete;
  Hdf5FilmWriter& operator=(const Hdf5FilmWriter&) = delete;

  void append(const FrameBlock& block) override {
    const std::string_view bytes = pixel_bytes(info_, block);
    if (block.frames == 0) return;
    const Hdf5Turn turn;
    const std::array<hsize_t, 3> start{frames_, 0, 0};
    const auto count = shape(block.frames), whole = shape(frames_ + block.frames);
    if (H5Dset_extent(*set_, whole.data()) < 0) refuse();
    const auto there = made(H5Dget_space(*set_), H5Sclose), here = made(H5Screate_simple(3, count.data(), nullptr), H5Sclose);
    done(H5Sselect_hyperslab(*there, H5S_SELECT_SET, start.data(), nullptr, count.data(), nullptr));
    if (H5Dwrite(*set_, info_.floating ? H5T_NATIVE_FLOAT : H5T_NATIVE_UINT16, *here, *there, H5P_DEFAULT, bytes.data()) < 0) refuse();
    frames_ += block.frames;
  }

  void finish() override {
    const Hdf5Turn turn;
    write_notes();
    set_.reset();
    if (H5Fflush(*id_, H5F_SCOPE_GLOBAL) < 0) refuse();
    id_.reset();
    file_.commit();
  }

 private:
  std::array<hsize_t, 3> shape(hsize_t frames) const { return {frames, static_cast<hsize_t>(info_.height), static_cast<hsize_t>(info_.width)}; }
  [[noreturn]] void refuse() const { arenite::refuse(name_, "cannot be written by HDF5; check that the disk has space"); }

  void write_notes() const {
    if (info_.frame_rate > 0) write_number(*set_, "frame_rate", info_.frame_rate);
    if (info_.integration > 0) write_number(*set_, "integration", info_.integration);
    if (const std::string notes = film_notes(info_); !notes.empty()) write_text(*set_, "notes", notes);
    if (info_.time.empty()) return;
    const hsize_t count = std::min<hsize_t>(frames_, info_.time.size());
    const auto space = made(H5Screate_simple(1, &count, nullptr), H5Sclose);
    const auto creation = timeless(H5P_DATASET_CREATE);
    const auto set = made(H5Dcreate2(*id_, "time", H5T_IEEE_F64LE, *space, H5P_DEFAULT, *creation, H5P_DEFAULT), H5Dclose);
    if (H5Dwrite(*set, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, info_.time.data()) < 0) refuse();
  }

  AtomicFile file_;
  std::string name_;
  FilmInfo info_;
  Hdf5Handle id_, set_;
  hsize_t frames_ = 0;
};

}  // namespace

/// HDF5: a dataset of frames x height x width, perhaps with times beside it and attributes.
const FilmFormat films::hdf5{
    .name = "hdf5",
    .sentence = "HDF5",
    .endings = {".h5", ".hdf5"},
    .marked = true,
    .has_datasets = true,
    .is = is_hdf5,
    .open = [](const Bytes& bytes, const FilmChoice& choice) -> FilmPointer { return std::make_unique<Hdf5Film>(bytes, choice); },
    .create = [](const auto& path, const FilmInfo& info) -> FilmWriterPointer { return std::make_unique<Hdf5FilmWriter>(path, info); }};

}  // namespace arenite::io

#include <algorithm>
#include <array>

#include "core/error.hpp"
#include "io/film_notes.hpp"
#include "io/film_writers.hpp"
#include "io/hdf5_handle.hpp"
#include "io/hdf5_turn.hpp"

namespace arenite::io {
namespace {

class Hdf5FilmWriter : public FilmWriter {
 public:
  Hdf5FilmWriter(const std::filesystem::path& path, const FilmInfo& info) : file_(path), name_(path.string()), info_(info) {
    const Hdf5Turn turn;
    memory_properties();  // silences HDF5's own messages
    const auto access = made(H5Pcreate(H5P_FILE_ACCESS), H5Pclose);
    done(H5Pset_file_locking(*access, false, true));  // the file beside is locked already
    const auto creation = made(H5Pcreate(H5P_FILE_CREATE), H5Pclose);
    id_ = own(H5Fcreate(file_.beside().c_str(), H5F_ACC_TRUNC, *creation, *access), H5Fclose);
    if (!id_) refuse();
    create_set();
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
    const std::array<hsize_t, 3> start{frames_, 0, 0}, count{block.frames, height(), width()}, whole{frames_ + block.frames, height(), width()};
    if (H5Dset_extent(*set_, whole.data()) < 0) refuse();
    const auto there = made(H5Dget_space(*set_), H5Sclose), here = made(H5Screate_simple(3, count.data(), nullptr), H5Sclose);
    done(H5Sselect_hyperslab(*there, H5S_SELECT_SET, start.data(), nullptr, count.data(), nullptr));
    if (H5Dwrite(*set_, info_.floating ? H5T_NATIVE_FLOAT : H5T_NATIVE_UINT16, *here, *there, H5P_DEFAULT, bytes.data()) < 0) refuse();
    frames_ += block.frames;
  }

  void finish() override {
    const Hdf5Turn turn;
    write_notes();
    write_times();
    set_.reset();
    if (H5Fflush(*id_, H5F_SCOPE_GLOBAL) < 0) refuse();
    id_.reset();
    file_.commit();
  }

 private:
  hsize_t width() const { return static_cast<hsize_t>(info_.width); }
  hsize_t height() const { return static_cast<hsize_t>(info_.height); }
  [[noreturn]] void refuse() const { throw InputError(name_, 0, "cannot be written by HDF5; check that the disk has space"); }

  /// Grows frame by frame; no times are stored, so that the same film gives the same bytes.
  void create_set() {
    constexpr std::size_t chunk_pixels = std::size_t{1} << 18;
    const hsize_t announced = info_.frames > 0 ? static_cast<hsize_t>(info_.frames) : H5S_UNLIMITED;
    const std::array<hsize_t, 3> size{0, height(), width()}, most{H5S_UNLIMITED, height(), width()},
        chunk{std::clamp<hsize_t>(chunk_pixels / info_.pixels(), 1, announced), height(), width()};
    const auto space = made(H5Screate_simple(3, size.data(), most.data()), H5Sclose);
    const auto creation = made(H5Pcreate(H5P_DATASET_CREATE), H5Pclose);
    done(H5Pset_chunk(*creation, 3, chunk.data()));
    done(H5Pset_obj_track_times(*creation, false));
    set_ = own(H5Dcreate2(*id_, "frames", info_.floating ? H5T_IEEE_F32LE : H5T_STD_U16LE, *space, H5P_DEFAULT, *creation, H5P_DEFAULT), H5Dclose);
    if (!set_) refuse();
  }

  void number(const char* name, double value) const {
    if (!(value > 0)) return;
    const auto space = made(H5Screate(H5S_SCALAR), H5Sclose);
    const auto attribute = made(H5Acreate2(*set_, name, H5T_IEEE_F64LE, *space, H5P_DEFAULT, H5P_DEFAULT), H5Aclose);
    done(H5Awrite(*attribute, H5T_NATIVE_DOUBLE, &value));
  }

  void write_notes() const {
    number("frame_rate", info_.frame_rate);
    number("integration", info_.integration);
    const std::string notes = film_notes(info_);
    if (notes.empty()) return;
    const auto space = made(H5Screate(H5S_SCALAR), H5Sclose), type = made(H5Tcopy(H5T_C_S1), H5Tclose);
    done(H5Tset_size(*type, notes.size()));
    const auto attribute = made(H5Acreate2(*set_, "notes", *type, *space, H5P_DEFAULT, H5P_DEFAULT), H5Aclose);
    done(H5Awrite(*attribute, *type, notes.data()));
  }

  void write_times() const {
    if (info_.time.empty()) return;
    const hsize_t count = std::min<hsize_t>(frames_, info_.time.size());
    const auto space = made(H5Screate_simple(1, &count, nullptr), H5Sclose);
    const auto creation = made(H5Pcreate(H5P_DATASET_CREATE), H5Pclose);
    done(H5Pset_obj_track_times(*creation, false));
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

FilmWriterPointer create_hdf5_film(const std::filesystem::path& path, const FilmInfo& info) { return std::make_unique<Hdf5FilmWriter>(path, info); }

}  // namespace arenite::io

#include "io/hdf5_numbers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>

#include "core/error.hpp"

namespace arenite::io {
namespace {

/// Deflate packs at most a thousandfold; a table that is larger was never written.
constexpr double most_packed = 1100;

}  // namespace

Hdf5Sample sample_of(hid_t type) {
  struct Row {
    hid_t type;
    Sample sample;
    bool big_endian, whole;
  };
  const Row known[] = {
      {H5T_STD_U8LE, Sample::u8, false, true},    {H5T_STD_U8BE, Sample::u8, false, true},    {H5T_STD_I8LE, Sample::i8, false, true},
      {H5T_STD_I8BE, Sample::i8, false, true},    {H5T_STD_U16LE, Sample::u16, false, true},  {H5T_STD_U16BE, Sample::u16, true, true},
      {H5T_STD_I16LE, Sample::i16, false, true},  {H5T_STD_I16BE, Sample::i16, true, true},   {H5T_STD_U32LE, Sample::u32, false, true},
      {H5T_STD_U32BE, Sample::u32, true, true},   {H5T_STD_I32LE, Sample::i32, false, true},  {H5T_STD_I32BE, Sample::i32, true, true},
      {H5T_STD_U64LE, Sample::u64, false, true},  {H5T_STD_U64BE, Sample::u64, true, true},   {H5T_STD_I64LE, Sample::i64, false, true},
      {H5T_STD_I64BE, Sample::i64, true, true},   {H5T_IEEE_F32LE, Sample::f32, false, false}, {H5T_IEEE_F32BE, Sample::f32, true, false},
      {H5T_IEEE_F64LE, Sample::f64, false, false}, {H5T_IEEE_F64BE, Sample::f64, true, false}};
  const auto base = H5Tget_class(type) == H5T_ENUM ? own(H5Tget_super(type), H5Tclose) : nullptr;
  for (const Row& row : known)
    if (H5Tequal(base ? *base : type, row.type) > 0) return {row.sample, row.big_endian, true, row.whole};
  return {};
}

Hdf5Numbers::Hdf5Numbers(Hdf5Handle set, const std::string& name, Bytes file, double most) : set_(std::move(set)), name_(name), file_(std::move(file)) {
  const auto space = own(H5Dget_space(*set_), H5Sclose), type = own(H5Dget_type(*set_), H5Tclose), creation = own(H5Dget_create_plist(*set_), H5Pclose);
  const int rank = space ? H5Sget_simple_extent_ndims(*space) : 0;
  if (rank < 1 || rank > 3 || !type || !creation) refuse("that is damaged; copy the file again");
  shape_.resize(static_cast<std::size_t>(rank));
  H5Sget_simple_extent_dims(*space, shape_.data(), nullptr);
  std::copy(shape_.begin(), shape_.end(), extent_.begin());
  type_ = sample_of(*type);
  if (!type_.known) refuse("whose numbers are of a kind that is not read; store integers of 1 to 8 bytes, float or double");
  fill_.assign(size_of_number(), '\0');
  double bytes = static_cast<double>(size_of_number());
  for (const hsize_t n : extent_) bytes *= static_cast<double>(n);
  if (bytes > most_packed * static_cast<double>(file_->size())) refuse("that announces more than a file of this size can hold; copy it again");
  layout_ = H5Pget_layout(*creation);
  if (H5Pget_external_count(*creation) > 0 || layout_ == H5D_VIRTUAL) refuse("whose numbers are in other files; copy them into one");
  if (layout_ == H5D_CHUNKED) look_at_chunks(*creation, most);
  else if (layout_ == H5D_COMPACT) read_compact();
  else if (bytes > 0) look_at_piece(bytes);
}

void Hdf5Numbers::look_at_piece(double bytes) {
  const haddr_t begin = H5Dget_offset(*set_);
  if (layout_ != H5D_CONTIGUOUS || begin == HADDR_UNDEF || begin > file_->size() || bytes > static_cast<double>(file_->size() - begin))
    refuse("that is cut short; copy the file again");
  begin_ = begin;
}

void Hdf5Numbers::refuse(const std::string& what) const { throw InputError(file_->name(), 0, fmt::format("holds a dataset \"{}\" {}", name_, what)); }

void Hdf5Numbers::read_compact() {
  compact_.resize(slab() * extent_[0]);
  const auto type = own(H5Dget_type(*set_), H5Tclose);
  if (compact_.size() > 65536 || H5Dget_storage_size(*set_) != compact_.size() || !type ||
      (!compact_.empty() && H5Dread(*set_, *type, H5S_ALL, H5S_ALL, H5P_DEFAULT, compact_.data()) < 0))
    refuse("that is damaged; copy the file again");
}

void Hdf5Numbers::look_at_chunks(hid_t creation, double most) {
  const auto rank = static_cast<int>(shape_.size());
  if (H5Pget_chunk(creation, rank, chunk_.data()) != rank) refuse("that is damaged; copy the file again");
  double numbers = 1;
  for (const hsize_t n : chunk_) numbers *= static_cast<double>(n);
  if (!(numbers > 0)) refuse("that is damaged; copy the file again");
  if (numbers > most) refuse(fmt::format("stored in chunks of {:.0f} numbers; store a few frames a chunk", numbers));
  chunk_bytes_ = static_cast<std::size_t>(numbers) * size_of_number();
  unsigned edges = 0;
  whole_at_edges_ = H5Pget_chunk_opts(creation, &edges) < 0 || (edges & H5D_CHUNK_DONT_FILTER_PARTIAL_CHUNKS) == 0;
  H5D_fill_value_t fill = H5D_FILL_VALUE_DEFAULT;
  const auto type = own(H5Dget_type(*set_), H5Tclose);
  if (H5Pfill_value_defined(creation, &fill) >= 0 && fill == H5D_FILL_VALUE_USER_DEFINED && type &&
      H5Pget_fill_value(creation, *type, fill_.data()) < 0)
    refuse("that is damaged; copy the file again");
  look_at_filters(creation);
}

void Hdf5Numbers::look_at_filters(hid_t creation) {
  const int count = H5Pget_nfilters(creation);
  for (int i = 0; i < count; ++i) {
    unsigned flags = 0, value[8] = {};
    std::size_t values = std::size(value);
    const H5Z_filter_t id = H5Pget_filter2(creation, static_cast<unsigned>(i), &flags, &values, value, 0, nullptr, nullptr);
    if (id == H5Z_FILTER_DEFLATE) filters_.push_back({Hdf5Filter::Kind::deflate, 1});
    else if (id == H5Z_FILTER_FLETCHER32) filters_.push_back({Hdf5Filter::Kind::checksum, 1});
    else if (id == H5Z_FILTER_SHUFFLE) filters_.push_back({Hdf5Filter::Kind::shuffle, size_of_number()});
    else refuse("packed in a way that is not read; pack it again with h5repack -f GZIP=4");
  }
}

void Hdf5Numbers::read(hsize_t first, hsize_t count, std::string& to) {
  if (first > extent_[0] || count > extent_[0] - first) refuse("that lacks what is asked for; copy the file again");
  to.resize(slab() * count);
  if (to.empty()) return;
  if (layout_ == H5D_CHUNKED) return read_chunks(first, count, to);
  if (layout_ == H5D_COMPACT) std::memcpy(to.data(), compact_.data() + slab() * first, to.size());
  else if (file_->read(begin_ + slab() * first, to.size(), to.data()) != to.size()) refuse("that became shorter; copy the file again");
}

void Hdf5Numbers::read_chunks(hsize_t first, hsize_t count, std::string& to) {
  Place at{};
  for (at[0] = first / chunk_[0] * chunk_[0]; at[0] < first + count; at[0] += chunk_[0])
    for (at[1] = 0; at[1] < extent_[1]; at[1] += chunk_[1])
      for (at[2] = 0; at[2] < extent_[2]; at[2] += chunk_[2]) copy_chunk(at, first, count, to);
}

const std::string& Hdf5Numbers::chunk_at(const Place& at) {
  if (held_ && held_at_ == at) return chunk_held_;
  held_ = false;
  hsize_t stored = 0;
  if (H5Dget_chunk_storage_size(*set_, at.data(), &stored) < 0) refuse("that is damaged; copy the file again");
  if (stored == 0) {  // never written
    chunk_held_.resize(chunk_bytes_);
    for (std::size_t i = 0; i < chunk_bytes_; i += fill_.size()) std::memcpy(chunk_held_.data() + i, fill_.data(), fill_.size());
  } else {
    std::string packed;
    std::uint32_t skipped = 0;
    if (stored <= chunk_bytes_ + chunk_bytes_ / 8 + 4096 && stored <= file_->size()) packed.resize(stored);
    if (packed.empty() || H5Dread_chunk(*set_, H5P_DEFAULT, at.data(), &skipped, packed.data()) < 0) refuse("that is cut short or damaged; copy the file again");
    bool inside = true;
    for (std::size_t axis = 0; axis < 3; ++axis) inside = inside && chunk_[axis] <= extent_[axis] - at[axis];
    auto plain = unpack_chunk(std::move(packed), inside || whole_at_edges_ ? filters_ : std::vector<Hdf5Filter>{}, skipped, chunk_bytes_);
    if (!plain) refuse("with a chunk that cannot be unpacked; copy the file again");
    chunk_held_ = std::move(*plain);
  }
  held_ = true;
  held_at_ = at;
  return chunk_held_;
}

void Hdf5Numbers::copy_chunk(const Place& at, hsize_t first, hsize_t count, std::string& to) {
  const std::string& chunk = chunk_at(at);
  const std::size_t number = size_of_number();
  const hsize_t begin = std::max(at[0], first), end = std::min(at[0] + chunk_[0], first + count);
  const hsize_t rows = std::min(chunk_[1], extent_[1] - at[1]), columns = std::min(chunk_[2], extent_[2] - at[2]);
  const bool rows_join = chunk_[2] == extent_[2], one_row = rows_join || rows == 1;
  for (hsize_t i = begin; i < end; ++i)
    for (hsize_t r = 0; r < (one_row ? 1 : rows); ++r) {
      const std::size_t from = ((i - at[0]) * chunk_[1] + r) * chunk_[2] * number;
      const std::size_t into = ((i - first) * extent_[1] + at[1] + r) * extent_[2] * number + at[2] * number;
      std::memcpy(to.data() + into, chunk.data() + from, (rows_join ? rows : 1) * columns * number);
    }
}

}  // namespace arenite::io

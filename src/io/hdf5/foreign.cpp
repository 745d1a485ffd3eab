#include "io/hdf5/foreign.hpp"

#include "core/option.hpp"
#include "core/problems.hpp"
#include "core/text.hpp"
#include "io/hdf5/dataset_search.hpp"

#include <fmt/core.h>
#include <zlib.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <limits>
#include <optional>
#include <utility>

namespace arenite::io {
namespace {

/// Deflate packs at most a thousandfold; a table that is larger was never written.
constexpr double most_packed = 1100;

/// A checksum behind the bytes may still follow.
constexpr std::size_t slack = 16;

bool inflate_to(std::string& bytes, std::size_t most) {
  std::string plain(most, '\0');
  if (bytes.size() > std::numeric_limits<uInt>::max() || most > std::numeric_limits<uInt>::max()) return false;
  uLongf length = most;
  const auto* from = reinterpret_cast<const Bytef*>(bytes.data());
  if (uncompress(reinterpret_cast<Bytef*>(plain.data()), &length, from, static_cast<uLong>(bytes.size())) != Z_OK)
    return false;
  plain.resize(length);
  bytes = std::move(plain);
  return true;
}

/// First bytes of all numbers come first, then their second bytes; what is no whole number is left at the end.
void unshuffle(std::string& bytes, std::size_t element) {
  const std::size_t count = bytes.size() / element;
  std::string plain = bytes;
  for (std::size_t b = 0; b < element; ++b)
    for (std::size_t i = 0; i < count; ++i) plain[i * element + b] = bytes[b * count + i];
  bytes = std::move(plain);
}

/// Fletcher's sums of 16-bit words, first byte high, in arithmetic modulo 65535 where 65535 stays as it is.
std::uint32_t fletcher(const std::string& bytes, std::size_t size) {
  const auto fold = [](std::uint32_t sum) { return (sum & 0xffff) + (sum >> 16); };
  std::uint32_t first = 0, second = 0;
  for (std::size_t i = 0; i < size; i += 2) {
    const std::uint32_t high = static_cast<std::uint8_t>(bytes[i]),
                        low = i + 1 < size ? static_cast<std::uint8_t>(bytes[i + 1]) : 0;
    first = fold(first + (high << 8 | low));
    second = fold(second + first);
  }
  return second << 16 | first;
}

bool take_checksum(std::string& bytes) {
  if (bytes.size() < 4) return false;
  const std::size_t size = bytes.size() - 4;
  if (number_at<std::uint32_t>(bytes, size) != fletcher(bytes, size)) return false;
  bytes.resize(size);
  return true;
}

}  // namespace

Hdf5Handle open_foreign(const Bytes& bytes) {
  if (bytes->path() == nullptr) return open_in_memory(bytes->text(0, bytes->size()), bytes->name());
  memory_properties();  // silences HDF5's own messages
  const auto access = made(H5Pcreate(H5P_FILE_ACCESS), H5Pclose);
  done(H5Pset_file_locking(*access, false, true));
  auto id = own(H5Fopen(bytes->path()->c_str(), H5F_ACC_RDONLY, *access), H5Fclose);
  if (!id) arenite::refuse(bytes->name(), "is an HDF5 file that is cut short or damaged; copy it again");
  return id;
}

bool holds_numbers(hid_t set) {
  const auto type = own(H5Dget_type(set), H5Tclose);
  return type && (H5Tget_class(*type) == H5T_INTEGER || H5Tget_class(*type) == H5T_FLOAT);
}

FoundDataset find_dataset(hid_t file, const std::string& file_name, const std::string& wanted, bool (*fits)(hid_t set),
                          const char* kind) {
  const auto open = [&](const std::string& name) { return own(H5Dopen2(file, name.c_str(), H5P_DEFAULT), H5Dclose); };
  if (auto set = wanted.empty() ? nullptr : open(wanted); set && fits(*set)) return {wanted, std::move(set)};
  const auto found = datasets_in(file, fits);
  if (!wanted.empty()) refuse(file_name, "has no dataset \"{}\" of {}; it has: {}", wanted, kind, list_of(found));
  if (found.empty())
    refuse(file_name, "is an HDF5 file of another program and holds no dataset of {}; give a file with one", kind);
  if (found.size() > 1)
    refuse(file_name, "holds {} possible datasets; choose one with {}: {}", found.size(), option("dataset"),
           list_of(found));
  return {found.front(), open(found.front())};
}

std::optional<std::string> unpack_chunk(std::string stored, const std::vector<Hdf5Filter>& filters, unsigned skipped,
                                        std::size_t size) {
  for (std::size_t i = filters.size(); i-- > 0;) {
    if (i < 32 && (skipped >> i & 1) != 0) continue;
    const Hdf5Filter& filter = filters[i];
    if (filter.kind == Hdf5Filter::Kind::shuffle) unshuffle(stored, filter.element);
    else if (!(filter.kind == Hdf5Filter::Kind::deflate ? inflate_to(stored, size + slack) : take_checksum(stored)))
      return std::nullopt;
  }
  if (stored.size() != size) return std::nullopt;
  return stored;
}

Hdf5Numbers::Hdf5Numbers(Hdf5Handle set, const std::string& name, Bytes file, double most)
    : set_(std::move(set)),
      name_(name),
      file_(std::move(file)) {
  const auto space = own(H5Dget_space(*set_), H5Sclose), type = own(H5Dget_type(*set_), H5Tclose),
             creation = own(H5Dget_create_plist(*set_), H5Pclose);
  const int rank = space ? H5Sget_simple_extent_ndims(*space) : 0;
  if (rank < 1 || rank > 3 || !type || !creation) refuse("that is damaged; copy the file again");
  shape_.resize(static_cast<std::size_t>(rank));
  H5Sget_simple_extent_dims(*space, shape_.data(), nullptr);
  std::copy(shape_.begin(), shape_.end(), extent_.begin());
  const auto number = number_of(*type);
  if (!number) refuse("whose numbers are of an unsupported type; store integers of 1 to 8 bytes, float or double");
  number_ = *number;
  fill_.assign(size_of_number(), '\0');
  double bytes = static_cast<double>(size_of_number());
  for (const hsize_t n : extent_) bytes *= static_cast<double>(n);
  if (bytes > most_packed * static_cast<double>(file_->size()))
    refuse("that declares more than a file of this size can hold; copy it again");
  layout_ = H5Pget_layout(*creation);
  if (H5Pget_external_count(*creation) > 0 || layout_ == H5D_VIRTUAL)
    refuse("whose numbers are in other files; copy them into one");
  if (layout_ == H5D_CHUNKED) look_at_chunks(*creation, most);
  else if (layout_ == H5D_COMPACT) read_compact();
  else if (bytes > 0) look_at_piece(bytes);
}

void Hdf5Numbers::look_at_piece(double bytes) {
  const haddr_t begin = H5Dget_offset(*set_);
  if (layout_ != H5D_CONTIGUOUS || begin == HADDR_UNDEF || begin > file_->size() ||
      bytes > static_cast<double>(file_->size() - begin))
    refuse("that is cut short; copy the file again");
  begin_ = begin;
}

void Hdf5Numbers::refuse(const std::string& what) const {
  arenite::refuse(file_->name(), "holds a dataset \"{}\" {}", name_, what);
}

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
  if (numbers > most) refuse(fmt::format("stored in chunks of {:.0f} numbers; store a few frames per chunk", numbers));
  chunk_bytes_ = static_cast<std::size_t>(numbers) * size_of_number();
  unsigned edges = 0;
  whole_at_edges_ = H5Pget_chunk_opts(creation, &edges) < 0 || (edges & H5D_CHUNK_DONT_FILTER_PARTIAL_CHUNKS) == 0;
  H5D_fill_value_t fill = H5D_FILL_VALUE_DEFAULT;
  const auto type = own(H5Dget_type(*set_), H5Tclose);
  if (H5Pfill_value_defined(creation, &fill) >= 0 && fill == H5D_FILL_VALUE_USER_DEFINED && type &&
      H5Pget_fill_value(creation, *type, fill_.data()) < 0)
    refuse("that is damaged; copy the file again");
  if (fill == H5D_FILL_VALUE_DEFAULT) take_no_number();
  look_at_filters(creation);
}

void Hdf5Numbers::take_no_number() {
  const auto store = [&](auto value) {
    if (number_.big_endian) value = swapped(value);
    std::memcpy(fill_.data(), &value, sizeof(value));
  };
  if (number_.type == NumberType::f32) store(std::numeric_limits<float>::quiet_NaN());
  if (number_.type == NumberType::f64) store(std::numeric_limits<double>::quiet_NaN());
}

void Hdf5Numbers::look_at_filters(hid_t creation) {
  const int count = H5Pget_nfilters(creation);
  for (int i = 0; i < count; ++i) {
    unsigned flags = 0, value[8] = {};
    std::size_t values = std::size(value);
    const H5Z_filter_t id =
        H5Pget_filter2(creation, static_cast<unsigned>(i), &flags, &values, value, 0, nullptr, nullptr);
    if (id == H5Z_FILTER_DEFLATE) filters_.push_back({Hdf5Filter::Kind::deflate, 1});
    else if (id == H5Z_FILTER_FLETCHER32) filters_.push_back({Hdf5Filter::Kind::checksum, 1});
    else if (id == H5Z_FILTER_SHUFFLE) filters_.push_back({Hdf5Filter::Kind::shuffle, size_of_number()});
    else refuse("compressed with a filter that is not supported; repack it with h5repack -f GZIP=4");
  }
}

void Hdf5Numbers::read(hsize_t first, hsize_t count, std::string& to) {
  if (first > extent_[0] || count > extent_[0] - first) refuse("that is shorter than expected; copy the file again");
  to.resize(slab() * count);
  if (to.empty()) return;
  if (layout_ == H5D_CHUNKED) return read_chunks(first, count, to);
  if (layout_ == H5D_COMPACT) std::memcpy(to.data(), compact_.data() + slab() * first, to.size());
  else if (file_->read(begin_ + slab() * first, to.size(), to.data()) != to.size())
    refuse("that became shorter; copy the file again");
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
  if (H5Dget_chunk_info_by_coord(*set_, at.data(), nullptr, nullptr, &stored) < 0)
    refuse("that is damaged; copy the file again");
  if (stored == 0) {  // never written
    chunk_held_.resize(chunk_bytes_);
    for (std::size_t i = 0; i < chunk_bytes_; i += fill_.size())
      std::memcpy(chunk_held_.data() + i, fill_.data(), fill_.size());
  } else {
    std::string packed;
    std::uint32_t skipped = 0;
    if (stored <= chunk_bytes_ + chunk_bytes_ / 8 + 4096 && stored <= file_->size()) packed.resize(stored);
    if (packed.empty() || H5Dread_chunk(*set_, H5P_DEFAULT, at.data(), &skipped, packed.data()) < 0)
      refuse("that is cut short or damaged; copy the file again");
    bool inside = true;
    for (std::size_t axis = 0; axis < 3; ++axis) inside = inside && chunk_[axis] <= extent_[axis] - at[axis];
    auto plain = unpack_chunk(std::move(packed), inside || whole_at_edges_ ? filters_ : std::vector<Hdf5Filter>{},
                              skipped, chunk_bytes_);
    if (!plain) refuse("with a chunk that cannot be decompressed; copy the file again");
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

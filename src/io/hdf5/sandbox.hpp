#pragma once
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "core/bytes.hpp"
#include "core/problems.hpp"
#include "io/hdf5/handle.hpp"

namespace arenite::io {

/// Bytes that `work` makes in a sandbox, a fork of this process that may use a gigabyte, twice `most` and `room` bytes
/// more and a minute of the processor: for libraries that a damaged file can bring down. InputErrors of `work` come
/// through as they are; where the process ends otherwise, or gives more than `most` bytes, one with `file` says that it
/// is damaged. `work` finds all that this process has, but what it changes is lost, and it must not start threads.
std::string in_sandbox(const std::string& file, const std::function<std::string()>& work, std::size_t most,
                       std::size_t room = 0);

/// The same of a record, whose members `transfer(archive, record)` names (core/bytes.hpp).
template <class Record, class Work, class Transfer>
Record record_from_sandbox(const std::string& file, Work work, Transfer transfer, std::size_t most, std::size_t room) {
  const auto packed = [&] {
    Record made = work();
    ByteWriter write;
    transfer(write, made);
    return std::string(write.bytes.begin(), write.bytes.end());
  };
  const std::string stored = in_sandbox(file, packed, most, room);
  const std::vector<std::uint8_t> bytes(stored.begin(), stored.end());
  Record made;
  try {
    ByteReader read(bytes);
    transfer(read, made);
    if (read.at_end()) return made;
  } catch (const InputError&) {}
  arenite::refuse(file, "is an HDF5 file that is cut short or damaged; copy it again");
}

}  // namespace arenite::io

#pragma once
#include <cstddef>
#include <functional>
#include <string>

namespace arenite::io {

/// Bytes that `work` makes in a process of its own, a fork of this one that may use a gigabyte, twice `most` and `room`
/// bytes more and a minute of the processor: for libraries that a damaged file can bring down. InputErrors of `work` come through as they
/// are; where the process ends otherwise, or gives more than `most` bytes, one with `file` says that it is damaged. `work`
/// finds all that this process has, but what it changes is lost, and it must not start threads.
std::string in_own_process(const std::string& file, const std::function<std::string()>& work, std::size_t most, std::size_t room = 0);

}  // namespace arenite::io

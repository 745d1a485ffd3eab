#include "io/checkpoint.hpp"

#include "io/sealed_file.hpp"
#include "io/stage_groups.hpp"

namespace arenite::io {

void write_checkpoint(const std::filesystem::path& path, const Checkpoint& checkpoint) {
  const Hdf5Writer root(false);
  root.set("key", checkpoint.key);
  const auto blobs = root.create_group("blobs");
  for (const auto& [name, bytes] : checkpoint.blobs) blobs.write(name, bytes);
  const auto numbers = root.create_group("numbers");
  for (const auto& [name, value] : checkpoint.numbers) numbers.set(name, value);
  const auto integers = root.create_group("integers");
  for (const auto& [name, value] : checkpoint.integers) integers.set(name, value);
  write_result(root.create_group("partial"), checkpoint.partial);
  write_sealed(path, "checkpoint", root.bytes());
}

std::optional<Checkpoint> read_checkpoint(const std::filesystem::path& path, const std::string& key) {
  if (!std::filesystem::exists(path)) return std::nullopt;
  const Hdf5Reader root(read_sealed(path, "checkpoint"), path.string());
  Checkpoint checkpoint;
  checkpoint.key = root.label("key");
  if (checkpoint.key != key) return std::nullopt;
  const auto blobs = root.group("blobs");
  for (const auto& name : blobs.names()) checkpoint.blobs[name] = blobs.bytes(name);
  const auto numbers = root.group("numbers");
  for (const auto& name : numbers.attribute_names()) checkpoint.numbers[name] = numbers.number(name);
  const auto integers = root.group("integers");
  for (const auto& name : integers.attribute_names()) checkpoint.integers[name] = integers.integer(name);
  checkpoint.partial = read_result(root.group("partial"));
  return checkpoint;
}

}  // namespace arenite::io

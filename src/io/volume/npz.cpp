#include <fmt/core.h>

#include <algorithm>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/option.hpp"
#include "core/problems.hpp"
#include "core/text.hpp"
#include "io/disk/numpy_header.hpp"
#include "io/volume/numpy_array.hpp"

namespace arenite::io {
namespace {

/// A member of a zip archive.
struct ZipMember {
  std::string name;
  std::uint64_t packed = 0, plain = 0, at = 0;
  int method = 0;
};

std::vector<ZipMember> members_of(const Bytes& bytes) {
  const std::string& file = bytes->name();
  constexpr std::size_t end_size = 22, longest_comment = 65535;
  const auto size = static_cast<std::size_t>(bytes->size());
  const std::size_t tail_at = size - std::min(size, end_size + longest_comment);
  const std::string tail = bytes->text(tail_at, size - tail_at);
  const std::size_t end = tail.rfind("PK\5\6");
  if (end == std::string::npos) refuse(file, "is a .npz file that is cut short; copy it again");
  const std::size_t count = number_at<std::uint16_t>(tail, end + 10);
  std::uint64_t at = number_at<std::uint32_t>(tail, end + 16);
  std::vector<ZipMember> members;
  for (std::size_t k = 0; k < count; ++k) {
    const std::string head = bytes->text(at, 46);
    if (!head.starts_with("PK\1\2")) refuse(file, "is a .npz file with a damaged list of arrays; copy it again");
    const std::size_t name = number_at<std::uint16_t>(head, 28);
    ZipMember member{bytes->text(at + 46, name), number_at<std::uint32_t>(head, 20), number_at<std::uint32_t>(head, 24),
                     number_at<std::uint32_t>(head, 42), number_at<std::uint16_t>(head, 10)};
    if (member.plain == 0xffffffffU || member.packed == 0xffffffffU || member.at == 0xffffffffU)
      refuse(file, "holds an array of more than 4 GB; save it with numpy.save");
    members.push_back(std::move(member));
    at += 46 + name + number_at<std::uint16_t>(head, 30) + number_at<std::uint16_t>(head, 32);
  }
  return members;
}

Bytes array_of(const Bytes& bytes, const ZipMember& member) {
  const std::string local = bytes->text(member.at, 30);
  if (!local.starts_with("PK\3\4")) refuse(bytes->name(), "has no array where its list says; copy it again");
  const std::uint64_t start =
      member.at + 30 + number_at<std::uint16_t>(local, 26) + number_at<std::uint16_t>(local, 28);
  std::string stored = bytes->text(start, static_cast<std::size_t>(member.packed));
  const std::string name = fmt::format("{}: {}", bytes->name(), member.name);
  constexpr int as_it_is = 0, deflated = 8;
  if (member.method == deflated) stored = unpacked(stored, static_cast<std::size_t>(member.plain), name, true);
  else if (member.method != as_it_is) refuse(name, "is packed in a way that NumPy does not use; save it again");
  return bytes_in_memory(std::move(stored), name);
}

VolumePointer open_npz(const Bytes& bytes, const VolumeChoice& choice) {
  std::vector<std::string> names, beside;
  std::vector<Bytes> volumes;
  for (const ZipMember& member : members_of(bytes)) {
    const std::string name = member.name.substr(0, member.name.rfind(".npy"));
    names.push_back(name);
    if (!choice.dataset.empty() && name != choice.dataset) continue;
    const Bytes array = array_of(bytes, member);
    if (!choice.dataset.empty() || numpy_header_in(array).shape.size() == 3) volumes.push_back(array);
    else beside.push_back(name);
  }
  if (volumes.empty() && choice.dataset.empty())
    refuse(bytes->name(), "has no array of three dimensions; its arrays: {}", list_of(names));
  if (volumes.size() != 1)
    refuse(bytes->name(), "has {} arrays of three dimensions{}; choose one by {}: {}", volumes.size(),
           choice.dataset.empty() ? "" : " of that name", option("dataset"), list_of(names));
  std::vector<std::string> remarks;
  if (!beside.empty())
    remarks.push_back(fmt::format("beside its volume it holds {}, which {} left aside", list_of(beside),
                                  beside.size() > 1 ? "are" : "is"));
  return open_numpy_array(volumes.front(), std::move(remarks));
}

}  // namespace

constinit const VolumeFormat volumes::npz{
    .name = "npz",
    .sentence = "NumPy (.npz)",
    .states = {{"arrays", "the one of three dimensions, or that of --dataset; as .npy"},
               {"arrays of other dimensions (a spacing, a side of voxels)", "left aside, and told: give --dx"}},
    .is = [](std::string_view head) { return head.starts_with("PK\3\4"); },
    .open = open_npz};

}  // namespace arenite::io

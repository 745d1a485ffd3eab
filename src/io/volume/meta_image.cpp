#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "core/option.hpp"
#include "core/problems.hpp"
#include "io/stated_units.hpp"
#include "io/volume/header.hpp"
#include "io/volume/volume.hpp"

namespace arenite::io {
namespace {

std::optional<NumberType> meta_type(const std::string& word) {
  using enum NumberType;
  static const std::map<std::string, NumberType> known = {
      {"MET_UCHAR", u8}, {"MET_CHAR", i8},        {"MET_USHORT", u16},    {"MET_SHORT", i16}, {"MET_UINT", u32},
      {"MET_INT", i32},  {"MET_ULONG_LONG", u64}, {"MET_LONG_LONG", i64}, {"MET_FLOAT", f32}, {"MET_DOUBLE", f64}};
  const auto found = known.find(word);
  return found == known.end() ? std::nullopt : std::optional(found->second);
}

VolumePointer open_meta_image(const Bytes& bytes, const VolumeChoice& choice) {
  const std::string& file = bytes->name();
  const TextHeader header = header_until_key(bytes, '=', "elementdatafile");
  const auto says = [&](const char* key) {
    return header.has(key) && (header.word(key) == "True" || header.word(key) == "true");
  };
  if (header.whole_numbers("ndims", 1)[0] != 3)
    refuse(file, "has {} dimensions; save a volume of three", header.word("ndims"));
  if (header.has("binarydata") && !says("binarydata"))
    refuse(file, "has its numbers as text (BinaryData = {}); save it with BinaryData = True",
           header.word("binarydata"));
  if (header.has("elementnumberofchannels") && header.whole_numbers("elementnumberofchannels", 1)[0] != 1)
    refuse(file, "has {} channels; save one", header.word("elementnumberofchannels"));
  const auto type = meta_type(header.word("elementtype"));
  if (!type) refuse(file, "has voxels of type {}; save whole numbers of up to 64 bits", header.word("elementtype"));
  const auto size = header.whole_numbers("dimsize", 3);
  VolumeFacts facts = sized({size[0], size[1], size[2]}, file);
  // ElementSize, which may be thicker than the way to the next slice, counts where nothing else is stated.
  const std::string sides = header.has("elementspacing") ? "elementspacing" : "elementsize";
  if (header.has(sides)) {
    const auto spacing = header.numbers(sides, 3);
    const std::string stated = header.has("distanceunits") ? header.word("distanceunits") : "";
    const bool is_known = in_metres(1, stated).has_value();
    take_side(facts, side_of({spacing[0], spacing[1], spacing[2]}, file), is_known ? stated : "mm", choice.dx_given);
    if (!choice.dx_given && !is_known)
      facts.remarks.push_back("its spacing is taken in mm, as ITK does; give " + option("dx") + " where it is not");
  }
  for (const char* key : {"transformmatrix", "rotation", "orientation"})
    if (header.has(key)) {
      const auto m = header.numbers(key, 9);
      tell_turned(facts, {Vec3{m[0], m[1], m[2]}, {m[3], m[4], m[5]}, {m[6], m[7], m[8]}},
                  "the rows of its TransformMatrix", file);
      break;
    }
  for (const char* key : {"offset", "origin", "position"})
    if (header.has(key)) {
      const auto place = header.numbers(key, 3);
      tell_origin(facts, {place[0], place[1], place[2]}, "its Offset");
      break;
    }
  const VoxelLayout layout{.type = *type, .big_endian = says("binarydatabyteordermsb") || says("elementbyteordermsb")};
  const std::string& beside = header.word("elementdatafile");
  if (beside == "LIST" || beside.find('%') != std::string::npos)
    refuse(file, "has a file of its own for each slice; give the folder of the slices, or save it as one file");
  const bool local = beside == "LOCAL" || beside == "local";
  facts.elsewhere = !local;
  const std::int64_t skip = header.has("headersize") ? header.whole_numbers("headersize", 1)[0] : 0;
  return header_and_numbers(local ? bytes : opened_beside(bytes, beside), local ? header.size : 0,
                            says("compresseddata"), skip, facts, layout);
}

}  // namespace

constinit const VolumeFormat volumes::meta_image{
    .name = "meta_image",
    .sentence = "MetaImage (.mhd, .mha)",
    .states = {{"DimSize", "used: x fastest, z slowest"},
               {"ElementSpacing, without it ElementSize",
                "used with the unit of DistanceUnits, without one in mm, and told; refused where voxels are no cubes; "
                "told where --dx is given and differs"},
               {"ElementDataFile", "read beside the header; a file for each slice is refused"},
               {"CompressedData, byte order, HeaderSize", "used"},
               {"BinaryData = False", "refused"},
               {"Offset (Origin, Position)",
                "left aside, and told where it is not 0: places are counted from the corner of the first voxel"},
               {"TransformMatrix (Rotation, Orientation)", "left aside, and told where it turns or mirrors the axes"},
               {"more numbers than DimSize says", "left aside, and told"}},
    .is =
        [](std::string_view head) {
          return head.starts_with("ObjectType") || head.starts_with("NDims") || head.starts_with("Comment = ");
        },
    .open = open_meta_image};

}  // namespace arenite::io

#include "io/volume/voxel_map.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cstdint>
#include <functional>
#include <map>
#include <unordered_map>

#include "core/mapped.hpp"
#include "core/option.hpp"
#include "core/problems.hpp"
#include "core/text.hpp"
#include "io/image/pixel_size.hpp"

namespace arenite::io {
namespace {

/// visit(z, layer) for every layer.
void each_layer(VolumeSource& volume, const std::function<void(int, const std::vector<std::int32_t>&)>& visit) {
  std::vector<std::int32_t> layer(volume.facts().slice());
  for (int z = 0; z < volume.facts().depth; ++z) {
    volume.read(z, layer);
    visit(z, layer);
  }
}

/// Of a volume of two values.
PhaseTable guessed_phases(VolumeSource& volume, const std::string& file, std::vector<std::string>& notes) {
  std::map<std::int32_t, std::size_t> found;
  constexpr std::size_t most = 12;
  each_layer(volume, [&](int, const std::vector<std::int32_t>& layer) {
    for (const std::int32_t value : layer)
      if (found.size() <= most) ++found[value];
  });
  if (found.size() == 1)
    refuse(file, "has the value {0} everywhere; say which phase it is, for example {1} \"{0}=particle\"",
           found.begin()->first, option("phases"));
  if (found.size() != 2) {
    std::vector<std::string> words;
    for (const auto& [value, count] : found) words.push_back(fmt::format("{}", value));
    refuse(file, "has {} values ({}{}); say which phase each is, for example {} \"0=void,1=matrix,2=particle\"",
           found.size() > most ? "more than 12" : fmt::format("{}", found.size()), list_of(words),
           found.size() > most ? ", .." : "", option("phases"));
  }
  const std::int32_t low = found.begin()->first, high = found.rbegin()->first;
  notes.push_back(
      fmt::format("{} is taken as void and {} as particle; say otherwise by {}", low, high, option("phases")));
  return {{low, Phase::empty}, {high, Phase::particle}};
}

void take_labels(const VoxelMapOptions& options, ForeignVoxels& read) {
  VolumeChoice choice = options.label_volume;
  choice.dx_given = true;  // it is that of the phases
  const auto labels = open_volume(*options.labels, choice);
  const std::string file = options.labels->string();
  VoxelMap& map = read.map;
  const VolumeFacts& facts = labels->facts();
  if (facts.width != map.width || facts.height != map.height || facts.depth != map.depth)
    refuse(file, "labels {} x {} x {} voxels, and the phases are {} x {} x {}", facts.width, facts.height, facts.depth,
           map.width, map.height, map.depth);
  std::unordered_map<std::int32_t, std::int32_t> number;
  each_layer(*labels, [&](int z, const std::vector<std::int32_t>& layer) {
    std::size_t k = map.index(0, 0, z);
    for (const std::int32_t label : layer) {
      const bool particle = map.phase[k] == Phase::particle;
      if (particle != (label != 0)) {
        const auto at = k - map.index(0, 0, z);
        refuse(file, "{} the voxel ({}, {}, {}), which is {}; labels and phases must be of the same sample",
               particle ? "has no label for" : "labels", at % static_cast<std::size_t>(map.width),
               at / static_cast<std::size_t>(map.width), z, name_of(map.phase[k]));
      }
      if (particle) map.grain[k] = number.try_emplace(label, static_cast<std::int32_t>(number.size())).first->second;
      ++k;
    }
  });
  map.grain_class.assign(number.size(), GrainClass::none);
  read.labelled = true;
}

}  // namespace

ForeignVoxels read_voxel_map(const std::filesystem::path& path, const VoxelMapOptions& options) {
  VolumeChoice choice = options.volume;
  choice.dx_given = options.dx.has_value();
  const auto volume = open_volume(path, choice);
  const VolumeFacts& facts = volume->facts();
  const std::string file = path.string();
  ForeignVoxels read;
  read.notes = facts.remarks;
  if (options.dx && facts.dx) {
    const std::string told = told_other_side("voxel", *facts.dx, *options.dx);
    if (!told.empty()) read.notes.push_back(told);
  }
  const std::optional<double> dx = options.dx ? options.dx : facts.dx;
  read.map = make_voxel_map(facts.width, facts.height, facts.depth, dx.value_or(1));
  read.map.has_length = dx.has_value();
  const PhaseTable table = options.phases.empty() ? guessed_phases(*volume, file, read.notes) : options.phases;
  each_layer(*volume, [&](int z, const std::vector<std::int32_t>& layer) {
    Phase* phase = &read.map.phase[read.map.index(0, 0, z)];
    std::int32_t last = 0;
    auto known = table.end();
    for (const std::int32_t value : layer) {
      if (known == table.end() || value != last) {
        known = table.find(value);
        last = value;
        if (known == table.end())
          refuse(file, "has the value {} in layer {}, for which {} names no phase", value, z, option("phases"));
      }
      *phase++ = known->second;
    }
  });
  if (options.labels) take_labels(options, read);
  return read;
}

}  // namespace arenite::io

#pragma once
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "io/image/image.hpp"
#include "model/phase_map.hpp"

namespace arenite::io {

/// Which phase a value of a picture is.
using PhaseTable = std::map<std::int32_t, Phase>;

/// "0=void,85=particle,170=matrix". Throws InputError for another form, an unknown name, a value given twice.
PhaseTable parse_phase_table(std::string_view text);

/// "void", "matrix" or "particle".
std::string_view name_of(Phase phase);

/// Phase of every pixel, in the picture's order. Without a table (an empty one) a picture of exactly two values is
/// guessed: the lower is void, the higher particle, and `notes` says so. Every other picture without a table, a value
/// that the table lacks, and a picture of one phase only (unless it is particle and `several_grains`) is an InputError
/// that lists the values with their shares.
std::vector<Phase> assign_phases(const Image& image, const PhaseTable& table, bool several_grains,
                                 const std::string& file, std::vector<std::string>& notes);

/// A rectangle of a picture: its upper left pixel, as picture viewers count, and its size.
struct Crop {
  int x = 0, y = 0, width = 0, height = 0;
};

/// "X,Y,WIDTH,HEIGHT" in pixels. Throws InputError for anything else.
Crop parse_crop(std::string_view text);

/// How a picture is a phase map.
struct PhaseMapOptions {
  ImageChoice image;
  PhaseTable phases;                            ///< empty: guessed (assign_phases)
  std::optional<Crop> crop;                     ///< of the picture and of the labels
  double dx = 1;                                ///< side of a pixel, m
  std::optional<std::filesystem::path> labels;  ///< picture whose values number the grains, 0 where there is none
  ImageChoice label_image;                      ///< in it; a dataset without `labels` lies in the map's own file
};

/// A phase map from a picture. Picture rows point down; row 0 of the map is the bottom.
struct ForeignMap {
  PhaseMap map;  ///< without labels: `grain` is -1 everywhere and `grain_class` empty, to be labelled
  bool labelled = false;
  std::vector<std::string> notes;
};

/// Reads a phase map and, if there are any, its labels. Grains are numbered in the order of their first node. Throws
/// InputError for what read_image and assign_phases refuse, a crop outside the picture, labels of another size, labels
/// where no particle is, particles without label, labels given to a map without particles.
ForeignMap read_phase_map(const std::filesystem::path& path, const PhaseMapOptions& options);

/// The same from pictures; `labels` may be null. Names are for messages.
ForeignMap make_phase_map(const Image& picture, const Image* labels, const PhaseMapOptions& options,
                          const std::string& file, const std::string& label_file);

/// One label for all particles of a map.
void label_alike(PhaseMap& map);

}  // namespace arenite::io

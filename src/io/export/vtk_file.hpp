#pragma once
#include <fmt/core.h>

#include <cstdint>
#include <functional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "core/vec.hpp"

namespace arenite::io {

/// One array of a VTK file: a value of `components` numbers for every point or cell.
struct VtkArray {
  std::string name;
  std::variant<std::vector<double>, std::vector<float>, std::vector<std::int32_t>, std::vector<std::int64_t>,
               std::vector<std::uint8_t>>
      values;
  int components = 1;
};

/// Vectors of the plane as VTK wants them: three components, the last 0.
std::vector<double> in_space(const std::vector<Vec2>& plane);
/// Components of vectors one after another.
std::vector<double> in_space(const std::vector<Vec3>& vectors);
/// Symmetric tensors of the plane in VTK's order: xx, yy, zz, xy, yz, xz.
std::vector<double> symmetric(const std::vector<double>& xx, const std::vector<double>& yy,
                              const std::vector<double>& xy);

/// Points with one vertex each, straight lines between pairs of them, or flat polygons: all that grains, contacts and
/// walls need.
struct VtkPolyData {
  bool lines = false;                 ///< a line per two successive points; else a vertex per point
  std::vector<std::int64_t> corners;  ///< of polygons, of which each has so many successive points
  std::vector<double> points;         ///< x, y, z of each, m
  std::vector<VtkArray> point_arrays, cell_arrays;
  double time = 0;  ///< s; stored as TimeValue
};

/// The bytes of a .vtp file (VTK XML PolyData, appended raw data, zlib), as ParaView and VTK >= 6 read them.
std::string vtp_bytes(const VtkPolyData& data);

/// Values at the nodes of a lattice, row after row and layer after layer; the first node lies half a spacing from the
/// corner.
struct VtkImage {
  int width = 0, height = 0;
  double dx = 1;  ///< m
  std::vector<VtkArray> point_arrays;
  double dy = dx;                         ///< m
  double left = 0, bottom = 0;            ///< corner, m
  int depth = 1;                          ///< layers; the one of a plane lies at 0
  std::string provenance = {};            ///< a comment of the file
  double dz = dx;                         ///< m
  double back = depth > 1 ? 0 : -dz / 2;  ///< corner, m
};

/// The bytes of a .vti file (VTK XML ImageData, appended raw data, zlib).
std::string vti_bytes(const VtkImage& image);

/// The bytes of a .pvd file: which files belong together at which time (s), by their numbers.
std::string pvd_bytes(const std::vector<double>& times, const std::function<std::string(int number)>& file);

/// The bytes of a .vtm file: blocks by name, each a file beside it.
std::string vtm_bytes(const std::vector<std::pair<std::string, std::string>>& blocks);

/// Names of the file of something in a state, and of the one that opens all of a state.
inline std::string vtk_name(const char* what, int number) { return fmt::format("{}_{:04}.vtp", what, number); }
inline std::string vtk_state_name(int number) { return fmt::format("state_{:04}.vtm", number); }

}  // namespace arenite::io

#include "io/export/vtk_file.hpp"

#include <fmt/core.h>
#include <zlib.h>

#include <algorithm>
#include <iterator>
#include <numeric>
#include <stdexcept>

#include "io/disk/byte_source.hpp"

namespace arenite::io {
namespace {

/// VTK's compressed block: number of blocks, size of a block, size of the last one if it is shorter, compressed sizes,
/// then the blocks.
std::string compressed(const char* data, std::size_t size) {
  constexpr std::size_t block = 1 << 16;
  const std::size_t blocks = (size + block - 1) / block;
  std::string header, body;
  append<std::uint64_t>(header, blocks);
  append<std::uint64_t>(header, block);
  append<std::uint64_t>(header, size % block);
  for (std::size_t b = 0; b < blocks; ++b) {
    const std::size_t length = std::min(block, size - b * block);
    uLongf packed = compressBound(length);
    const std::size_t start = body.size();
    body.resize(start + packed);
    if (compress2(reinterpret_cast<Bytef*>(body.data() + start), &packed,
                  reinterpret_cast<const Bytef*>(data + b * block), length, 6) != Z_OK)
      throw std::runtime_error("zlib could not compress an array");
    body.resize(start + packed);
    append<std::uint64_t>(header, packed);
  }
  return header + body;
}

template <class T> constexpr const char* vtk_type = nullptr;
template <> constexpr const char* vtk_type<double> = "Float64";
template <> constexpr const char* vtk_type<float> = "Float32";
template <> constexpr const char* vtk_type<std::int32_t> = "Int32";
template <> constexpr const char* vtk_type<std::int64_t> = "Int64";
template <> constexpr const char* vtk_type<std::uint8_t> = "UInt8";

std::string escaped(const std::string& text) {
  std::string out;
  for (const char c : text) {
    if (c == '&') out += "&amp;";
    else if (c == '<') out += "&lt;";
    else if (c == '>') out += "&gt;";
    else if (c == '"') out += "&quot;";
    else out += c;
  }
  return out;
}

/// The file in two parts that grow together: the XML and the data that it points into.
class VtkWriter {
 public:
  explicit VtkWriter(const char* type) {
    line("<?xml version=\"1.0\"?>");
    line(
        "<VTKFile type=\"{}\" version=\"1.0\" byte_order=\"LittleEndian\" header_type=\"UInt64\" "
        "compressor=\"vtkZLibDataCompressor\">",
        type);
  }

  template <class... Arguments> void line(fmt::format_string<Arguments...> format, Arguments&&... arguments) {
    fmt::format_to(std::back_inserter(xml_), format, std::forward<Arguments>(arguments)...);
    xml_ += '\n';
  }

  template <class T> void array(const std::string& name, int components, const std::vector<T>& values) {
    line("<DataArray type=\"{}\" Name=\"{}\" NumberOfComponents=\"{}\" format=\"appended\" offset=\"{}\"/>",
         vtk_type<T>, escaped(name), components, data_.size());
    data_ += compressed(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T));
  }

  void arrays(const char* element, const std::vector<VtkArray>& list) {
    line("<{}>", element);
    for (const auto& a : list) std::visit([&](const auto& values) { array(a.name, a.components, values); }, a.values);
    line("</{}>", element);
  }

  /// A list of cells of so many successive points each; an empty one is written too, since VTK's reader asks for all
  /// four.
  void cells(const char* element, const std::vector<std::int64_t>& sizes) {
    std::vector<std::int64_t> offsets(sizes.size());
    std::partial_sum(sizes.begin(), sizes.end(), offsets.begin());
    std::vector<std::int64_t> connectivity(offsets.empty() ? 0 : static_cast<std::size_t>(offsets.back()));
    std::iota(connectivity.begin(), connectivity.end(), std::int64_t{0});
    line("<{}>", element);
    array("connectivity", 1, connectivity);
    array("offsets", 1, offsets);
    line("</{}>", element);
  }

  std::string finish() {
    line("<AppendedData encoding=\"raw\">");
    xml_ += '_' + data_;
    line("\n</AppendedData>\n</VTKFile>");
    return std::move(xml_);
  }

 private:
  std::string xml_, data_;
};

}  // namespace

std::vector<double> in_space(const std::vector<Vec2>& plane) {
  std::vector<double> vectors;
  vectors.reserve(3 * plane.size());
  for (const Vec2& v : plane) vectors.insert(vectors.end(), {v.x, v.y, 0});
  return vectors;
}

std::vector<double> in_space(const std::vector<Vec3>& vectors) {
  std::vector<double> components;
  components.reserve(3 * vectors.size());
  for (const Vec3& v : vectors) components.insert(components.end(), {v.x, v.y, v.z});
  return components;
}

std::vector<double> symmetric(const std::vector<double>& xx, const std::vector<double>& yy,
                              const std::vector<double>& xy) {
  std::vector<double> tensors;
  for (std::size_t k = 0; k < xx.size(); ++k) tensors.insert(tensors.end(), {xx[k], yy[k], 0, xy[k], 0, 0});
  return tensors;
}

std::string vtp_bytes(const VtkPolyData& data) {
  const std::size_t points = data.points.size() / 3;
  const bool in_polygons = !data.corners.empty(), in_lines = data.lines && !in_polygons;
  const std::vector<std::int64_t> none, vertices(in_polygons || in_lines ? 0 : points, 1),
      lines(in_lines ? points / 2 : 0, 2);
  VtkWriter file("PolyData");
  file.line("<PolyData>");
  file.line(
      "<FieldData>\n<DataArray type=\"Float64\" Name=\"TimeValue\" NumberOfTuples=\"1\" "
      "format=\"ascii\">{}</DataArray>\n</FieldData>",
      data.time);
  file.line(
      "<Piece NumberOfPoints=\"{}\" NumberOfVerts=\"{}\" NumberOfLines=\"{}\" NumberOfStrips=\"0\" "
      "NumberOfPolys=\"{}\">",
      points, vertices.size(), lines.size(), data.corners.size());
  file.arrays("PointData", data.point_arrays);
  file.arrays("CellData", data.cell_arrays);
  file.line("<Points>");
  file.array("Points", 3, data.points);
  file.line("</Points>");
  file.cells("Verts", vertices);
  file.cells("Lines", lines);
  file.cells("Strips", none);
  file.cells("Polys", data.corners);
  file.line("</Piece>\n</PolyData>");
  return file.finish();
}

std::string vti_bytes(const VtkImage& image) {
  const std::string extent = fmt::format("0 {} 0 {} 0 {}", image.width - 1, image.height - 1, image.depth - 1);
  VtkWriter file("ImageData");
  if (!image.provenance.empty()) file.line("<!-- {} -->", escaped(image.provenance));
  file.line("<ImageData WholeExtent=\"{}\" Origin=\"{} {} {}\" Spacing=\"{} {} {}\">", extent,
            image.left + image.dx / 2, image.bottom + image.dy / 2, image.back + image.dz / 2, image.dx, image.dy,
            image.dz);
  file.line("<Piece Extent=\"{}\">", extent);
  file.arrays("PointData", image.point_arrays);
  file.line("</Piece>\n</ImageData>");
  return file.finish();
}

std::string vtm_bytes(const std::vector<std::pair<std::string, std::string>>& blocks) {
  std::string text =
      "<?xml version=\"1.0\"?>\n<VTKFile type=\"vtkMultiBlockDataSet\" version=\"1.0\" "
      "byte_order=\"LittleEndian\">\n<vtkMultiBlockDataSet>\n";
  for (std::size_t b = 0; b < blocks.size(); ++b)
    text += fmt::format("<DataSet index=\"{}\" name=\"{}\" file=\"{}\"/>\n", b, escaped(blocks[b].first),
                        escaped(blocks[b].second));
  return text + "</vtkMultiBlockDataSet>\n</VTKFile>\n";
}

std::string pvd_bytes(const std::vector<double>& times, const std::function<std::string(int number)>& file) {
  std::string text =
      "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"0.1\" "
      "byte_order=\"LittleEndian\">\n<Collection>\n";
  for (std::size_t k = 0; k < times.size(); ++k)
    text += fmt::format("<DataSet timestep=\"{}\" part=\"0\" file=\"{}\"/>\n", times[k],
                        escaped(file(static_cast<int>(k))));
  return text + "</Collection>\n</VTKFile>\n";
}

}  // namespace arenite::io

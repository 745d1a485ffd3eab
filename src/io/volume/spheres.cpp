#include "io/volume/spheres.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <numeric>
#include <optional>
#include <string_view>
#include <utility>

#include "core/problems.hpp"
#include "io/disk/file.hpp"
#include "io/table/laboratory_table.hpp"
#include "io/table/table.hpp"

namespace arenite::io {
namespace {

constexpr std::string_view lbpm_begins = "Number of Spheres:";

bool is_lbpm(const std::filesystem::path& path) {
  std::ifstream file(path);
  std::string line;
  return std::getline(file, line) && line.starts_with(lbpm_begins);
}

/// Numbers of a line behind its colon, or of all of it, apart by blanks or commas.
std::vector<double> numbers_in(std::string_view line, const std::string& file, int at) {
  if (const auto colon = line.find(':'); colon != line.npos) line.remove_prefix(colon + 1);
  std::vector<double> numbers;
  Problems problems(file);
  for (std::size_t k = 0; k < line.size();) {
    const std::size_t begin = line.find_first_not_of(" ,\t\r", k);
    if (begin == line.npos) break;
    const std::size_t end = std::min(line.find_first_of(" ,\t\r", begin), line.size());
    numbers.push_back(number_or_problem(line.substr(begin, end - begin), "a number", 1, at, problems));
    k = end;
  }
  problems.raise();
  return numbers;
}

SpherePack read_lbpm(const std::string& file, std::vector<std::string>& notes) {
  const std::string text = read_file(file);
  Lines lines(text);
  SpherePack pack;
  pack.periodic = true;
  std::optional<std::size_t> stated;
  for (std::string_view line; lines.next(line);) {
    if (line.starts_with(lbpm_begins)) {
      const auto count = numbers_in(line, file, lines.number());
      if (count.size() == 1) stated = static_cast<std::size_t>(count[0]);
      continue;
    }
    if (line.starts_with("Domain Length")) {
      const auto side = numbers_in(line.substr(line.find(':')), file, lines.number());
      if (side.size() != 3) throw InputError(file, lines.number(), "a domain has three lengths");
      pack.high = {side[0], side[1], side[2]};
      continue;
    }
    if (line.find_first_not_of(" \t\r") == line.npos || !to_number(line.substr(0, line.find_first_of(" \t")))) continue;
    const auto row = numbers_in(line, file, lines.number());
    if (row.size() != 4 || !(row[3] > 0))
      throw InputError(file, lines.number(), "a sphere is its centre x, y, z and a radius above 0");
    pack.centre.push_back({row[0], row[1], row[2]});
    pack.radius.push_back(row[3]);
  }
  if (stated && *stated != pack.size())
    throw InputError(file, 1, fmt::format("says {} spheres and holds {}; it is not whole", *stated, pack.size()));
  if (!(pack.high.x > 0 && pack.high.y > 0 && pack.high.z > 0))
    throw InputError(file, 1, "does not state its domain (\"Domain Length (x,y,z): 1, 1, 1\")");
  notes.push_back("lengths have no unit in this format and are taken as m; the domain repeats itself");
  return pack;
}

SpherePack read_csv(const std::string& file, std::vector<std::string>& notes) {
  LaboratoryTable table(file);
  const auto column = [&](std::vector<std::string_view> names) -> std::optional<std::vector<double>> {
    const Quantity quantity{std::move(names), dimension::length, ""};
    const auto at = table.find(quantity);
    if (!at) return std::nullopt;
    return table.values(*at, quantity);
  };
  const auto x = column({"x"}), y = column({"y"}), z = column({"z"});
  auto radius = column({"radius", "r"});
  if (!radius) {
    radius = column({"diameter", "d"});
    if (radius)
      for (double& r : *radius) r /= 2;
  }
  if (!x || !y || !z || !radius)
    throw InputError(file, table.header_line(), "spheres need columns x, y, z and radius (or diameter)");
  SpherePack pack;
  for (std::size_t k = 0; k < x->size(); ++k) {
    if (!((*radius)[k] > 0)) throw InputError(file, table.line(k), "a sphere needs a radius above 0");
    const Vec3 centre{(*x)[k], (*y)[k], (*z)[k]};
    const double r = (*radius)[k];
    for (int axis = 0; axis < 3; ++axis) {
      pack.low[axis] = k == 0 ? centre[axis] - r : std::min(pack.low[axis], centre[axis] - r);
      pack.high[axis] = k == 0 ? centre[axis] + r : std::max(pack.high[axis], centre[axis] + r);
    }
    pack.centre.push_back(centre);
    pack.radius.push_back(r);
  }
  notes = table.notes();
  return pack;
}

}  // namespace

bool is_sphere_table(const std::filesystem::path& path) { return path.extension() == ".csv" || is_lbpm(path); }

SpherePack read_spheres(const std::filesystem::path& path, std::vector<std::string>& notes) {
  SpherePack pack = is_lbpm(path) ? read_lbpm(path.string(), notes) : read_csv(path.string(), notes);
  if (pack.size() == 0) throw InputError(path.string(), 0, "holds no spheres");
  pack.label.resize(pack.size());
  std::iota(pack.label.begin(), pack.label.end(), 0);
  return pack;
}

}  // namespace arenite::io

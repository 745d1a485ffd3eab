#pragma once
#include "io/sample/sample.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>
#include <variant>
#include <vector>

#include "core/error.hpp"
#include "support/temporary_folder.hpp"

namespace arenite::io {

/// Two files in a folder of their own, and what reading them says.
class Files {
 public:
  Files(const std::string& grains, const std::string& contacts) {
    std::ofstream(grains_) << grains;
    std::ofstream(contacts_) << contacts;
  }
  Sample read(const SampleOptions& options = {}) const { return read_sample(grains_, contacts_, options); }
  /// Of a file of grains alone where there is nothing in the other.
  AnySample any(const SampleOptions& options = {}) const {
    return read_any_sample(grains_, std::filesystem::is_empty(contacts_) ? std::filesystem::path() : contacts_,
                           options);
  }
  SampleIn<3> spheres(SampleOptions options = {}) const {
    options.dimension = 3;
    return std::get<SampleIn<3>>(any(options));
  }
  /// All problems as "name:line: message", one a line; empty if there are none.
  std::string problems(const SampleOptions& options = {}) const {
    return problems_of([&] { read(options); });
  }
  std::string problems_of_spheres(const SampleOptions& options = {}) const {
    return problems_of([&] { spheres(options); });
  }
  std::filesystem::path operator/(const std::string& name) const { return folder_ / name; }

 private:
  template <class Read> static std::string problems_of(const Read& read) {
    try {
      read();
    } catch (const InputError& error) {
      std::string text;
      for (Problem p : error.problems()) {
        p.file = std::filesystem::path(p.file).filename().string();
        text += to_string(p) + "\n";
      }
      return text;
    }
    return {};
  }

  test::TemporaryFolder folder_;
  std::filesystem::path grains_ = folder_ / "grains.csv", contacts_ = folder_ / "contacts.csv";
};

inline void expect_part(const std::string& text, const std::string& part) {
  EXPECT_NE(text.find(part), std::string::npos) << "\"" << part << "\" is not in:\n" << text;
}

/// Whether a note has this part.
inline bool says(const std::vector<std::string>& notes, const std::string& part) {
  return std::ranges::any_of(notes, [&](const std::string& note) { return note.find(part) != std::string::npos; });
}

inline const std::string mercury_data =
    "1 0 0 0 4 2\n9 9 0 0 9 0 0 0\n"  // an earlier time step
    "3 0.5 0 0 4 2\n1 1 0 0 1 0 0 0\n2.9 1 0 0 1 0 0 0\n1 1.8 0 0 0.1 0 0 1\n";
inline const std::string mercury_fstat =
    "# 0.5 0\n# 0 0 0 4 2 0\n# 1 1 0 0 0 0\n"
    "0.5 0 1 1.95 1 0 0.1 0 10 3 -1 0 0 0 1 0\n"  // force on 0: (-10, 3)
    "0.5 1 0 1.95 1 0 0.1 0 10 3 1 0 0 0 -1 0\n"  // the same contact, for grain 1
    "0.5 0 -1 0 1 0 0 0 7 1 -1 0 0 0 -1 0\n";     // left wall: MercuryDPM turns n and t round, force on 0: (7, 1)

inline const std::string lammps_atoms =
    "ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n2\nITEM: BOX BOUNDS ff ff pp\n0 4\n0 4\n-1 1\nITEM: ATOMS id type x y "
    "radius\n1 1 1 1 0.5\n2 1 1.9 1 0.5\n";
inline std::string lammps_pairs(const std::string& columns, const std::string& row) {
  return "ITEM: TIMESTEP\n0\nITEM: NUMBER OF ENTRIES\n1\nITEM: ENTRIES " + columns + "\n" + row + "\n";
}

}  // namespace arenite::io

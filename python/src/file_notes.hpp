#pragma once
#include <string>
#include <vector>

#include "module.hpp"

namespace arenite::python {

/// The class of warnings in which what files do not say, or say otherwise than is taken, is told.
void bind_file_notes(pybind11::module_& m);

/// Warns of each sentence, in that class.
void warn_of_notes(const std::vector<std::string>& sentences);

/// The sentences on its files that a packing keeps; none for one that was made otherwise.
void keep_notes(const pybind11::object& packing, const std::vector<std::string>& sentences);
pybind11::list notes_kept(const pybind11::object& packing);

}  // namespace arenite::python

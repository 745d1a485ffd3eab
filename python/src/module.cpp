#include <array>
#include <cctype>
#include <string>
#include <string_view>
#include <utility>

#include "core/error.hpp"
#include "core/version.hpp"
#include "file_notes.hpp"
#include "module.hpp"
#include "statistics/numbers.hpp"

namespace arenite::python {
namespace {

/// Options whose argument has another name than they have; longer ones first.
constexpr std::array<std::pair<std::string_view, std::string_view>, 6> renamed{{{"--doubled merge", "merge_doubled"},
                                                                                {"--touching", "propose_contacts"},
                                                                                {"--columns", "contact_columns"},
                                                                                {"--radius", "radii"},
                                                                                {"--set", "changes"},
                                                                                {"--k ", "stiffness "}}};

bool is_letter(char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; }

/// An option stands at the beginning or behind a space or a bracket; two dashes within a word are the user's own.
bool is_option(const std::string& text, std::size_t at) {
  if (text.compare(at, 2, "--") != 0 || at + 2 >= text.size() || !is_letter(text[at + 2])) return false;
  return at == 0 || text[at - 1] == ' ' || text[at - 1] == '(' || text[at - 1] == '\n';
}

/// The argument for the option at the beginning of `text`, and the length of what it stands for.
std::pair<std::string, std::size_t> argument_at(std::string_view text) {
  for (const auto& [from, to] : renamed)
    if (text.starts_with(from)) return {std::string(to), from.size()};
  std::string name;
  std::size_t at = 2;
  for (; at < text.size(); ++at) {
    if (is_letter(text[at])) name += text[at];
    else if (text[at] == '-' && at + 1 < text.size() && is_letter(text[at + 1])) name += '_';
    else break;
  }
  return {name, at};
}

/// The program's sentence with its options as arguments of Python: "choose one with --slice 0 to 3" names `slice`, and
/// "--set seed=x" becomes "changes seed=x".
std::string with_arguments(const std::string& sentence) {
  std::string text;
  for (std::size_t at = 0; at < sentence.size();) {
    if (!is_option(sentence, at)) {
      text += sentence[at++];
      continue;
    }
    const auto [argument, length] = argument_at(std::string_view(sentence).substr(at));
    text += argument;
    at += length;
  }
  return text;
}

}  // namespace
}  // namespace arenite::python

PYBIND11_MODULE(_core, m) {
  namespace py = pybind11;
  m.doc() =
      "Micromechanics of composite and cemented granular materials. All numbers are in SI units; stresses are positive "
      "in tension, contact forces in compression.";
  m.attr("__version__") = arenite::version;
  py::register_exception_translator([](std::exception_ptr thrown) {
    try {
      if (thrown) std::rethrow_exception(thrown);
    } catch (const arenite::InputError& error) {
      PyErr_SetString(PyExc_ValueError, arenite::python::with_arguments(error.what()).c_str());
    } catch (const arenite::NumbersError&) {
      PyErr_SetString(
          PyExc_ValueError,
          "the numbers stored in the result are not those that this version writes; compute the result again");
    }
  });
  // What is given comes before what takes it, so that docstrings name types as Python does.
  arenite::python::bind_file_notes(m);
  arenite::python::bind_packing(m);
  arenite::python::bind_spheres(m);
  arenite::python::bind_texture(m);
  arenite::python::bind_grain_fields(m);
  arenite::python::bind_chains(m);
  arenite::python::bind_recipe(m);
  arenite::python::bind_phase_map(m);
  arenite::python::bind_voxels(m);
  arenite::python::bind_maps(m);
  arenite::python::bind_film(m);
  arenite::python::bind_film_parts(m);
  arenite::python::bind_film_workflow(m);
  arenite::python::bind_results(m);
  arenite::python::bind_curves(m);
  arenite::python::bind_over_runs(m);
  arenite::python::bind_figures(m);
  arenite::python::bind_pictures(m);
  arenite::python::bind_store(m);
  arenite::python::bind_running_stage(m);
  arenite::python::bind_stages(m);
  arenite::python::bind_field(m);
  arenite::python::bind_identify(m);
  arenite::python::bind_study(m);
}

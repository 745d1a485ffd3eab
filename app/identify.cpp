#include <cstdio>
#include <memory>
#include <string>

#include "commands.hpp"
#include "core/error.hpp"
#include "core/text.hpp"
#include "core/units.hpp"
#include "print.hpp"
#include "workflow/identify/identify_keys.hpp"

namespace arenite::app {
namespace {

struct IdentifyArguments {
  KeyOptions stiffness{recipe::every_key<workflow::StiffnessRequest>()},
      adhesion{recipe::every_key<workflow::AdhesionRequest>()}, factor{recipe::every_key<workflow::FactorRequest>()};
  std::string what, file, stated;
  bool json = false;
};

template <class Request> Request request_of(const KeyOptions& keys, const std::string& stated) {
  Request request;
  read_options(request, keys.given());
  request.stated = stated;
  return request;
}

identify::Identification found_in(const IdentifyArguments& a) {
  if (a.what == "stiffness")
    return workflow::identify_stiffness(a.file, request_of<workflow::StiffnessRequest>(a.stiffness, a.stated));
  if (a.what == "adhesion")
    return workflow::identify_adhesion(a.file, request_of<workflow::AdhesionRequest>(a.adhesion, a.stated));
  return workflow::identify_factor(a.file, request_of<workflow::FactorRequest>(a.factor, a.stated));
}

/// An option whose help says first what it is for.
Option& add(Options& command, KeyOptions& keys, const char* what, const char* name, const char* key, const char* type) {
  Option& option = keys.add(command, name, key).type(type);
  option.sentence.insert(0, std::string(what) + ": ");
  return option;
}

void add_keys(Options& command, IdentifyArguments& a) {
  const auto stiffness = [&](const char* name, const char* key, const char* type) {
    add(command, a.stiffness, "Stiffness", name, key, type);
  };
  stiffness("--preload", "preload", "FORCE");
  stiffness("--branch", "branch", "BRANCH");
  stiffness("--length", "length", "LENGTH");
  const auto adhesion = [&](const char* name, const char* key, const char* type) {
    add(command, a.adhesion, "Adhesion", name, key, type);
  };
  adhesion("--k", "stiffness", "STIFFNESS");
  adhesion("--radius", "radii", "R[,R]");
  adhesion("--effective-radius", "effective_radius", "NAME");
  const auto factor = [&](const char* name, const char* key, const char* type) -> Option& {
    return add(command, a.factor, "Factor", name, key, type);
  };
  factor("--section", "section", "AREA");
  factor("--young", "young", "MODULUS");
  factor("--poisson", "poisson", "NUMBER");
  factor("--temperature-convention", "temperature_convention", "WORD").formerly("--temperature-swing");
  factor("--load-convention", "load_convention", "WORD").formerly("--load-swing");
  factor("--through-origin", "through_origin", "");
  factor("--responsivity", "responsivity", "K");
  factor("--responsivity-at", "responsivity_at", "TEMPERATURE");
  factor("--surface-at", "surface_at", "TEMPERATURE");
  factor("--amplification", "amplification", "NUMBER");
  factor("--emissivity", "emissivity", "NUMBER");
  factor("--band", "band", "LOW,HIGH");
}

}  // namespace

void add_identify(Options& command, int&) {
  const auto a = std::make_shared<IdentifyArguments>();
  command.add("what", a->what, "Quantity to identify")
      .required()
      .among({"stiffness", "factor", "adhesion"})
      .type("WHAT");
  command
      .add("file", a->file,
           "CSV of records or a table, with units in its header: displacement and force; stress or strain and "
           "temperature; or values by group")
      .required()
      .type("FILE");
  add_keys(command, *a);
  command.add("--stated", a->stated, "Table of the values that a source states for the same groups, for comparison")
      .type("FILE");
  command.add("--json", a->json, "Print JSON in SI units: value, error, confidence_95");
  command.work = [a] {
    const auto found = found_in(*a);
    put(stdout, a->json ? to_json(identify::numbers(found), 1) + "\n" : identify::to_text(found));
  };
}

}  // namespace arenite::app

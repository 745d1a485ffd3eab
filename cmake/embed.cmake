# Turns the text file INPUT into the C++ source OUTPUT that defines report::FUNCTION(), declared in HEADER.
include(${CMAKE_CURRENT_LIST_DIR}/raw_literals.cmake)
raw_literals(${INPUT} literals)
file(WRITE ${OUTPUT}
  "#include \"${HEADER}\"\n\nnamespace arenite::report {\n\n"
  "std::string_view ${FUNCTION}() {\n  static constexpr char text[] =\n${literals};\n"
  "  return {text, sizeof text - 1};\n}\n\n"
  "}  // namespace arenite::report\n")

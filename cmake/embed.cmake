# Turns the text file INPUT into the C++ source OUTPUT that defines report::FUNCTION(), declared in HEADER. The text goes into raw
# literals of 8000 characters each, which every compiler takes, and compiles much faster than a list of bytes.
file(READ ${INPUT} text)
string(LENGTH "${text}" length)
set(literals "")
set(at 0)
while(at LESS length)
  string(SUBSTRING "${text}" ${at} 8000 piece)
  string(APPEND literals "R\"page~(${piece})page~\"\n")
  math(EXPR at "${at} + 8000")
endwhile()
file(WRITE ${OUTPUT}
  "#include \"${HEADER}\"\n\nnamespace arenite::report {\n\n"
  "std::string_view ${FUNCTION}() {\n  static constexpr char text[] =\n${literals};\n  return {text, sizeof text - 1};\n}\n\n"
  "}  // namespace arenite::report\n")

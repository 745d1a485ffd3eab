# Turns the text files of the folder STUDIES (studies/NAME/FILE) into the C++ source OUTPUT that defines
# ledger::embedded_files().
file(GLOB files RELATIVE ${STUDIES} ${STUDIES}/*/*)
list(SORT files)
set(rows "")
foreach(path ${files})
  get_filename_component(study ${path} DIRECTORY)
  get_filename_component(name ${path} NAME)
  file(READ ${STUDIES}/${path} text)
  string(APPEND rows "      {\"${study}\", \"${name}\",\n")
  string(LENGTH "${text}" length)
  set(at 0)
  while(at LESS length)
    string(SUBSTRING "${text}" ${at} 8000 piece)
    string(APPEND rows "R\"study~(${piece})study~\"\n")
    math(EXPR at "${at} + 8000")
  endwhile()
  string(APPEND rows "      },\n")
endforeach()
file(WRITE ${OUTPUT}
  "#include \"ledger/studies.hpp\"\n\nnamespace arenite::ledger {\n\n"
  "const std::vector<EmbeddedFile>& embedded_files() {\n  static const std::vector<EmbeddedFile> files{\n${rows}  };\n  return files;\n}\n\n"
  "}  // namespace arenite::ledger\n")

# Turns the text files of the folder STUDIES (validation/studies/NAME/FILE), and the tables of TABLES as the study
# thesis-ch2, into the C++ source OUTPUT that defines validation::embedded_files().
include(${CMAKE_CURRENT_LIST_DIR}/raw_literals.cmake)
set(rows "")
macro(embed study name path)
  raw_literals(${path} literals)
  string(APPEND rows "      {\"${study}\", \"${name}\",\n${literals}      },\n")
endmacro()

file(GLOB tables RELATIVE ${TABLES} ${TABLES}/*.csv)
foreach(name ${tables})
  embed(thesis-ch2 ${name} ${TABLES}/${name})
endforeach()
file(GLOB files RELATIVE ${STUDIES} ${STUDIES}/*/*)
list(SORT files)
foreach(path ${files})
  get_filename_component(study ${path} DIRECTORY)
  get_filename_component(name ${path} NAME)
  embed(${study} ${name} ${STUDIES}/${path})
endforeach()
file(WRITE ${OUTPUT}
  "#include \"validation/studies.hpp\"\n\nnamespace arenite::validation {\n\n"
  "const std::vector<EmbeddedFile>& embedded_files() {\n  static const std::vector<EmbeddedFile> files{\n${rows}  };\n"
  "  return files;\n}\n\n"
  "}  // namespace arenite::validation\n")

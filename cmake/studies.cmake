# The studies of the ledger (studies/) are compiled into the library, so that an installed program has them.
file(GLOB study_files CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/studies/*/*)
set(study_tables ${CMAKE_SOURCE_DIR}/examples/data/thesis-identification)
set(studies_source ${CMAKE_CURRENT_BINARY_DIR}/generated/ledger/embedded_studies.cpp)
add_custom_command(
  OUTPUT ${studies_source}
  COMMAND ${CMAKE_COMMAND} -DSTUDIES=${CMAKE_SOURCE_DIR}/studies -DTABLES=${study_tables} -DOUTPUT=${studies_source}
          -P ${CMAKE_SOURCE_DIR}/cmake/embed_studies.cmake
  DEPENDS ${study_files} ${CMAKE_SOURCE_DIR}/cmake/embed_studies.cmake ${CMAKE_SOURCE_DIR}/cmake/raw_literals.cmake
  COMMENT "Embedding the studies")
target_sources(arenite_core PRIVATE ${studies_source})

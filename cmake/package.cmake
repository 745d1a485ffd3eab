# make deb: one Debian package of program, module, completion, manual page and examples.
install(DIRECTORY examples DESTINATION ${CMAKE_INSTALL_DATADIR}/arenite)
install(DIRECTORY validation/studies DESTINATION ${CMAKE_INSTALL_DATADIR}/arenite/validation)
install(DIRECTORY docs DESTINATION ${CMAKE_INSTALL_DOCDIR}
  FILES_MATCHING PATTERN "*.md" PATTERN "*.png" PATTERN "*.svg" PATTERN "*.csv" PATTERN html EXCLUDE)
install(FILES README.md ARCHITECTURE.md CHANGELOG.md CONTRIBUTING.md LICENSE CITATION.cff packages.txt
  DESTINATION ${CMAKE_INSTALL_DOCDIR})
# Links of the pages lead to examples and studies beside them.
file(RELATIVE_PATH data_from_docs /${CMAKE_INSTALL_DOCDIR} /${CMAKE_INSTALL_DATADIR}/arenite)
file(MAKE_DIRECTORY ${CMAKE_CURRENT_BINARY_DIR}/links)
foreach(folder examples validation)
  file(CREATE_LINK ${data_from_docs}/${folder} ${CMAKE_CURRENT_BINARY_DIR}/links/${folder} SYMBOLIC)
  install(FILES ${CMAKE_CURRENT_BINARY_DIR}/links/${folder} DESTINATION ${CMAKE_INSTALL_DOCDIR})
endforeach()

set(CPACK_GENERATOR DEB)
# Without the library for developers.
set(CPACK_INSTALL_CMAKE_PROJECTS "${CMAKE_BINARY_DIR};${PROJECT_NAME};Unspecified;/")
set(CPACK_PACKAGE_CONTACT "The Arenite developers <arenite@example.org>")
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_DEPENDS "python3 (>= 3.11), python3-numpy")
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS "python3-matplotlib")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "${PROJECT_DESCRIPTION}")
set(CPACK_DEBIAN_PACKAGE_DESCRIPTION
  "Makes packings of grains, compacts, cements and loads them by discrete elements
and peridynamics, and measures how stress travels through them; turns infrared
films of loaded packings into stresses of grains and contact forces.")
include(CPack)

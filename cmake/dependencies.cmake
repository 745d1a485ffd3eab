find_package(Threads REQUIRED)
find_package(fmt 9 REQUIRED)
find_package(nlohmann_json 3.11 REQUIRED)
find_package(CLI11 2.1 REQUIRED)
find_package(Eigen3 3.4 REQUIRED)
find_package(ZLIB REQUIRED)
find_package(PNG 1.6 REQUIRED)
find_package(TIFF 4.5 REQUIRED)
find_package(JPEG REQUIRED)
find_package(HDF5 REQUIRED COMPONENTS C HL)
find_library(XXHASH_LIBRARY xxhash REQUIRED)
find_library(CHOLMOD_LIBRARY cholmod REQUIRED)
find_library(AMD_LIBRARY amd REQUIRED)
find_library(HTTPLIB_LIBRARY cpp-httplib REQUIRED)  # of the program alone, for `arenite watch`

add_library(arenite_dependencies INTERFACE)
target_include_directories(arenite_dependencies SYSTEM INTERFACE ${HDF5_INCLUDE_DIRS})
target_link_libraries(arenite_dependencies INTERFACE
  Threads::Threads fmt::fmt nlohmann_json::nlohmann_json CLI11::CLI11 Eigen3::Eigen
  ZLIB::ZLIB PNG::PNG TIFF::TIFF JPEG::JPEG ${HDF5_HL_LIBRARIES} ${HDF5_LIBRARIES}
  ${XXHASH_LIBRARY} ${CHOLMOD_LIBRARY} ${AMD_LIBRARY} ${CMAKE_DL_LIBS})

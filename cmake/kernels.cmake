# Flags of the inner loops, one source for each kind of processor, chosen at run time.
set(dem src/grains/dem/kernels)
set_source_files_properties(${dem}/portable.cpp PROPERTIES SKIP_PRECOMPILE_HEADERS ON
  COMPILE_OPTIONS "-fno-math-errno;-Wno-psabi")
set_source_files_properties(${dem}/avx2.cpp PROPERTIES SKIP_PRECOMPILE_HEADERS ON
  COMPILE_OPTIONS "-fno-math-errno;-mavx2")
set_source_files_properties(${dem}/avx512.cpp PROPERTIES SKIP_PRECOMPILE_HEADERS ON
  COMPILE_OPTIONS "-fno-math-errno;-mavx512f;-mavx512dq;-mavx512vl")
# GCC 12 warns about its own intrinsics.
set(own_intrinsics "$<$<CXX_COMPILER_ID:GNU>:-Wno-uninitialized;-Wno-maybe-uninitialized>")
# Vectors wider than the machine's pass between functions that are always inlined alone.
set_source_files_properties(src/solid/elements/kernels/portable.cpp PROPERTIES COMPILE_OPTIONS "-Wno-psabi")
foreach(solid src/solid/peridynamics/kernels src/solid/elements/kernels)
  set_source_files_properties(${solid}/avx2.cpp PROPERTIES SKIP_PRECOMPILE_HEADERS ON COMPILE_OPTIONS "-mavx2;-mfma")
  set_source_files_properties(${solid}/avx512.cpp PROPERTIES SKIP_PRECOMPILE_HEADERS ON
    COMPILE_OPTIONS "-mavx512f;-mavx512dq;-mavx512vl;-mfma;${own_intrinsics}")
endforeach()
set(film src/thermal/thermography/kernels)
set_source_files_properties(${film}/portable.cpp PROPERTIES SKIP_PRECOMPILE_HEADERS ON COMPILE_OPTIONS "-O3")
set_source_files_properties(${film}/avx2.cpp PROPERTIES SKIP_PRECOMPILE_HEADERS ON COMPILE_OPTIONS "-O3;-mavx2;-mfma")
set_source_files_properties(${film}/avx512.cpp PROPERTIES SKIP_PRECOMPILE_HEADERS ON
  COMPILE_OPTIONS "-O3;-mavx512f;-mavx512dq;-mavx512vl;-mfma;${own_intrinsics}")
# Loops of a few instructions: a line of the cache cut through one costs a third of its speed.
set_source_files_properties(
  src/thermal/imaging/rim_search.cpp src/thermal/imaging/blur.cpp src/thermal/optics/lens.cpp
  PROPERTIES SKIP_PRECOMPILE_HEADERS ON
  COMPILE_OPTIONS "-O3;-fno-trapping-math;-falign-loops=32")
if(ARENITE_SANITIZE)
  foreach(room ${dem} src/solid/peridynamics/kernels src/solid/elements/kernels ${film})
    set_source_files_properties(${room}/portable.cpp PROPERTIES SKIP_PRECOMPILE_HEADERS ON
      COMPILE_DEFINITIONS Lanes=LanesForAny)
    set_property(SOURCE ${room}/portable.cpp APPEND PROPERTY COMPILE_OPTIONS -march=x86-64)
    set_source_files_properties(${room}/avx2.cpp PROPERTIES COMPILE_DEFINITIONS Lanes=LanesForAvx2)
    set_property(SOURCE ${room}/avx2.cpp APPEND PROPERTY COMPILE_OPTIONS -mno-avx512f)
  endforeach()
endif()

# Flags shared by every target. Contraction is off so that a kernel gives the same bits whatever the
# compiler fuses; kernels that want fused multiply-add ask for it by name.
add_library(arenite_options INTERFACE)
target_compile_options(arenite_options INTERFACE
  -Wall -Wextra -Wpedantic -Wnon-virtual-dtor -ffp-contract=off)
# GCC 12 suspects its own std::string of these where the header was compiled beforehand.
target_compile_options(arenite_options INTERFACE
  "$<$<CXX_COMPILER_ID:GNU>:-Wno-array-bounds;-Wno-stringop-overflow;-Wno-stringop-overread;-Wno-restrict>")
# GCC spends a twentieth of its time on freeing memory that it need not reuse: most batches of sources take
# less than a gigabyte in all.
target_compile_options(arenite_options INTERFACE "$<$<CXX_COMPILER_ID:GNU>:SHELL:--param ggc-min-heapsize=1000000>")
# Sources that are compiled together see each other's globals, which no one shadows by mistake, and look to GCC like a
# header that shows its anonymous namespace. Clang cannot tell such shadows from others.
set(together "$<BOOL:$<TARGET_PROPERTY:UNITY_BUILD>>")
set(shadows_of_together "$<$<CXX_COMPILER_ID:GNU>:-Wshadow=local;-Wno-subobject-linkage>")
target_compile_options(arenite_options INTERFACE "$<IF:${together},${shadows_of_together},-Wshadow>")
if(ARENITE_WERROR)
  target_compile_options(arenite_options INTERFACE -Werror)
endif()
if(ARENITE_SANITIZE)
  # Instrumented, std::regex looks to GCC 12 as if it read what it never wrote.
  target_compile_options(arenite_options INTERFACE
    -fsanitize=${ARENITE_SANITIZE} -fno-omit-frame-pointer -g1
    "$<$<CXX_COMPILER_ID:GNU>:-Wno-uninitialized;-Wno-maybe-uninitialized>")
  target_link_options(arenite_options INTERFACE -fsanitize=${ARENITE_SANITIZE})
  # Less is inlined: functions that kernels share with all else remain, and the linker keeps one of each. So all is made
  # for this machine; what is not (cmake/kernels.cmake) names its lanes apart, which it passes otherwise.
  target_compile_options(arenite_options INTERFACE -march=native)
  # At -O2 the sanitized inner loops take a minute each to compile.
  target_compile_options(arenite_options INTERFACE -O1)
endif()

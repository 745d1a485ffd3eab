#pragma once
#include <vector>

namespace arenite::app {

/// A name of the environment and its value.
struct Setting {
  const char* name;
  const char* value;
};

/// OpenBLAS starts its threads as it is loaded and takes their number from the environment only.
inline constexpr Setting one_blas_thread{"OPENBLAS_NUM_THREADS", "1"};

/// The C library asks for pages of 2 MiB for large arrays where the environment says so as it is loaded: a run of the
/// paper takes an eighth less time, most of it spent before on handing out pages of 4 KiB.
inline constexpr Setting large_pages{"GLIBC_TUNABLES", "glibc.malloc.hugetlb=1"};

/// Where the environment does not say a setting, the program begins anew with it.
void start_anew_with(const std::vector<Setting>& settings, char** argv);

/// Does the work of the command that the command line names, and says what stopped it; returns the exit status.
int run_program(int argc, char** argv);

}  // namespace arenite::app

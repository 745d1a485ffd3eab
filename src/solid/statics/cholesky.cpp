#include "solid/statics/cholesky.hpp"

#include <dlfcn.h>
#include <suitesparse/amd.h>
#include <suitesparse/cholmod.h>

#include <cstring>
#include <new>

namespace arenite::statics {

namespace {

/// OpenBLAS asks for its working memory at the first factorisation, and asks for ever where there is none: here it gets
/// it while there is, and keeps it. Throws std::bad_alloc.
void give_blas_its_memory() {
  constexpr std::size_t wanted = std::size_t{136} << 20;
  ::operator delete(::operator new(wanted));
  using Factorise = void (*)(const char*, const int*, double*, const int*, int*, std::size_t);
  const int one = 1;
  int failed = 0;
  double square = 1;
  if (void* symbol = dlsym(RTLD_DEFAULT, "dpotrf_"))
    reinterpret_cast<Factorise>(symbol)("L", &one, &square, &one, &failed, 1);
}

/// One solve uses one core; threads inside the factor's small dense blocks cost more than they give.
void set_up_blas() {
  using Setter = void (*)(int);
  void* const openblas = dlsym(RTLD_DEFAULT, "openblas_set_num_threads");
  if (!openblas) return;
  reinterpret_cast<Setter>(openblas)(1);
  static const bool has_memory = (give_blas_its_memory(), true);
  (void)has_memory;
}

/// The same for CHOLMOD's own loops, which ask OpenMP for four threads whatever it is told: no parallel region is
/// active as long as one of these lives. OpenMP's threads do not outlive a fork, so a process in which it has started
/// any could not be forked into one that solves.
class NoOpenMp {
 public:
  NoOpenMp() {
    if (get_ && set_) before_ = get_(), set_(0);
  }
  ~NoOpenMp() {
    if (get_ && set_) set_(before_);
  }
  NoOpenMp(const NoOpenMp&) = delete;
  NoOpenMp& operator=(const NoOpenMp&) = delete;

 private:
  int (*get_)() = reinterpret_cast<int (*)()>(dlsym(RTLD_DEFAULT, "omp_get_max_active_levels"));
  void (*set_)(int) = reinterpret_cast<void (*)(int)>(dlsym(RTLD_DEFAULT, "omp_set_max_active_levels"));
  int before_ = 0;
};

/// Elimination order of the blocks, each kept whole, as an order of scalars.
std::vector<int> ordering(const BlockMatrix& m) {
  const int n = m.columns();
  std::vector<int> blocks(static_cast<std::size_t>(n)), scalars;
  scalars.reserve(static_cast<std::size_t>(m.side) * blocks.size());
  double control[AMD_CONTROL];
  amd_defaults(control);
  amd_order(n, m.column_begin.data(), m.row.data(), blocks.data(), control, nullptr);
  for (const int block : blocks)
    for (int s = 0; s < m.side; ++s) scalars.push_back(m.side * block + s);
  return scalars;
}

}  // namespace

struct Cholesky::State {
  cholmod_common common{};
  cholmod_factor* factor = nullptr;
  cholmod_dense *x = nullptr, *y = nullptr, *e = nullptr;
  bool positive = false;

  State() {
    set_up_blas();
    cholmod_start(&common);
    common.print = 0;
    common.nmethods = 1;
    common.method[0].ordering = CHOLMOD_GIVEN;
    common.supernodal = CHOLMOD_SUPERNODAL;
  }
  ~State() {
    cholmod_free_dense(&x, &common);
    cholmod_free_dense(&y, &common);
    cholmod_free_dense(&e, &common);
    cholmod_free_factor(&factor, &common);
    cholmod_finish(&common);
  }
};

Cholesky::Cholesky(BlockMatrix m) : state_(std::make_unique<State>()) {
  cholmod_common& common = state_->common;
  const int side = m.side;
  const auto n = static_cast<std::size_t>(side) * static_cast<std::size_t>(m.columns());
  const std::size_t entries = m.value.size() - static_cast<std::size_t>(m.columns() * (side * (side - 1) / 2));
  cholmod_sparse* a = cholmod_allocate_sparse(n, n, entries, 1, 1, -1, CHOLMOD_REAL, &common);
  if (!a) throw std::bad_alloc();
  auto* begin = static_cast<int*>(a->p);
  auto* row = static_cast<int*>(a->i);
  auto* value = static_cast<double*>(a->x);
  int k = 0;
  for (int c = 0; c < m.columns(); ++c)
    for (int s = 0; s < side; ++s) {
      begin[side * c + s] = k;
      for (int j = m.column_begin[c]; j < m.column_begin[static_cast<std::size_t>(c) + 1]; ++j)
        for (int r = 0; r < side; ++r) {
          const int scalar_row = side * m.row[j] + r;
          if (scalar_row < side * c + s) continue;
          row[k] = scalar_row;
          value[k++] = m.value[static_cast<std::size_t>((static_cast<std::ptrdiff_t>(j) * side + s) * side + r)];
        }
    }
  begin[n] = k;
  auto order = ordering(m);
  m = {};
  const NoOpenMp one_thread;
  state_->factor = cholmod_analyze_p(a, order.data(), nullptr, 0, &common);
  if (state_->factor) {
    cholmod_factorize(a, state_->factor, &common);
    state_->positive = common.status == CHOLMOD_OK && state_->factor->minor == n;
  }
  cholmod_free_sparse(&a, &common);
  if (!state_->factor || common.status == CHOLMOD_OUT_OF_MEMORY) throw std::bad_alloc();
}

Cholesky::~Cholesky() = default;

bool Cholesky::positive() const { return state_->positive; }

void Cholesky::solve(std::vector<double>& b) {
  cholmod_dense right{};
  right.nrow = right.d = right.nzmax = b.size();
  right.ncol = 1;
  right.x = b.data();
  right.xtype = CHOLMOD_REAL;
  right.dtype = CHOLMOD_DOUBLE;
  const NoOpenMp one_thread;
  cholmod_solve2(CHOLMOD_A, state_->factor, &right, nullptr, &state_->x, nullptr, &state_->y, &state_->e,
                 &state_->common);
  std::memcpy(b.data(), state_->x->x, b.size() * sizeof(double));
}

}  // namespace arenite::statics

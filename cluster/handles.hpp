#pragma once
#include <petscdmda.h>
#include <petscksp.h>

#include <stdexcept>

namespace arenite::cluster {

inline void must(PetscErrorCode code) {
  if (code) throw std::runtime_error("PETSc stopped the solve, and says above why");
}

/// Something of PETSc's, given back at its end.
template <class T, PetscErrorCode (*destroy)(T*)> class Handle {
 public:
  Handle() = default;
  Handle(Handle&& other) noexcept : held_(other.held_) { other.held_ = nullptr; }
  Handle& operator=(Handle&&) = delete;
  ~Handle() {
    if (held_) destroy(&held_);
  }
  T* operator&() { return &held_; }
  operator T() const { return held_; }

 private:
  T held_ = nullptr;
};
using Mesh = Handle<DM, DMDestroy>;
using Matrix = Handle<Mat, MatDestroy>;
using Vector = Handle<::Vec, VecDestroy>;
using NullSpace = Handle<MatNullSpace, MatNullSpaceDestroy>;
using Solver = Handle<KSP, KSPDestroy>;

/// A vector on a mesh of nodes with three components each, as [z][y][x][component].
class Values {
 public:
  Values(DM mesh, ::Vec vector) : mesh_(mesh), vector_(vector) { must(DMDAVecGetArrayDOF(mesh, vector, &at_)); }
  Values(const Values&) = delete;
  ~Values() { DMDAVecRestoreArrayDOF(mesh_, vector_, &at_); }
  PetscScalar* operator()(PetscInt x, PetscInt y, PetscInt z) const { return at_[z][y][x]; }

 private:
  DM mesh_;
  ::Vec vector_;
  PetscScalar**** at_ = nullptr;
};
/// The same to read.
class ReadValues {
 public:
  ReadValues(DM mesh, ::Vec vector) : mesh_(mesh), vector_(vector) { must(DMDAVecGetArrayDOFRead(mesh, vector, &at_)); }
  ReadValues(const ReadValues&) = delete;
  ~ReadValues() { DMDAVecRestoreArrayDOFRead(mesh_, vector_, &at_); }
  const PetscScalar* operator()(PetscInt x, PetscInt y, PetscInt z) const { return at_[z][y][x]; }

 private:
  DM mesh_;
  ::Vec vector_;
  PetscScalar**** at_ = nullptr;
};

}  // namespace arenite::cluster

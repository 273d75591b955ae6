#pragma once

#include <petscmat.h>

#include <new>
#include <stdexcept>
#include <string>
#include <utility>

namespace tricontact::fem::distributed {

/// An error code of PETSc as an exception: std::bad_alloc, std::runtime_error.
inline void check(PetscErrorCode code) {
    if (!code) return;
    if (code == PETSC_ERR_MEM) throw std::bad_alloc();
    const char* text = nullptr;
    PetscErrorMessage(code, &text, nullptr);
    throw std::runtime_error(std::string("PETSc: ") + (text ? text : "unknown error"));
}

/// Owns an object of PETSc that `destroy` ends.
template <typename T, PetscErrorCode (*destroy)(T*)>
class Owned {
  public:
    Owned() = default;
    Owned(Owned&& other) noexcept : object_(std::exchange(other.object_, nullptr)) {}
    Owned& operator=(Owned&& other) noexcept {
        std::swap(object_, other.object_);
        return *this;
    }
    ~Owned() {
        if (object_) destroy(&object_);
    }
    T* put() { return &object_; }
    operator T() const { return object_; }

  private:
    T object_ = nullptr;
};
using Matrix = Owned<Mat, MatDestroy>;
using Vector = Owned<Vec, VecDestroy>;
using Indices = Owned<IS, ISDestroy>;
using Scatter = Owned<VecScatter, VecScatterDestroy>;

}  // namespace tricontact::fem::distributed

#pragma once

#include <fftw3.h>

#include <cstring>
#include <memory>
#include <new>
#include <type_traits>

#include "contact/base/memory.h"

// What FFTW allocates and plans, owned.
namespace tricontact::contact {

struct FftwFree {
    void operator()(void* p) const { fftw_free(p); }
    void operator()(fftw_plan plan) const { fftw_destroy_plan(plan); }
};
using FftwReal = std::unique_ptr<double[], FftwFree>;
using FftwComplex = std::unique_ptr<fftw_complex[], FftwFree>;
using FftwPlan = std::unique_ptr<std::remove_pointer_t<fftw_plan>, FftwFree>;

/// FFTW's planner is one for the whole process: from now on several threads may plan and destroy
/// plans at once. Before the first plan; fftw_memory() calls it.
void let_threads_plan();

/// Aligned, not initialised; `Owned`: FftwReal or FftwComplex. Throws std::bad_alloc.
template <class Owned>
Owned fftw_memory(std::size_t n) {
    let_threads_plan();
    const std::size_t bytes = n * sizeof(typename Owned::element_type);
    Owned memory(static_cast<typename Owned::pointer>(fftw_malloc(bytes)));
    if (!memory) throw std::bad_alloc();
    use_large_pages(memory.get(), bytes);
    return memory;
}

/// `n` zeros.
template <class Owned>
Owned fftw_zeros(std::size_t n) {
    Owned memory = fftw_memory<Owned>(n);
    std::memset(memory.get(), 0, n * sizeof(typename Owned::element_type));
    return memory;
}

}  // namespace tricontact::contact

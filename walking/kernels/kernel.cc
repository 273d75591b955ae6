#include "walking/kernels/kernel.h"

namespace tricontact::walking {

std::vector<Kernel> available_kernels() {
    std::vector<Kernel> kernels{Kernel::plain};
#ifdef __x86_64__
    kernels.push_back(Kernel::sse2);  // every processor of this architecture
    if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma"))
        kernels.push_back(Kernel::avx2);
    if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq"))
        kernels.push_back(Kernel::avx512);
#endif
    return kernels;
}

Kernel best_kernel() {
    return available_kernels().back();
}

namespace kernels {

LaneFunctions functions_of(Kernel kernel) {
#ifdef __x86_64__
    if (kernel == Kernel::sse2) return sse2_lanes();
    if (kernel == Kernel::avx2) return avx2_lanes();
    if (kernel == Kernel::avx512) return avx512_lanes();
#endif
    return plain_lanes();
}

}  // namespace kernels

}  // namespace tricontact::walking

#pragma once

#include <string_view>
#include <vector>

namespace tricontact::walking {

/// Instruction set a batch computes with. All lead to the same statistics; avx2 and avx512, which
/// have fused multiply-add, also to the same bits, and so do plain and sse2.
enum class Kernel {
    plain,  ///< no vectors
    sse2,   ///< 2 machines at once
    avx2,   ///< 4
    avx512  ///< 8
};

std::string_view word_of(Kernel kernel);  ///< "plain", "sse2", "avx2", "avx512"

/// Numbers that a batch computes with.
enum class Precision {
    /// Twice as fast. Limit cycles and shares of a map are the same; a chaotic motion is another
    /// one
    /// of the same kind, and a machine may end in another one of its ways to go.
    float32,
    float64
};

/// Those that this processor has, the fastest one last.
std::vector<Kernel> available_kernels();

/// The fastest one that this processor has.
Kernel best_kernel();

}  // namespace tricontact::walking

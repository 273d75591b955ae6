#pragma once

#include <cstdint>

#include "dynamics/kernel.h"

namespace tricontact::benchmarks {

/// Vector instructions per second of one core where none waits for another: multiply-adds, or
/// multiplications and additions in turn where the kernel has no fused ones (no vectors: those of
/// SSE2). Best of a few milliseconds.
double arithmetic_peak(dynamics::Kernel kernel);

}  // namespace tricontact::benchmarks

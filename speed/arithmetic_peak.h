#pragma once

#include <cstdint>

#include "walking/kernels/kernel.h"

namespace tricontact::speed {

/// Vector instructions per second of one core where none waits for another: multiply-adds, or
/// multiplications and additions in turn where the kernel has no fused ones (no vectors: those of
/// SSE2). Best of a few milliseconds.
double arithmetic_peak(walking::Kernel kernel);

}  // namespace tricontact::speed

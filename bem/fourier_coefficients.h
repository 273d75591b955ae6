#pragma once

#include <functional>

#include "bem/grid_convolution.h"

namespace tricontact::bem {

/// The position in (-period/2, period/2] that element i < period of a transform stands for.
int wrapped(int i, int period);

/// The symbol of a kernel, see GridConvolution, at k_x >= 0 and all k_y, without what a
/// GridConvolution pads it with. An element half a period away stands for both sides.
GridConvolution::Symbol fourier_coefficients(int period_x, int period_y,
                                             const std::function<double(int, int)>& coefficient,
                                             GridConvolution::Parity parity, int n_threads);

}  // namespace tricontact::bem

#pragma once

namespace tricontact::comparisons {

/// What the limit of shakedown is looked for in, the other one given.
enum class LimitVariable {
    load,      ///< f_T = F_T/(mu F_N) at the case's amplitude
    amplitude  ///< w = W/a, a as the case's amplitude ratio has it, at the case's load
};

}  // namespace tricontact::comparisons

#pragma once

#include <vector>

#include "walking/machine/machine.h"
#include "walking/machine/motion.h"
#include "walking/run/walk_result.h"

namespace tricontact::walking {

/// A period of the excitation.
struct ExcitedPeriod {
    double shift = 0;     ///< x + phi at its end, of the body at its base, in units of b
    double airborne = 0;  ///< share of its time in which a spot, or more, is in the air
};

/// Follows an excited machine period by period.
class PeriodRecorder {
  public:
    /// The machine has an excitation of a frequency > 0.
    PeriodRecorder(const Machine& machine, const Motion& start);

    /// Next step; `motion` as its spots see it.
    void add(const Motion& motion);

    const std::vector<ExcitedPeriod>& periods() const { return periods_; }

  private:
    double start_, length_;
    int steps_ = 0, airborne_ = 0;  // of the open period
    std::vector<ExcitedPeriod> periods_;
};

/// Whether a machine whose base stands still (kappa6 = 0) has come to rest under its excitation:
/// sets drift and regime of the result of a run that did not tilt. Empty for fewer than eight
/// periods, which do not tell.
void judge_drift(const Machine& machine, const std::vector<ExcitedPeriod>& periods,
                 WalkResult& result);

/// Amplitudes of the moment over kappa4, or of the force, at which a two-spot machine changes its
/// ways if it is excited slowly and pulled by f = <f_s>/(mu kappa4) in [0, 1].
struct DriftLimits {
    double ratcheting = 0;  ///< above it does not shake down
    double lift_off = 0;    ///< above its trailing spot leaves the ground
};

/// Loads of the spots, quasi-static: (1 ± f mu/mu_c ± m sin)/2 of the weight under a moment, with
/// mu_c of critical_friction; (1 - m sin)/2 each under a force. What the spots carry at their least
/// load, they carry always: the machine shakes down below f = 1 - m, as MDR's bed does at its
/// least loads (Wetter (2016), section 3.2). Rolling of the tips, W = R Phi, moves the limits by
/// less than the contact's radius over b.
DriftLimits drift_limits(const Machine& machine, double pull);

}  // namespace tricontact::walking

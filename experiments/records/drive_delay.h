#pragma once

#include <optional>
#include <vector>

namespace tricontact::experiments {

/// How far what follows the drive lags behind it: the phase of the shift's first harmonic against
/// the drive's, beside a straight line and the second harmonic, which steps at the turning points
/// have.
struct DriveDelay {
    double time = 0;            ///< positive: the shift is late, or the drive's clock is early [s]
    double standard_error = 0;  ///< of it, by least squares [s]
    double shift_upright = 0;   ///< what the shift is off at the roller's upright by it [m]

    /// Three standard errors, and a fiftieth of a period, which hysteresis of a contact stays
    /// below.
    bool is_seen(double period) const;
};

/// Of whole periods from `begin` on [s]; empty where nothing follows the drive by more than six
/// standard errors.
std::optional<DriveDelay> drive_delay(const std::vector<double>& time,
                                      const std::vector<double>& shift, double begin,
                                      double period);

}  // namespace tricontact::experiments

#pragma once

#include <complex>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "report/derived_value.h"
#include "report/document.h"
#include "walking/machine/energy.h"
#include "walking/machine/walk_case.h"
#include "walking/run/walk.h"
#include "walking/run/walk_readings.h"

// The report of a run, its sections and files.

namespace tricontact::walking {

/// A run of a walking machine.
struct WalkReport {
    WalkCase walk_case;
    Walk walk;
};

/// What the report's figures need of a run: enough of its end for the spectrum of a chaotic one.
inline constexpr Recording report_recording{.start = 100, .tail = 500, .interval = 0.05};

/// What a machine does after its transient: verdicts, the motion and forces of figures 4.5, 4.6 and
/// 4.17 to 4.19 of Wetter (2016), the whole run, its section, spectrum and running variance. Files,
/// command and version are the caller's.
report::Document walk_document(const WalkReport& report);

/// What a run came to, whether it was long enough, whether the body jumps and its spots move where
/// they press little.
std::vector<report::Verdict> walk_verdicts(const WalkReport& report,
                                           const std::optional<Vibration>& vibration);

/// Displacement, height, rotation and spring force over some periods, one period with its phases,
/// and the phase plane: Wetter (2016), figures 4.5, 4.6, 4.17 and 4.18.
report::DocumentSection motion_section(const WalkReport& report);

/// Forces of the contact spots over some periods with what the spots do; of many spots how many
/// stick, slip and are released.
report::DocumentSection contact_section(const WalkReport& report);

/// The whole run: means and extremes over windows of time with the end of the transient, and its
/// Poincare section as a return map.
report::DocumentSection course_section(const WalkReport& report);

/// Spectrum of the spring force with its characteristic frequency beside that of free flight, and
/// its running variance: Wetter (2016), figures 5.24, 5.25 and 4.22.
report::DocumentSection vibration_section(const WalkReport& report, const Vibration& vibration);

/// Energy balance of the motion that a run ends in.
struct EnergyStretch {
    EnergyBalance balance;
    double length = 0;  ///< time, a period of a limit cycle
    double scale = 0;   ///< greatest of works and changes, > 0
};

/// From the end of the run on, a period of its limit cycle or some swings further; none for a
/// machine that fell over or does not move.
std::optional<EnergyStretch> energy_of(const WalkReport& report);

/// Whether work of the base is dissipation plus change of stored energy.
report::Verdict energy_verdict(const WalkReport& report, const EnergyStretch& energy);

report::DocumentSection energy_section(const EnergyStretch& energy);

/// Linear stability of steady sliding, from which vibration may or may not start by itself:
/// [sqrt(k_x/m)], Im >= 0, fastest growth first. Empty: there is none, the body tilts.
using Eigenvalues = std::vector<std::complex<double>>;
Eigenvalues sliding_stability(const Machine& machine);
/// Small disturbances neither grow nor decay.
bool is_neutral(const Eigenvalues& stability);

report::Verdict stability_verdict(const WalkReport& report, const Eigenvalues& stability);

report::DocumentSection stability_section(const Eigenvalues& stability);

/// A line for each window of the run: its means and extremes. Ratios as in WalkResult.
std::string windows_csv(const WalkCase& walk_case, const Walk& walk);

/// A line for each recorded state of the end of the run: motion, spring force and, spot by spot,
/// forces and state (0 released, 1 stick, 2 slip). Lengths in units of b, times of sqrt(m/k_x),
/// forces of k_x b; of a machine with dimensions also the time in s and the spring force in N.
std::string motion_csv(const WalkCase& walk_case, const Walk& walk);

/// The numbers of a run, dimensionless as walking/run/walk.h has them; "dimensional" holds
/// those in SI units, null for a machine without dimensions. Undefined numbers are null. Spots are
/// numbered from 1, left to right: stick_time_1, correlation_1 ...
nlohmann::ordered_json walk_json(const WalkCase& walk_case, const Walk& walk);

/// What a run came to, as lines for people.
std::string walk_text(const WalkCase& walk_case, const Walk& walk);

/// What follows from a case of the walking machine (Wetter (2016), chapter 4).
std::vector<report::DerivedValue> walk_scales(const WalkCase& c);

/// The text of a walking machine's summary.json. `resolved` is the case as text.
std::string walk_summary(const WalkCase& walk_case, const std::string& resolved, const Walk& walk);

}  // namespace tricontact::walking

#pragma once

#include <string>
#include <vector>

#include "io/case/measurement_laws.h"
#include "io/case/rig_file.h"

namespace tricontact::experiments {

/// Tables that will be measured to tell laws of friction apart.
struct LawPlan {
    std::vector<std::string> laws;  ///< to be told from that of the case, see io::measurement_laws
    /// Standard errors over what is measured: of a force of full sliding, of a static shift, of the
    /// amplitude of the limit of shakedown; 0: that one is not measured.
    double sliding_error = 0, shift_error = 0, limit_error = 0;
};

/// One row of them.
struct PlannedRow {
    const char* quantity;          ///< "sliding force"
    double normal_force = 0;       ///< [N]
    double tangential_force = 0;   ///< [N]; 0: it is what is measured
    double value = 0;              ///< under the case's law [N, m]
    double standard_error = 0;     ///< [N, m]
    const char* unit = "N";        ///< of value and error
    std::vector<double> off = {};  ///< from each law at its best, in standard errors
};

/// How far the tables are from what another law can explain.
struct LawSeparation {
    std::vector<PlannedRow> rows;
    /// D of each law: root of the sum of squares over the standard errors that its best numbers
    /// leave of tables without noise, uncertain numbers of the case included.
    std::vector<double> distances;
};

/// The law of the case among io::measurement_laws(); null: of more numbers than any of these.
const io::MeasurementLaw* law_of(const contact::Friction& friction);

/// By closed forms of the half-space. Under F_N of the case, F_N over design.load_ratio and the
/// geometric mean of both: the force of full sliding, and static shifts under load.tangential_ratio
/// and half of it; with limit_error the amplitude at which the first begins to ratchet under F_N.
/// Another law has its own numbers, and those that the case states with errors (of [substrate] and
/// [indenter]) within these. Throws contact::InputError, contact::NotConverged.
/// `noise`: in standard errors, one per row; empty: none.
LawSeparation law_separation(const io::RigFile& file, const LawPlan& plan,
                             const std::vector<double>& noise = {});

/// D at which 95 of 100 such tables exclude the other law as tricontact identify does: the
/// likelihood ratio is normal about D^2 with a standard deviation of 2 D (Cox 1961; Atkinson and
/// Fedorov 1975, T-optimality), and D^2 - 1.645 x 2 D = 9.21, its excluded_aicc.
inline constexpr double told_distance = 5.1;

}  // namespace tricontact::experiments

#pragma once

#include <string>

#include "comparisons/document.h"
#include "contact/rolling_rig.h"
#include "rig/printed.h"

// A rig's report, and its parts in words for console and document.
namespace tricontact::app {

/// "18.1 ± 1.5 µm"; pure numbers without unit. Error 0: none is told.
std::string text_of(const theory::Uncertain& value, const std::string& unit);
/// "DU = 1.55 ± 0.13 µm, R = 40 mm"
std::string given_text(const rig::Calculation& calculation);
/// "Dh = DU R/(w a) = 18.1 ± 1.5 µm, with DU = ..."
std::string arithmetic(const rig::Calculation& calculation);
/// "at most 0.05"
std::string threshold_text(const rig::Criterion& criterion);

const char* word_of(rig::Standing standing);                  ///< "holds"
const char* word_of(rig::PrintedCheck::Agreement agreement);  ///< "within its error"
/// What the print would follow from: "E_2 = 5.01 MPa instead of 5.2 MPa; ..."; empty if it agrees.
std::string substitutes_text(const rig::PrintedCheck& check);
/// "the printed error is 1.06 times the propagated one"; empty if both agree, or one is missing.
std::string error_text(const rig::PrintedCheck& check);

/// The text of rig.json: SI units, undefined numbers as null (docs/rig.md).
std::string rig_json(const rig::RigReport& report);

/// What report.html says of a rig. `command`: that makes it again.
comparisons::Document rig_document(const rig::RigReport& report, const std::string& command);

/// Shift [m] of a rig's sphere, taken as a rigid paraboloid, on its layer by `bem-layer`: under
/// F_N, pressed with friction in the usual steps, and rig::coupling_tangential_ratio; 22 cells in
/// the contact radius. Throws contact::NotConverged.
double static_shift(const contact::RollingRig& rig, bool coupled);

}  // namespace tricontact::app

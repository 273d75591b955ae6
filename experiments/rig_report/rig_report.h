#pragma once

#include <string>

#include "experiments/assumptions/check_rig.h"
#include "report/document.h"

// A rig's report, and its parts in words for console and document.
namespace tricontact::experiments {

/// "18.1 ± 1.5 µm"; pure numbers without unit. Error 0: none is told.
std::string text_of(const Estimate& value, const std::string& unit);
/// "DU = 1.55 ± 0.13 µm, R = 40 mm"
std::string given_text(const Calculation& calculation);
/// "Dh = DU R/(w a) = 18.1 ± 1.5 µm, with DU = ..."
std::string arithmetic(const Calculation& calculation);
/// "at most 0.05"
std::string threshold_text(const Criterion& criterion);

const char* word_of(PrintedCheck::Agreement agreement);  ///< "within its error"
/// What the print would follow from: "E_2 = 5.01 MPa instead of 5.2 MPa; ..."; empty if it agrees.
std::string substitutes_text(const PrintedCheck& check);
/// "the printed error is 1.06 times the propagated one"; empty if both agree, or one is missing.
std::string error_text(const PrintedCheck& check);

/// "+23.1 ± 0.8 %", "at most 2 %".
std::string text_of(const MeasuredEffect& effect);
/// "static shift +23.1 ± 0.8 %, indentation at most 2 %" of an assumption's effects; empty if none
/// is known.
std::string effects_text(const RigReport& report, const std::string& assumption);

/// The text of rig.json: SI units, undefined numbers as null (docs/how-to/rig.md).
std::string rig_json(const RigReport& report);

/// What report.html says of a rig, without version and command.
report::Document rig_document(const Rig& rig, const RigReport& report);

}  // namespace tricontact::experiments

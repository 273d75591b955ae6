#pragma once

#include <string>

#include "rig/printed.h"

// Parts of a rig's report in words, for console and document.
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

}  // namespace tricontact::app

#pragma once

#include <optional>

#include "experiments/records/record_checks.h"

namespace tricontact::experiments {

/// Step of the recorded shift [m]: the stated one, if the record does not show steps that are more
/// than one and a half times as large: then those. Steps that are 10^3 or 10^6 times as large or
/// small as stated speak of a wrong unit.
double resolution_of(const Record& record, std::optional<double> stated, RecordFindings& findings);

/// The shift under load, with its standard error [m], is negative by more than five of these though
/// F_T is not: it spoils the record.
void find_sign(const Record& record, double static_shift, double standard_error,
               RecordFindings& findings);

/// A recorded drive whose turning points are not where a drive of constant speed has them, with its
/// mean distance from upright: clipped, sinusoidal, or at rest while it should turn; or that stands
/// aside in the end.
void find_uneven_drive(const Record& record, const DriveTimeline& timeline,
                       RecordFindings& findings);

/// "1000", "1e-6", ...: the power of a thousand that `ratio` is, within a relative `tolerance`;
/// empty where it is none, or one.
std::optional<double> power_of_thousand(double ratio, double tolerance);

}  // namespace tricontact::experiments

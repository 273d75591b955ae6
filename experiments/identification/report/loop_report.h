#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "experiments/identification/identification_report.h"

namespace tricontact::experiments {

/// "cycles 1 to 200, F_N = 300 N, amplitude 10 um".
std::string loop_series_text(const LoopSeries& series);

/// Regimes, energies and drift in sentences; empty without loops.
std::vector<report::Verdict> loop_verdicts(const IdentificationStudy& study);

/// A row per series, per block of cycles, and per cycle.
std::vector<report::DocumentTable> loop_tables(const IdentificationStudy& study);

/// Measured and fitted loops of a table, and friction over the cycles.
report::Figure loop_figure(const IdentificationStudy& study, std::size_t t);
report::Figure loop_friction_figure(const IdentificationStudy& study);

nlohmann::ordered_json loop_json(const LoopFindings& findings);

/// A row per cycle, SI units in the header.
std::string loops_csv(const IdentificationStudy& study);

}  // namespace tricontact::experiments

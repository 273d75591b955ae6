#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "report/document.h"
#include "rolling/creep_theory.h"
#include "rolling/rolling_report.h"

namespace tricontact::rolling {

/// The report of a case that rolls on.
report::Document rolling_document(const RollingReport& report);

/// "models", "theories" and "creep_ratio" of summary.json (docs/how-to/rolling.md); SI units.
nlohmann::ordered_json rolling_json(const RollingReport& report);

/// The transient of one model, a row per step, SI units; the last row, of infinite distance left
/// empty, is the steady state.
std::string history_csv(const RollingRun& run);

/// Creep curves of all models and theories: steady states, force ratio over creepage. Theories
/// stand at the same creepages as the first model that has a curve.
std::string creep_csv(const RollingReport& report);

/// The steady state of each model; the same in summary.json.
report::DocumentTable steady_table(const RollingReport& report);

/// Closed forms at the first model's creepage the force ratio, else at its force the creepage,
/// empty where it slides; none where something else drives, too.
std::vector<std::pair<CreepTheory, std::optional<double>>> theory_values(
    const RollingReport& report);
/// These, and what they are over each model's.
report::DocumentTable theory_table(const RollingReport& report);

/// Both tables for the terminal.
std::string steady_text(const RollingReport& report);

/// Both tables.
report::DocumentSection steady_section(const RollingReport& report);

/// What a relaxing substrate resists, beside closed forms; empty of elastic ones.
report::DocumentSection resistance_section(const RollingReport& report);

/// What the temperatures of a run rest on; heat flows into the depth alone.
struct HeatNumbers {
    double peclet_indenter = 0, peclet_substrate = 0;  ///< of the steady contact [-]
    double substrate_share = 0;  ///< of the heat of friction, into the substrate [-]
    double band_error = 0;       ///< theory::band_error at the smaller Pe [-]
};
/// Empty where the case states no heat.
std::optional<HeatNumbers> heat_numbers(const RollingReport& report, const RollingRun& run);
/// What the report says of them; empty likewise.
std::string heat_sentence(const RollingReport& report, const RollingRun& run);
/// What is stated of both bodies.
std::vector<std::pair<std::string, std::string>> heat_settings(const RollingReport& report);
/// Highest temperatures, and those on the warmest row, a figure per model; empty likewise.
report::DocumentSection heat_section(const RollingReport& report);

/// From rest to steady rolling: what follows of creepage and force over the rolled way, and the
/// tractions on the centre line, a figure per model.
report::DocumentSection transient_section(const RollingReport& report);

/// Force over creepage of models and theories; empty figures where no curve was computed.
report::DocumentSection creep_section(const RollingReport& report);

/// Zones of stick and slip with the slip's direction, a figure per model on a grid.
report::DocumentSection zones_section(const RollingReport& report);

}  // namespace tricontact::rolling

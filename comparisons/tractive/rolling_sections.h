#pragma once

#include "comparisons/document.h"
#include "comparisons/tractive/rolling_report.h"

namespace tricontact::comparisons::tractive {

/// The steady state of each model as a table.
DocumentSection steady_section(const RollingReport& report);

/// What a relaxing substrate resists, beside closed forms; empty of elastic ones.
DocumentSection resistance_section(const RollingReport& report);

/// From rest to steady rolling: what follows of creepage and force over the rolled way, and the
/// tractions on the centre line, a figure per model.
DocumentSection transient_section(const RollingReport& report);

/// Force over creepage of models and theories; empty figures where no curve was computed.
DocumentSection creep_section(const RollingReport& report);

/// Zones of stick and slip with the slip's direction, a figure per model on a grid.
DocumentSection zones_section(const RollingReport& report);

}  // namespace tricontact::comparisons::tractive

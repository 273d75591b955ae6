#pragma once

#include <span>
#include <string>
#include <string_view>
#include <variant>

#include "contact/history.h"
#include "contact/rig_stiffness.h"

namespace tricontact::io {

/// A quantity of every step, named with its unit as in history.csv, and where a record has it.
struct HistoryColumn {
    std::string_view name;
    std::variant<const double*, const int*> (*place)(const contact::StepRecord&);
};

/// In the order of the file.
std::span<const HistoryColumn> history_columns();

/// What the drive of a rig that yields does in a step [m].
struct DriveColumn {
    std::string_view name;
    double (*value)(const contact::RigStiffness& rig, const contact::StepRecord& step);
};

/// Behind the others where the rig yields.
std::span<const DriveColumn> drive_columns();

/// Every step as a line of comma-separated values; units stand in the column names, numbers have
/// the shortest digits that read back the same.
/// The columns of the drive stand behind the others where the rig yields.
std::string history_csv(const contact::History& history);

}  // namespace tricontact::io

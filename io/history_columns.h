#pragma once

#include <span>
#include <string_view>
#include <variant>

#include "contact/history.h"

namespace tricontact::io {

/// A quantity of every step, named with its unit as in history.csv, and where a record has it.
struct HistoryColumn {
    std::string_view name;
    std::variant<const double*, const int*> (*place)(const contact::StepRecord&);
};

/// In the order of the file.
std::span<const HistoryColumn> history_columns();

}  // namespace tricontact::io

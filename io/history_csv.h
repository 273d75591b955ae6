#pragma once

#include <string>

#include "contact/history.h"

namespace tricontact::io {

/// Every step as a line of comma-separated values; units stand in the column names, numbers have
/// the shortest digits that read back the same.
std::string history_csv(const contact::History& history);

}  // namespace tricontact::io

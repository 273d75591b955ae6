#pragma once

#include <initializer_list>
#include <string>

#include "app/options.h"

namespace tricontact::app {

/// Says which parts of a case file this command does not read, and which commands do: sections of a
/// rig and stated uncertainties (io::rig_parts). `read`: those that it reads.
void say_unread_parts(const CommandOptions& options, const std::string& command,
                      std::initializer_list<std::string> read = {});

}  // namespace tricontact::app

#pragma once

#include <string>

#include "runs/options.h"

namespace tricontact::io {
struct Study;
}  // namespace tricontact::io

namespace tricontact::runs {

/// Says which parts of its case file (io::rig_parts) a command has not read, and which commands do.
void say_unread_parts(const CommandOptions& options, const std::string& command);

/// The same of the case of a study: a command on studies reads none of these parts.
void say_unread_parts(const CommandOptions& options, const io::Study& study,
                      const std::string& command);

}  // namespace tricontact::runs

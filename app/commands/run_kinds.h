#pragma once

#include "runs/case_run.h"

// What `run` does with the kinds of cases that there are; run_command.cc tells them apart.
namespace tricontact::app {

struct RunCommandOptions : runs::RunOptions {
    int points = 12;  ///< of the creep curve of a case that rolls on; 0: none
};

/// From rest to steady rolling.
void run_rolling_on(const Case& c, RunCommandOptions options);

/// A contact that wears.
void run_wear(const Case& c, RunCommandOptions options);

/// The micro-walking machine.
void run_walking(RunCommandOptions options);

}  // namespace tricontact::app

#pragma once

#include <string>
#include <vector>

#include "contact/case.h"

namespace tricontact::comparisons {

/// What the case has and the model computes without, each as "key: what it takes instead"; empty if
/// nothing. What the case itself switches off, such as coupling, is not left out.
std::vector<std::string> left_out(const contact::Case& c, const std::string& model);

/// The same of several models, a line each: "bem leaves out substrate.thickness: ...".
std::string left_out_lines(const contact::Case& c, const std::vector<std::string>& models);

}  // namespace tricontact::comparisons

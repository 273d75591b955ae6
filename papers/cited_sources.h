#pragma once

#include <map>
#include <string>
#include <vector>

#include "report/bibliography.h"

namespace tricontact::papers {

/// Sources that the reports cite, and those of the models, quantities, theories and statistics that
/// reports and numbers, files by their names in an archive, show to be in use.
report::Sources cited_sources(const std::vector<report::Document>& documents,
                              const std::map<std::string, std::string>& numbers);

}  // namespace tricontact::papers

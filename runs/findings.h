#pragma once

#include <memory>
#include <set>
#include <string>
#include <vector>

#include "report/document.h"

namespace tricontact::runs {

/// What a command came to, for papers: its reports, and where its numbers are.
struct Findings {
    std::vector<report::Document> documents;
    std::string folder;           ///< of the command
    std::set<std::string> files;  ///< names of what it may have written there
    bool draws = true;            ///< also the pictures beside a report, which need gnuplot
};

/// What --export asks of a command.
struct PaperWishes {
    std::string folder;                            ///< of figures, tables, archive; empty: none
    const char* filled_by = "";                    ///< command that fills its folder before
    std::shared_ptr<Findings> findings = nullptr;  ///< null: nobody asks
};

}  // namespace tricontact::runs

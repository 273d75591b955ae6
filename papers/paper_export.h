#pragma once

#include <functional>
#include <map>
#include <string>

#include "runs/options.h"

namespace CLI {
class App;
}  // namespace CLI

namespace tricontact::papers {

using runs::CommandOptions;
using runs::Findings;

/// The numbers of a command, by their names in an archive: JSON and CSV files of its results, data
/// of the figures and tables of its reports.
std::map<std::string, std::string> numbers_of(const Findings& findings);

/// Runs a command, `call`, whose options `parser` has read, and writes what a paper needs of it
/// into the folder of --export: figures/ID.pdf, .svg and .png with data/ID.csv, tables/ID.tex,
/// references.bib and archive.zip, from which the command runs again. Gives what the command gives;
/// where it fails nothing is exported. Throws contact::InputError.
int run_for_papers(const CLI::App& parser, CommandOptions& options,
                   const std::function<int()>& call);

}  // namespace tricontact::papers

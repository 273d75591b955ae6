#pragma once

#include <string>
#include <vector>

#include "benchmarks/problems/problem.h"
#include "benchmarks/reference/reference.h"

// What is told of the problems of the catalogue: on the terminal, as a page in Markdown, as JSON.
namespace tricontact::benchmarks {

/// What is said of a problem beside the catalogue's data.
struct ProblemFindings {
    const Reference* reference = nullptr;  ///< null: none was computed
    std::string no_reference = {};         ///< why not: one sentence, or empty
};

/// Lines of a table: name, group, decks, what is tested.
std::string catalogue_text(const std::vector<const Problem*>& problems);
/// The index of the pages, Markdown; links are relative to the folder of reference documents.
std::string catalogue_markdown(const std::vector<const Problem*>& problems);
/// A list of objects without the texts.
std::string catalogue_json(const std::vector<const Problem*>& problems);

/// The page of a problem, lines of 100 characters.
std::string problem_text(const Problem& problem, const ProblemFindings& findings);
/// The same as a document of docs/reference/benchmarks.
std::string problem_markdown(const Problem& problem, const ProblemFindings& findings);
std::string problem_json(const Problem& problem, const ProblemFindings& findings);

}  // namespace tricontact::benchmarks

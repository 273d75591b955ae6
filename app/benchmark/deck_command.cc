#include "app/benchmark/benchmark_case.h"
#include "app/commands/command.h"
#include "benchmarks/decks/closed_decks.h"
#include "benchmarks/decks/deck.h"
#include "benchmarks/problems/problem.h"

namespace tricontact::app {

namespace {

struct DeckOptions : CommandOptions {
    std::string problem;
    std::string code, elements;
    int levels = 0;
    bool is_spatial = false;
};

benchmarks::DeckWishes wishes_of(const DeckOptions& options, const std::string& problem) {
    return {.code = options.code,
            .elements = options.elements,
            .levels = options.levels,
            .problem = problem,
            .is_spatial = options.is_spatial};
}

std::vector<benchmarks::DeckFile> files_of(const BenchmarkCase& found, const DeckOptions& options) {
    const auto reference = reference_of_case(found.c, options.threads, options.sayer());
    auto files = benchmarks::write_deck(reference, wishes_of(options, found.name));
    // The submission names the case by its file beside it.
    if (!found.text.empty()) files.push_back({found.name + ".toml", io::write_case(found.c)});
    return files;
}

/// Writes inputs of a family of meshes for a code, with the submission file that its results go
/// into.
void write_deck_files(DeckOptions options) {
    const benchmarks::Problem* problem = benchmarks::find_problem(options.problem);
    std::vector<benchmarks::DeckFile> files;
    if (problem && benchmarks::has_closed_deck(problem->name)) {
        options.file = problem->name + ".toml";
        files = benchmarks::write_closed_deck(wishes_of(options, problem->name));
    } else {
        const BenchmarkCase found = benchmark_case(options.problem);
        options.file = found.name + ".toml";
        files = files_of(found, options);
    }
    options.choose_folder('_' + options.code);
    io::OutputNames names;
    for (const auto& file : files) names.results.push_back(file.name);
    options.fill(names, [&] {
        for (const auto& file : files) options.write(file.name, file.text);
    });
    for (const auto& file : files)
        if (file.name == "README.txt") options.out() << file.text;
    options.out() << fmt::format("written: {} files in {}\n", files.size(), options.output);
}

}  // namespace

Command benchmark_deck_command() {
    return Declared<DeckOptions>(
               Group::trust, "benchmark deck",
               "Write inputs of a problem for a contact code, in a family of meshes",
               write_deck_files)
        .required("problem", &DeckOptions::problem, "Name of the problem, or a case file", "NAME")
        .required("--code", &DeckOptions::code, "The code; mesh: meshes alone, for any other", "")
        .one_of({"calculix", "abaqus", "freefem", "getfem", "mesh"})
        .option("--elements", &DeckOptions::elements,
                "Elements of the code (its usual ones): CAX8R, CAX4, P1, P2, Q1, Q2 ...", "NAME")
        .number("--levels", &DeckOptions::levels,
                "Meshes, each twice as fine as the one before (4; half models 3)", 1, 8)
        .flag("--half", &DeckOptions::is_spatial,
              "A half model in three dimensions, also where the case is axisymmetric")
        .output("Folder (results/<problem>_<code>)")
        .quiet();
}

}  // namespace tricontact::app

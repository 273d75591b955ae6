#include <filesystem>

#include "app/benchmark/benchmark_case.h"
#include "app/commands/command.h"
#include "benchmarks/decks/deck.h"

namespace tricontact::app {

namespace {

struct DeckOptions : CommandOptions {
    std::string problem;
    std::string code, elements;
    int levels = 0;
    bool is_spatial = false;
};

/// Writes inputs of a family of meshes for a code, with the submission file that its results go
/// into.
void write_deck_files(DeckOptions options) {
    const BenchmarkCase found = benchmark_case(options.problem);
    options.file = found.name + ".toml";
    options.choose_folder('_' + options.code);
    const auto reference = benchmarks::reference(found.c, options.runner());
    auto files = benchmarks::write_deck(reference, {.code = options.code,
                                                    .elements = options.elements,
                                                    .levels = options.levels,
                                                    .problem = found.name,
                                                    .is_spatial = options.is_spatial});
    // The submission names the case by its file beside it.
    if (!found.text.empty()) files.push_back({found.name + ".toml", io::write_case(found.c)});
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
        .required("--code", &DeckOptions::code, "The code", "")
        .one_of({"calculix", "abaqus", "freefem", "getfem"})
        .option("--elements", &DeckOptions::elements,
                "Elements of the code (its usual ones): CAX8R, CAX4, P1, P2, Q1, Q2 ...", "NAME")
        .number("--levels", &DeckOptions::levels,
                "Meshes, each twice as fine as the one before (4; half models 3)", 1, 8)
        .flag("--half", &DeckOptions::is_spatial,
              "A half model in three dimensions, also where the case is axisymmetric")
        .output("Folder (results/<problem>_<code>)");
}

}  // namespace tricontact::app

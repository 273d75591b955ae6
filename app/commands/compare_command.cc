#include <nlohmann/json.hpp>

#include "app/commands/command.h"
#include "comparisons/differences/results_folder.h"

namespace tricontact::app {

namespace {

struct CompareOptions : CommandOptions {
    std::string other;  ///< the second folder
};

std::string folder_of(std::string path) {
    while (path.size() > 1 && path.ends_with('/')) path.pop_back();
    return path;
}

/// Two folders of results side by side: compare.json, the report, fields for ParaView, and tables
/// on standard output.
void compare_results(CompareOptions options) {
    options.file = folder_of(options.file);
    options.other = folder_of(options.other);
    const auto comparison =
        comparisons::compare_folders(comparisons::read_results_folder(options.file),
                                     comparisons::read_results_folder(options.other));
    options.choose_folder("_compared");
    io::OutputNames names{{"compare.json", "report.html"}};
    const auto file_of = [](const comparisons::RunPair& pair) {
        return "difference_" + pair.id() + ".vti";
    };
    for (const auto& pair : comparison.pairs)
        if (pair.last) names.results.push_back(file_of(pair));
    const std::string command = "tricontact compare " + options.file + ' ' + options.other;
    options.fill(names, [&] {
        options.write("compare.json",
                      comparisons::folder_json(files::version, comparison).dump(2) + '\n');
        report::Document document = comparisons::folder_document(comparison);
        for (const auto& pair : comparison.pairs) {
            if (!pair.last) continue;
            options.write(file_of(pair),
                          comparisons::difference_vtk(*pair.last, {files::version, command}).bytes);
            document.files.emplace_back("fields of " + pair.id() + " for ParaView", file_of(pair));
        }
        options.write_report(document, command);
    });
    options.answer(
        Answer([&] { return comparisons::folder_json(files::version, comparison).dump(2); },
               comparisons::folder_text(comparison)));
    options.say(options.where());
}

}  // namespace

Command compare_command() {
    return Declared<CompareOptions>(Group::trust, "compare",
                                    "Two folders of results of run side by side: quantities, "
                                    "histories, fields",
                                    compare_results)
        .on_file("a", "Folder of results", "A")
        .required("b", &CompareOptions::other, "Folder of results to compare it with", "B")
        .output("Folder (results/<A>_compared)")
        .exports()
        .json()
        .quiet();
}

}  // namespace tricontact::app

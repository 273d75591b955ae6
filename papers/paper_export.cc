#include "papers/paper_export.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <filesystem>
#include <stdexcept>

#include "files/regular_file.h"
#include "papers/archive.h"
#include "papers/archived_arguments.h"
#include "papers/cited_sources.h"
#include "papers/input_places.h"
#include "report/bibliography.h"
#include "report/document_csv.h"
#include "report/gnuplot.h"
#include "report/latex.h"
#include "report/paper_figure.h"

namespace tricontact::papers {

namespace {

namespace fs = std::filesystem;

constexpr const char* archive_name = "archive.zip";
constexpr const char* references_name = "references.bib";
constexpr std::uint64_t most_bytes = 500'000'000;  // of a file with numbers

io::OutputNames paper_names() {
    return {{references_name, archive_name}, {"figures/", "data/", "tables/"}};
}

std::vector<const report::DocumentTable*> tables_of(const report::Document& document) {
    std::vector<const report::DocumentTable*> tables;
    if (document.comparison) tables.push_back(&*document.comparison);
    for (const auto& section : document.sections)
        for (const auto& table : section.tables) tables.push_back(&table);
    return tables;
}

/// Folders of results that the command was given.
std::vector<std::string> folders_of(const CLI::App& parser) {
    std::vector<std::string> folders;
    for (const CLI::Option* option : parser.get_options()) {
        if (!option->get_positional()) continue;
        for (const std::string& path : option->results())
            if (fs::is_directory(path)) folders.push_back(path);
    }
    return folders;
}

Call call_of(const CLI::App& parser, const InputPlaces& places) {
    Call call{parser.get_name(), archived_arguments(parser)};
    for (std::string& argument : call.arguments) argument = places.argument(argument);
    return call;
}

Archive archive_of(const CLI::App& parser, const CommandOptions& options,
                   const InputPlaces& places) {
    Archive archive = new_archive();
    archive.files = places.files();
    const std::string filled_by = options.papers.filled_by;
    if (!filled_by.empty()) archive.calls.push_back({filled_by, {places.argument(options.file)}});
    archive.calls.push_back(call_of(parser, places));
    const std::string name = options.papers.folder + '/' + archive_name;
    check_inside(name, archive.files);
    for (const Call& call : archive.calls)
        check_archived_arguments(parser, name, archive.files, call.arguments);
    for (const auto& [file, text] : numbers_of(*options.papers.findings))
        archive.files[file] = places.in_places(text);
    const std::string resolved = options.papers.findings->folder + '/' + runs::resolved_case_name;
    if (options.papers.findings->files.contains(runs::resolved_case_name) && fs::exists(resolved))
        archive.files[runs::resolved_case_name] =
            places.in_places(files::RegularFile(resolved).content(most_bytes));
    return archive;
}

/// Drawings, data and tables that an earlier export left; what others put there stays.
void remove_old_papers(const std::string& folder) {
    std::error_code ignored;
    std::vector<std::string> drawings;
    for (const auto& entry : fs::directory_iterator(folder + "/figures", ignored))
        if (entry.path().extension() == ".svg") drawings.push_back(entry.path().stem().string());
    for (const std::string& id : drawings) {
        fs::remove(folder + "/data/" + id + ".csv", ignored);
        for (const char* ending : {".pdf", ".png", ".svg"})
            fs::remove(folder + "/figures/" + id + ending, ignored);
    }
    std::vector<fs::path> tables;
    for (const auto& entry : fs::directory_iterator(folder + "/tables", ignored))
        if (io::first_bytes(entry.path().string(), std::string(report::latex_mark).size()) ==
            report::latex_mark)
            tables.push_back(entry.path());
    for (const fs::path& table : tables) fs::remove(table, ignored);
}

using Files = std::map<std::string, std::string>;  // contents by names

void add(const report::Document& document, Files& files) {
    report::check_document(document);
    const std::vector<report::Figure> figures = report::figures_of(document);
    std::vector<report::PaperDrawing> drawings = report::draw_for_papers(figures);
    for (std::size_t i = 0; i < figures.size(); ++i) {
        const std::string drawing = "figures/" + figures[i].id;
        files[drawing + ".pdf"] = std::move(drawings[i].pdf);
        files[drawing + ".png"] = std::move(drawings[i].png);
        files[drawing + ".svg"] = std::move(drawings[i].svg);
        files["data/" + figures[i].id + ".csv"] = report::figure_csv(figures[i]);
    }
    const std::string provenance = "tricontact " + document.version + ": " + document.command;
    for (const report::DocumentTable* table : tables_of(document))
        files["tables/" + table->id + ".tex"] = report::latex_table(*table, provenance);
}

Files paper_files(const Findings& findings, const Archive& archive) {
    Files files;
    for (const report::Document& document : findings.documents) add(document, files);
    files[references_name] = report::bibtex(cited_sources(findings.documents, archive.numbers()),
                                            tricontact::files::version, TRICONTACT_RELEASED);
    files[archive_name] = archive_text(archive);
    return files;
}

}  // namespace

std::map<std::string, std::string> numbers_of(const Findings& findings) {
    std::map<std::string, std::string> numbers;
    for (const std::string& name : findings.files) {
        const std::string path = findings.folder + '/' + name;
        if ((name.ends_with(".json") || name.ends_with(".csv")) && fs::exists(path))
            numbers["results/" + name] = files::RegularFile(path).content(most_bytes);
    }
    for (const report::Document& document : findings.documents) {
        for (const report::Figure& figure : report::figures_of(document))
            numbers["figures/" + figure.id + ".csv"] = report::figure_csv(figure);
        for (const report::DocumentTable* table : tables_of(document))
            numbers["tables/" + table->id + ".csv"] = report::table_csv(*table);
    }
    return numbers;
}

int run_for_papers(const CLI::App& parser, CommandOptions& options,
                   const std::function<int()>& call) {
    if (!options.report)
        throw contact::InputError(
            "--export: its figures and tables are those of the report; drop --no-report");
    const std::string& folder = options.papers.folder;
    // Before anything is computed.
    io::OutputFolder papers(folder, paper_names());
    report::require_gnuplot();
    const io::InputLog inputs;
    options.papers.findings = std::make_shared<Findings>();
    if (const int code = call(); code != 0) return code;
    const Archive archive =
        archive_of(parser, options, InputPlaces(inputs.files(), folders_of(parser)));
    const Files files = paper_files(*options.papers.findings, archive);
    papers.fill([&] {
        remove_old_papers(folder);
        for (const char* name : {"/figures", "/data", "/tables"})
            io::make_output_folder(folder + name);
        for (const auto& [name, content] : files) io::write_file(folder + '/' + name, content);
    });
    options.say("export: " + folder);
    return 0;
}

}  // namespace tricontact::papers

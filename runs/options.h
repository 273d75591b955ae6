#pragma once

#include <functional>
#include <iostream>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "contact/base/error.h"
#include "contact/case.h"
#include "contact/model_makers.h"
#include "files/version.h"
#include "io/results/atomic_file.h"
#include "io/results/output_folder.h"
#include "io/results/progress.h"
#include "report/document.h"
#include "runs/answer.h"
#include "runs/findings.h"

namespace tricontact::runs {

using contact::Case;
using contact::Say;
using contact::silent;

/// Who hears what a command tells, instead of the terminal.
struct Listener {
    std::ostream* out;  ///< the answer
    Say say;            ///< a line about what goes on
    /// How many of how many steps of what is called so are done.
    std::function<void(const std::string& name, int done, int total)> progress;
};

/// Name of the resolved case beside its results.
inline constexpr const char* resolved_case_name = "case.toml";

/// What commands have in common, each some of it; and what all do with it.
struct CommandOptions {
    std::string file;                    ///< what the command works on: case, study, data
    std::vector<std::string> overrides;  ///< key=value
    /// Of a command that takes a case file: parts of it, as of io::rig_parts, that it reads.
    std::optional<std::vector<std::string>> reads = {};
    std::string output;               ///< folder or file; empty: results/<name of the file>
    std::vector<std::string> models;  ///< empty: those of the case
    int threads = 1;                  ///< or processes side by side
    bool quiet = false;
    bool json = false;                                   ///< the answer as JSON
    bool report = true;                                  ///< write report.html
    std::vector<std::string> given = {};                 ///< names of the options of this call
    std::shared_ptr<const Listener> listener = nullptr;  ///< null: the terminal
    PaperWishes papers = {};
    const contact::ModelMakers* makers = nullptr;  ///< of the program, which sets them

    /// The program's models on `threads`.
    contact::ModelRunner runner() const { return {*makers, threads}; }

    /// For the answer: standard output.
    std::ostream& out() const { return listener ? *listener->out : std::cout; }
    void answer(const Answer& found) const { out() << found.printed(json); }
    /// A line on standard error, unless quiet.
    void say(const std::string& line) const {
        if (!quiet) listener ? listener->say(line) : void(std::cerr << line << '\n');
    }
    /// How far the work called `name` is, on standard error, unless quiet.
    io::ProgressBar progress_bar(const std::string& name, const std::string& noun = "step") const {
        using Bar = io::ProgressBar;
        const auto style = listener ? Bar::Style::silent : Bar::style_of_stderr(quiet);
        Bar bar(std::cerr, style, name, {}, noun);
        if (listener && !quiet)
            bar.watch(
                [to = listener, name](int done, int total) { to->progress(name, done, total); });
        return bar;
    }
    Say sayer() const {
        return [this](const std::string& line) { say(line); };
    }
    /// Decides the folder of the output: as given, or results/<name of the file><suffix>.
    void choose_folder(const std::string& suffix = "") {
        output = io::output_folder(output, file, suffix);
    }
    /// Throws contact::InputError that says what is wrong with the file.
    [[noreturn]] void refuse(const std::string& what) const {
        throw contact::InputError(file + ": " + what);
    }
    /// What `work` gives; what it finds wrong with its input is said of the file.
    template <class Work>
    auto told_of_file(const Work& work) const {
        try {
            return work();
        } catch (const contact::InputError& error) {
            refuse(error.what());
        }
    }
    /// Checks that folder and does the work that fills it (io::OutputFolder).
    void fill(io::OutputNames names, const std::function<void()>& work) const {
        if (papers.findings) {
            papers.findings->folder = output;
            papers.findings->files = {names.results.begin(), names.results.end()};
            papers.findings->files.insert(names.kept.begin(), names.kept.end());
        }
        io::OutputFolder(output, std::move(names)).fill(work);
    }
    /// Writes a file of that folder.
    void write(const std::string& name, const std::string& text) const {
        io::write_file(output + '/' + name, text);
    }
    /// Writes report.html there, made by this version of the program.
    void write_report(report::Document document, const std::string& command,
                      const std::string& name = "report.html") const {
        document.command = command;
        document.version = files::version;
        keep_report(document);
        write(name, report::document_html(document));
    }
    /// What write_report does for papers, of a report that is written otherwise.
    void keep_report(const report::Document& document) const {
        if (papers.findings) papers.findings->documents.push_back(document);
    }
    /// "report: out/report.html", or "results: out" where none is written.
    std::string where() const {
        return report ? "report: " + output + "/report.html" : "results: " + output;
    }
};

struct RunOptions : CommandOptions {
    bool studies = true;  ///< what needs further runs: other ways of loading, the elastic substrate
};

}  // namespace tricontact::runs

#pragma once

#include <functional>
#include <iostream>
#include <string>
#include <vector>

#include "contact/case.h"
#include "contact/error.h"
#include "files/version.h"
#include "io/results/atomic_file.h"
#include "io/results/output_folder.h"
#include "report/document.h"

namespace tricontact::app {

using contact::Case;

/// Receives a line about what a model decided or reused.
using Say = std::function<void(const std::string&)>;
inline const Say silent = [](const std::string&) {};

/// Name of the resolved case beside its results.
inline constexpr const char* resolved_case_name = "case.toml";

/// What commands have in common, each some of it; and what all do with it.
struct CommandOptions {
    std::string file;                    ///< what the command works on: case, study, data
    std::vector<std::string> overrides;  ///< key=value
    std::string output;                  ///< folder or file; empty: results/<name of the file>
    std::vector<std::string> models;     ///< empty: those of the case
    int threads = 1;                     ///< or processes side by side
    bool quiet = false;
    bool report = true;  ///< write report.html

    /// A line on standard error, unless quiet.
    void say(const std::string& line) const {
        if (!quiet) std::cerr << line << '\n';
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
        io::OutputFolder(output, std::move(names)).fill(work);
    }
    /// Writes a file of that folder.
    void write(const std::string& name, const std::string& text) const {
        io::write_file(output + '/' + name, text);
    }
    /// Writes report.html there, made by this version of the program.
    void write_report(report::Document document, const std::string& command) const {
        document.command = command;
        document.version = files::version;
        write("report.html", report::document_html(document));
    }
    /// "report: out/report.html", or "results: out" where none is written.
    std::string where() const {
        return report ? "report: " + output + "/report.html" : "results: " + output;
    }
};

}  // namespace tricontact::app

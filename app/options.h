#pragma once

#include <functional>
#include <string>
#include <vector>

#include "contact/error.h"
#include "io/results/output_folder.h"
#include "report/document.h"

namespace tricontact::app {

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
    void say(const std::string& line) const;
    Say sayer() const {
        return [this](const std::string& line) { say(line); };
    }
    /// Decides the folder of the output: as given, or results/<name of the file><suffix>.
    void choose_folder(const std::string& suffix = "");
    /// What `work` gives; what it finds wrong with its input is said of the file.
    template <class Work>
    auto told_of_file(const Work& work) const {
        try {
            return work();
        } catch (const contact::InputError& error) {
            throw contact::InputError(file + ": " + error.what());
        }
    }
    /// Checks that folder and does the work that fills it (io::OutputFolder).
    void fill(io::OutputNames names, const std::function<void()>& work) const;
    /// Writes a file of that folder.
    void write(const std::string& name, const std::string& text) const;
    /// Writes report.html there, made by this version of the program.
    void write_report(report::Document document, const std::string& command) const;
    /// "report: out/report.html", or "results: out" where none is written.
    std::string where() const;
};

}  // namespace tricontact::app

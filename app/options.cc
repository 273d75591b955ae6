#include "app/options.h"

#include <iostream>
#include <utility>

#include "files/version.h"
#include "io/results/atomic_file.h"

namespace tricontact::app {

void CommandOptions::say(const std::string& line) const {
    if (!quiet) std::cerr << line << '\n';
}

void CommandOptions::choose_folder(const std::string& suffix) {
    output = io::output_folder(output, file, suffix);
}

void CommandOptions::fill(io::OutputNames names, const std::function<void()>& work) const {
    io::OutputFolder(output, std::move(names)).fill(work);
}

void CommandOptions::write(const std::string& name, const std::string& text) const {
    io::write_file(output + '/' + name, text);
}

void CommandOptions::write_report(report::Document document, const std::string& command) const {
    document.command = command;
    document.version = files::version;
    write("report.html", report::document_html(document));
}

std::string CommandOptions::where() const {
    return report ? "report: " + output + "/report.html" : "results: " + output;
}

}  // namespace tricontact::app

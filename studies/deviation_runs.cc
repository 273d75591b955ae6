#include "studies/deviation_runs.h"

#include <fmt/format.h>

#include "io/case/case_reader.h"

namespace tricontact::studies {

StudyPoint deviation_point(const contact::Case& c, int level, const std::string& file) {
    const contact::Case checked = io::parse_case(io::write_case(c), file);
    return make_point(checked, checked.models.front(), level, file);
}

std::vector<std::optional<comparisons::Results>> deviation_results(
    const runs::CommandOptions& options, const StudyPoints& points) {
    io::ResultStore store = open_results(options.output);
    compute_missing(contact_kind(), points, store, {.name = "deviation", .options = options});
    std::vector<std::optional<comparisons::Results>> results;
    for (const StudyPoint& point : points) results.push_back(results_of(store.find(point.key)));
    return results;
}

std::string deviation_command(const runs::CommandOptions& options) {
    std::string command = "tricontact deviation " + options.file;
    for (const std::string& text : options.overrides) command += fmt::format(" --set \"{}\"", text);
    return command;
}

}  // namespace tricontact::studies

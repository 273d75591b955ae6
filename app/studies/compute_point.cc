#include "app/studies/compute_point.h"

#include <exception>
#include <new>
#include <nlohmann/json.hpp>

#include "app/case_run.h"
#include "app/run_model.h"
#include "files/version.h"
#include "io/case/case_writer.h"
#include "io/results/atomic_file.h"

namespace tricontact::app {

namespace {

using json = nlohmann::ordered_json;

std::string folder_of(const SweepPoint& point) {
    return "points/" + point.key;
}

contact::History history_with_files(const SweepPoint& point, const std::string& folder) {
    contact::Case c = point.c;
    c.output = point.output;
    const std::string text = io::write_case(c);
    RunOptions options;
    options.output = folder + '/' + folder_of(point);
    options.quiet = true;
    io::make_output_folder(options.output);
    io::write_file(options.output + '/' + resolved_case_name, text);
    return run_model(point.model, c, text, options);
}

json computed(const SweepPoint& point, const std::string& folder) {
    const contact::History history =
        folder.empty() ? history_of(point.model, point.c, 1, [](const std::string&) {})
                       : history_with_files(point, folder);
    return {{"results", comparisons::stored_results({point.c, history})},
            {"cpu_s", history.cpu_s},
            {"wall_s", history.wall_s}};
}

}  // namespace

std::string surface_file(const SweepPoint& point) {
    return folder_of(point) + '/' + point.model + "/surface.pvd";
}

std::string compute_point(const SweepPoint& point, const std::string& folder) noexcept {
    const auto failed = [](const char* what) {
        return json{{"error", what}}.dump(-1, ' ', false, json::error_handler_t::replace);
    };
    try {
        return computed(point, folder).dump();
    } catch (const std::bad_alloc&) {
        return failed("not enough memory; use fewer --jobs or a coarser resolution");
    } catch (const std::exception& error) {
        return failed(error.what());
    }
}

comparisons::Results results_of(const io::PointOutcome& outcome) {
    return comparisons::read_stored_results(json::parse(*outcome.results));
}

io::PointOutcome outcome_of(const SweepPoint& point, const WorkerReport& report) {
    io::PointOutcome outcome{.key = point.key,
                             .version = files::version,
                             .model = point.model,
                             .resolved = point.resolved};
    if (!report.failure.empty()) {
        outcome.error = report.failure;
        if (report.killed) *outcome.error += "; perhaps for want of memory";
        return outcome;
    }
    const json line = json::parse(report.text);
    if (line.contains("error")) {
        outcome.error = line.at("error").get<std::string>();
        return outcome;
    }
    outcome.results = line.at("results").dump();
    outcome.cpu_s = line.at("cpu_s").get<double>();
    outcome.wall_s = line.at("wall_s").get<double>();
    return outcome;
}

}  // namespace tricontact::app

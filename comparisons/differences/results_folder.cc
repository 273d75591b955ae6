#include "comparisons/differences/results_folder.h"

#include <fmt/format.h>

#include <filesystem>

#include "io/keys/input_file.h"
#include "io/keys/json_text.h"
#include "io/keys/messages.h"
#include "io/tables/csv_table.h"

namespace tricontact::comparisons {

namespace {

using json = nlohmann::ordered_json;
namespace fs = std::filesystem;

constexpr const char* remedy = "give a folder that tricontact run has filled";

bool is_file(const std::string& path) {
    std::error_code ignored;
    return fs::is_regular_file(path, ignored);
}

json read_summary(const std::string& path) {
    const json summary = io::parsed_json(io::read_input_file(path, "summary of a run", 64));
    const bool is_sound = summary.is_object() && summary.contains("models") &&
                          summary["models"].is_object() && !summary["models"].empty() &&
                          summary.contains("case") && summary["case"].is_object();
    if (!is_sound) io::fail(path, "", "has no case and no models", remedy);
    return summary;
}

std::map<std::string, double> half_widths_of(const json& summary, const std::string& model) {
    std::map<std::string, double> widths;
    const auto error = summary.find("numerical_error");
    if (error == summary.end() || !error->is_object() || error->value("model", "") != model)
        return widths;
    const auto list = error->find("half_widths");
    if (list == error->end() || !list->is_object()) return widths;
    for (const auto& [key, width] : list->items())
        if (width.is_number()) widths[key] = width.get<double>();
    return widths;
}

std::map<std::string, std::vector<double>> read_history(const std::string& path) {
    std::map<std::string, std::vector<double>> columns;
    if (!is_file(path)) return columns;
    const io::CsvTable table =
        io::read_csv_table(path, {.kind = "history",
                                  .header = "step, phase, shift_x_m",
                                  .most_rows = 1'000'000,
                                  .thinning = "compute the case with fewer steps",
                                  .most_mb = 512});
    for (const auto& column : table.columns()) columns[column.heading] = column.values;
    return columns;
}

}  // namespace

ResultsFolder read_results_folder(const std::string& path) {
    const std::string summary_path = path + "/summary.json";
    if (!is_file(summary_path)) io::fail(path, "", "has no summary.json", remedy);
    const json summary = read_summary(summary_path);
    ResultsFolder folder{
        .path = path, .version = summary.value("version", ""), .c = summary["case"], .runs = {}};
    for (const auto& [model, numbers] : summary["models"].items()) {
        if (!numbers.is_object() || fs::path(model) != fs::path(model).filename())
            io::fail(summary_path, model, "is no model of a run", remedy);
        const std::string of_model = path + '/' + model;
        SavedRun& run = folder.runs.emplace_back(SavedRun{model,
                                                          numbers,
                                                          half_widths_of(summary, model),
                                                          read_history(of_model + "/history.csv"),
                                                          {}});
        if (const std::string former = of_model + "/surface.pvd"; is_file(former))
            io::fail(former, "", "is of an earlier version, which wrote a file for each state",
                     "compute the case anew with tricontact run");
        if (const std::string series = of_model + "/surface.ex2"; is_file(series))
            run.surfaces = io::read_state_series(series);
    }
    return folder;
}

}  // namespace tricontact::comparisons

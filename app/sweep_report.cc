#include "app/sweep_report.h"

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>

#include "app/compute_point.h"
#include "app/study_axes.h"
#include "comparisons/format.h"

namespace tricontact::app {

namespace {

using comparisons::Sweep;

/// From the JSON text of point_results.
void read_results(const std::string& text, Sweep::Point& point) {
    constexpr std::pair<const char*, double Sweep::Point::*> numbers[] = {
        {"static_shift_ratio", &Sweep::Point::static_shift_ratio},
        {"final_shift_ratio", &Sweep::Point::final_shift_ratio},
        {"shift_increment_ratio", &Sweep::Point::shift_increment_ratio},
        {"kappa", &Sweep::Point::kappa},
        {"eta", &Sweep::Point::eta}};
    const auto results = nlohmann::json::parse(text);
    for (const auto& [name, member] : numbers)
        if (const auto found = results.find(name); found != results.end() && found->is_number())
            point.*member = found->get<double>();
    if (const auto found = results.find("state"); found != results.end() && found->is_string())
        point.state = found->get<std::string>();
}

Sweep::Point point_of(const SweepPoint& point, const io::ResultStore& store,
                      const std::string& folder) {
    Sweep::Point result{.values = {}, .model = point.model, .level = point.level};
    for (const std::string& value : point.values) result.values.push_back(cell_of(value));
    const auto outcome = store.find(point.key);
    if (outcome && outcome->results) read_results(*outcome->results, result);
    if (!outcome || outcome->error) result.error = outcome ? *outcome->error : "not computed";
    if (std::filesystem::exists(folder + '/' + surface_file(point)))
        result.surface = surface_file(point);
    return result;
}

}  // namespace

comparisons::Sweep sweep_of(const io::Study& study, const std::vector<SweepPoint>& points,
                            const io::ResultStore& store, const std::string& folder) {
    Sweep sweep{.title = study.title.empty() ? study.name : study.title,
                .settings = {{"case", study.base.name},
                             {"models", comparisons::display_names(study.models)}},
                .levels = study.levels,
                .axes = {},
                .points = {}};
    if (study.levels > 1) sweep.settings.emplace_back("levels", std::to_string(study.levels));
    for (const io::Entry& entry : study.settings)
        sweep.settings.emplace_back(entry.path, io::shown(entry.value));
    for (const io::Study::Axis& axis : study.axes) sweep.axes.push_back(axis_of(axis));
    for (const SweepPoint& point : points) sweep.points.push_back(point_of(point, store, folder));
    return sweep;
}

}  // namespace tricontact::app

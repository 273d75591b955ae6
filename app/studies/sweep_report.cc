#include "app/studies/sweep_report.h"

#include <filesystem>
#include <string>
#include <utility>

#include "app/studies/compute_point.h"
#include "app/studies/study_axes.h"
#include "report/format.h"

namespace tricontact::app {

namespace {

using comparisons::Sweep;

Sweep::Point point_of(const SweepPoint& point, const io::ResultStore& store,
                      const std::string& folder) {
    Sweep::Point result{.values = {}, .model = point.model, .level = point.level};
    for (const std::string& value : point.values) result.values.push_back(cell_of(value));
    const auto outcome = store.find(point.key);
    if (outcome && outcome->results) result.results = results_of(*outcome);
    if (!outcome || outcome->error) result.error = outcome ? *outcome->error : "not computed";
    if (std::filesystem::exists(folder + '/' + surface_file(point)))
        result.surface = surface_file(point);
    return result;
}

}  // namespace

comparisons::Sweep sweep_of(const io::Study& study, const std::vector<SweepPoint>& points,
                            const io::ResultStore& store, const std::string& folder) {
    Sweep sweep{
        .title = study.title.empty() ? study.name : study.title,
        .settings = {{"case", study.base.name}, {"models", report::display_names(study.models)}},
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

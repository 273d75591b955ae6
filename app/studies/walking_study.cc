#include <nlohmann/json.hpp>
#include <utility>

#include "app/studies/study_axes.h"
#include "app/studies/study_run.h"
#include "app/studies/sweep_table.h"
#include "app/studies/walk_points.h"
#include "contact/error.h"
#include "files/version.h"
#include "io/results/atomic_file.h"
#include "walking/report/map_page.h"
#include "walking/report/walk_sweep_document.h"
#include "walking/study/walk_outcome.h"

namespace tricontact::app {

namespace {

class WalkingStudy : public StudyRun {
  public:
    WalkingStudy(io::Study study, const Shard& shard, const SweepOptions& options)
        : study_(std::move(study)), options_(options), points_(walk_points(study_)) {
        if (options.vtk)
            throw contact::InputError(
                "--vtk: studies of walking machines write no files for ParaView; run a point by "
                "tricontact walk, or omit --vtk");
        std::erase_if(points_, [&](const WalkPoint& point) { return !shard.has(point.key); });
    }

    std::vector<std::string> keys() const override {
        std::vector<std::string> keys;
        for (const WalkPoint& point : points_) keys.push_back(point.key);
        return keys;
    }

    void compute(io::ResultStore& store, const std::string&) override {
        compute_missing(points_, store,
                        {.jobs = options_.jobs,
                         .retry_failed = options_.retry_failed,
                         .quiet = options_.quiet,
                         .attend = options_.attend});
    }

    std::string table(const io::ResultStore& store) const override {
        std::vector<std::string> headings;
        for (const auto& axis : study_.axes) headings.push_back(io::table_heading(*axis.key));
        std::vector<TableRow> rows;
        for (const WalkPoint& point : points_) rows.push_back({point.values, point.key});
        return sweep_table(headings, walking::walk_result_names(), rows, store);
    }

    report::Document report(const io::ResultStore& store,
                            const std::string& folder) const override {
        const walking::WalkSweep sweep = sweep_of(store);
        report::Document document = walking::walk_sweep_document(sweep);
        if (auto map = walking::walk_map_of(sweep)) {
            map->command = "tricontact sweep " + study_.name;
            map->version = files::version;
            map->files = {{"report of the study", "report.html"}};
            io::write_file(folder + '/' + map_page_name, walking::map_page(*map));
            document.files.emplace_back("map with the motion of every machine", map_page_name);
        }
        return document;
    }

  private:
    walking::WalkSweep::Point point_of(const WalkPoint& point, const io::ResultStore& store) const {
        walking::WalkSweep::Point result{.values = {}, .machine = point.c.machine};
        for (const std::string& value : point.values) result.values.push_back(cell_of(value));
        const auto outcome = store.find(point.key);
        if (outcome && outcome->results)
            result.outcome =
                walking::read_walk_results(nlohmann::ordered_json::parse(*outcome->results));
        else
            result.error = outcome ? outcome->error.value_or("") : "not computed";
        return result;
    }

    walking::WalkSweep sweep_of(const io::ResultStore& store) const {
        walking::WalkSweep sweep{.title = study_.title.empty() ? study_.name : study_.title,
                                 .settings = {{"case", study_.base.name}},
                                 .axes = {},
                                 .points = {}};
        for (const io::Entry& entry : study_.settings)
            sweep.settings.emplace_back(entry.path, io::shown(entry.value));
        for (const io::Study::Axis& axis : study_.axes) sweep.axes.push_back(axis_of(axis));
        for (const WalkPoint& point : points_) sweep.points.push_back(point_of(point, store));
        return sweep;
    }

    io::Study study_;
    SweepOptions options_;
    std::vector<WalkPoint> points_;
};

}  // namespace

std::unique_ptr<StudyRun> walking_study(io::Study study, const Shard& shard,
                                        const SweepOptions& options) {
    return std::make_unique<WalkingStudy>(std::move(study), shard, options);
}

}  // namespace tricontact::app

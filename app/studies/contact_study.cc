#include <algorithm>
#include <utility>

#include "app/studies/point_runs.h"
#include "app/studies/study_run.h"
#include "app/studies/sweep_points.h"
#include "app/studies/sweep_report.h"
#include "app/studies/sweep_table.h"
#include "comparisons/quantities/results.h"
#include "comparisons/run/sweep_document.h"
#include "contact/error.h"

namespace tricontact::app {

namespace {

void check_files(const std::vector<SweepPoint>& points) {
    for (const SweepPoint& point : points)
        if (point.output.vtk == contact::Case::VtkOutput::none)
            throw contact::InputError(
                "--vtk: output.vtk = \"none\" leaves nothing to write; set output.vtk = "
                "\"quarters\" "
                "in the case or in [set], or omit --vtk");
}

class ContactStudy : public StudyRun {
  public:
    ContactStudy(io::Study study, const Shard& shard, const SweepOptions& options)
        : study_(std::move(study)), options_(options), points_(sweep_points(study_)) {
        std::erase_if(points_, [&](const SweepPoint& point) { return !shard.has(point.key); });
        if (options.vtk) check_files(points_);
    }

    std::vector<std::string> keys() const override {
        std::vector<std::string> keys;
        for (const SweepPoint& point : points_) keys.push_back(point.key);
        return keys;
    }

    void compute(io::ResultStore& store, const std::string& folder) override {
        compute_missing(points_, store,
                        {.name = "sweep",
                         .jobs = options_.jobs,
                         .retry_failed = options_.retry_failed,
                         .quiet = options_.quiet,
                         .folder = options_.vtk ? folder : "",
                         .attend = options_.attend});
    }

    std::string table(const io::ResultStore& store) const override {
        std::vector<std::string> headings;
        for (const auto& axis : study_.axes) headings.push_back(io::table_heading(*axis.key));
        headings.insert(headings.end(), {"model", "level"});
        std::vector<TableRow> rows;
        for (const SweepPoint& point : points_) {
            TableRow& row = rows.emplace_back(point.values, point.key);
            row.fields.insert(row.fields.end(), {point.model, std::to_string(point.level)});
        }
        std::vector<std::string> names;
        for (const auto* quantity : comparisons::column_quantities())
            names.emplace_back(quantity->key);
        return sweep_table(headings, names, rows, store);
    }

    report::Document report(const io::ResultStore& store,
                            const std::string& folder) const override {
        return comparisons::sweep_document(sweep_of(study_, points_, store, folder));
    }

  private:
    io::Study study_;
    SweepOptions options_;
    std::vector<SweepPoint> points_;
};

}  // namespace

std::unique_ptr<StudyRun> contact_study(io::Study study, const Shard& shard,
                                        const SweepOptions& options) {
    return std::make_unique<ContactStudy>(std::move(study), shard, options);
}

}  // namespace tricontact::app

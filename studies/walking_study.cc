#include <ctime>
#include <map>
#include <nlohmann/json.hpp>
#include <span>
#include <tuple>

#include "files/version.h"
#include "io/results/atomic_file.h"
#include "runs/point_key.h"
#include "studies/study_kind.h"
#include "walking/kernels/batch.h"
#include "walking/report/map_page.h"
#include "walking/report/walk_sweep_document.h"
#include "walking/study/walk_outcome.h"

namespace tricontact::studies {

namespace {

using walking::WalkCase;

/// Points of a lot: vectors are full while most of them stand upright, and a lot of 2e7 steps each
/// ends after some ten seconds.
constexpr std::size_t lot_size = 128;

/// Enough of the end for the frequency of a chaotic one; of short runs, of which it would be the
/// greater part of the time of computing, just what pages show.
walking::Recording recording_of(const WalkCase& walk_case) {
    constexpr double long_run = 10000;
    return {.tail = walk_case.time.end >= long_run ? 200. : 12., .interval = 0.1};
}

std::vector<walking::Walk> walks_of(std::span<const WalkCase> cases) {
    const walking::Recording recording = recording_of(cases.front());
    if (walking::fits_lane(cases.front().machine)) return walking::walk_batch(cases, recording);
    return {walking::walk(cases.front(), recording)};
}

StudyPoint walk_point_of(const io::Study& study, const Combination& combination) {
    try {
        WalkCase c = walking::resolve_walk_case(study.base, combination.entries);
        c.title.clear();
        const std::string resolved = walking::write_walk_case(c);
        return {.values = combination.values,
                .model = "walk",
                .c = c,
                .resolved = resolved,
                .key = runs::point_key(resolved)};
    } catch (const contact::InputError& error) {
        throw contact::InputError(
            fmt::format("{}: point {}: {}", study.name, text_of(study, combination), error.what()));
    }
}

walking::WalkSweep::Point reported_walk(const StudyPoint& point, const io::ResultStore& store) {
    walking::WalkSweep::Point result{.values = {}, .machine = point.walk().machine};
    for (const std::string& value : point.values) result.values.push_back(cell_of(value));
    const auto outcome = store.find(point.key);
    if (outcome && outcome->results)
        result.outcome = walking::read_walk_results(json::parse(*outcome->results));
    else
        result.error = failure_of(outcome);
    return result;
}

class WalkingKind : public StudyKind {
  public:
    StudyPoints points(const io::Study& study, const contact::ModelMakers&) const override {
        StudyPoints points;
        for_each_combination(study, 1, [&](const Combination& combination) {
            points.push_back(walk_point_of(study, combination));
        });
        return points;
    }

    void require_files(const StudyPoints&) const override {
        throw contact::InputError(
            "--vtk: studies of walking machines write no files for ParaView; run a point by "
            "tricontact run, or omit --vtk");
    }

    /// Those that run side by side in the lanes of the processor's vectors share model, step and
    /// end; others run alone. What a point comes to depends neither on its lot nor on the jobs.
    std::vector<Places> lots(const StudyPoints& points, const Places& open) const override {
        std::vector<Places> lots;
        std::map<std::tuple<walking::Machine::Model, double, double>, std::size_t> growing;
        for (const std::size_t i : open) {
            const WalkCase& c = points[i].walk();
            if (!walking::fits_lane(c.machine)) {
                lots.push_back({i});
                continue;
            }
            const auto [at, is_new] =
                growing.emplace(std::tuple(c.machine.model, c.time.step, c.time.end), lots.size());
            if (!is_new && lots[at->second].size() == lot_size) at->second = lots.size();
            if (at->second == lots.size()) lots.emplace_back();
            lots[at->second].push_back(i);
        }
        return lots;
    }

    std::string compute(const StudyPoints& points, const Places& lot,
                        const PointRuns&) const override {
        const std::clock_t began = std::clock();
        std::vector<WalkCase> cases;
        for (const std::size_t i : lot) cases.push_back(points[i].walk());
        json results = json::array();
        const std::vector<walking::Walk> walks = walks_of(cases);
        for (std::size_t i = 0; i < cases.size(); ++i)
            results.push_back(walking::walk_results(walking::outcome_of(cases[i], walks[i])));
        const double cpu_s = static_cast<double>(std::clock() - began) / CLOCKS_PER_SEC;
        return json{{"results", results}, {"cpu_s", cpu_s / static_cast<double>(lot.size())}}
            .dump();
    }

    std::string memory_remedy() const override { return "use fewer --jobs"; }

    std::vector<std::string> result_names() const override { return walking::walk_result_names(); }

    report::Document report(const io::Study& study, const StudyPoints& points,
                            const io::ResultStore& store,
                            const std::string& folder) const override {
        walking::WalkSweep sweep{
            .title = {}, .settings = {{"case", study.base.name}}, .axes = {}, .points = {}};
        describe(study, sweep);
        for (const StudyPoint& point : points) sweep.points.push_back(reported_walk(point, store));
        report::Document document = walking::walk_sweep_document(sweep);
        if (auto map = walking::walk_map_of(sweep)) {
            map->command = "tricontact sweep " + study.name;
            map->version = files::version;
            map->files = {{"report of the study", "report.html"}};
            io::write_file(folder + '/' + map_page_name, walking::map_page(*map));
            document.files.emplace_back("map with the motion of every machine", map_page_name);
        }
        return document;
    }
};

}  // namespace

const StudyKind& walking_kind() {
    static const WalkingKind kind;
    return kind;
}

}  // namespace tricontact::studies

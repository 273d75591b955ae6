#include <fmt/format.h>

#include <ctime>
#include <exception>
#include <iostream>
#include <map>
#include <new>
#include <nlohmann/json.hpp>
#include <numeric>
#include <set>
#include <span>
#include <tuple>

#include "app/studies/walk_points.h"
#include "app/studies/worker_pool.h"
#include "files/version.h"
#include "io/results/progress.h"
#include "walking/kernels/lane.h"
#include "walking/run/walk_batch.h"
#include "walking/run/walk_run.h"
#include "walking/study/walk_outcome.h"

namespace tricontact::app {

namespace {

using json = nlohmann::ordered_json;
using Places = std::vector<std::size_t>;

/// Points of a lot: vectors are full while most of them stand upright, and a lot of 2e7 steps each
/// ends after some ten seconds.
constexpr std::size_t lot_size = 128;

/// Enough of the end for the frequency of a chaotic one; of short runs, of which it would be the
/// greater part of the time of computing, just what pages show.
walking::Recording recording_of(const walking::WalkCase& walk_case) {
    constexpr double long_run = 10000;
    return {.tail = walk_case.time.end >= long_run ? 200. : 12., .interval = 0.1};
}

Places missing(const std::vector<WalkPoint>& points, const io::ResultStore& store,
               bool retry_failed) {
    Places open;
    std::set<std::string> seen;  // the same case may stand at several places of a study
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (!seen.insert(points[i].key).second) continue;
        const auto found = store.find(points[i].key);
        if (!found || (found->error && retry_failed)) open.push_back(i);
    }
    return open;
}

/// Those that run side by side share model, step and end; others run alone.
std::vector<Places> lots_of(const std::vector<WalkPoint>& points, const Places& open) {
    std::vector<Places> lots;
    std::map<std::tuple<walking::Machine::Model, double, double>, std::size_t> growing;
    for (const std::size_t i : open) {
        const walking::WalkCase& c = points[i].c;
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

std::vector<walking::Walk> walks_of(std::span<const walking::WalkCase> cases) {
    const walking::Recording recording = recording_of(cases.front());
    if (walking::fits_lane(cases.front().machine)) return walking::walk_batch(cases, recording);
    return {walking::walk(cases.front(), recording)};
}

json computed(const std::vector<WalkPoint>& points, const Places& lot) {
    const std::clock_t began = std::clock();
    std::vector<walking::WalkCase> cases;
    for (const std::size_t i : lot) cases.push_back(points[i].c);
    json results = json::array();
    const std::vector<walking::Walk> walks = walks_of(cases);
    for (std::size_t i = 0; i < cases.size(); ++i)
        results.push_back(walking::walk_results(walking::outcome_of(cases[i], walks[i])));
    const double cpu_s = static_cast<double>(std::clock() - began) / CLOCKS_PER_SEC;
    return {{"results", results}, {"cpu_s", cpu_s / static_cast<double>(lot.size())}};
}

std::string compute_lot(const std::vector<WalkPoint>& points, const Places& lot) noexcept {
    try {
        return computed(points, lot).dump();
    } catch (const std::bad_alloc&) {
        return json{{"error", "not enough memory; use fewer --jobs"}}.dump();
    } catch (const std::exception& error) {
        return json{{"error", error.what()}}.dump(-1, ' ', false, json::error_handler_t::replace);
    }
}

std::vector<io::PointOutcome> outcomes_of(const std::vector<WalkPoint>& points, const Places& lot,
                                          const WorkerReport& report) {
    const json line =
        report.failure.empty() ? json::parse(report.text) : json{{"error", report.failure}};
    std::vector<io::PointOutcome> outcomes;
    for (std::size_t k = 0; k < lot.size(); ++k) {
        const WalkPoint& point = points[lot[k]];
        io::PointOutcome& outcome = outcomes.emplace_back();
        outcome = {.key = point.key,
                   .version = files::version,
                   .model = "walk",
                   .resolved = point.resolved};
        if (line.contains("error")) {
            outcome.error = line.at("error").get<std::string>();
            continue;
        }
        outcome.results = line.at("results").at(k).dump();
        outcome.cpu_s = outcome.wall_s = line.at("cpu_s").get<double>();
    }
    return outcomes;
}

}  // namespace

void compute_missing(const std::vector<WalkPoint>& points, io::ResultStore& store,
                     const WalkRuns& runs) {
    const Places open = missing(points, store, runs.retry_failed);
    const std::size_t n_found = points.size() - open.size();
    if (n_found > 0 && !runs.quiet)
        std::cerr << fmt::format("{} of {} points are there already\n", n_found, points.size());
    const std::vector<Places> lots = lots_of(points, open);
    Places all(lots.size());
    std::iota(all.begin(), all.end(), 0);
    io::ProgressBar bar(std::cerr, io::ProgressBar::style_of_stderr(runs.quiet), "sweep", {},
                        "point");
    int n_done = 0;
    const auto task = [&](std::size_t lot) { return compute_lot(points, lots[lot]); };
    const auto keep = [&](std::size_t lot, const WorkerReport& report) {
        store.add(outcomes_of(points, lots[lot], report));
        bar.update(n_done += static_cast<int>(lots[lot].size()), static_cast<int>(open.size()));
    };
    run_in_processes(all, runs.jobs, task, keep, runs.attend);
    if (!open.empty()) bar.finish();
}

}  // namespace tricontact::app

#include "app/studies/point_runs.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <set>

#include "app/studies/compute_point.h"
#include "app/studies/worker_pool.h"
#include "io/results/progress.h"

namespace tricontact::app {

namespace {

// The same case may stand at several places of a study.
std::vector<std::size_t> missing(const std::vector<SweepPoint>& points,
                                 const io::ResultStore& store, const PointRuns& runs) {
    const auto lacks_files = [&](const SweepPoint& point) {
        return !runs.folder.empty() &&
               !std::filesystem::exists(runs.folder + '/' + surface_file(point));
    };
    std::vector<std::size_t> open;
    std::set<std::string> seen;
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (!seen.insert(points[i].key).second) continue;
        const auto found = store.find(points[i].key);
        if (!found || (found->error ? runs.retry_failed : lacks_files(points[i])))
            open.push_back(i);
    }
    return open;
}

}  // namespace

io::ResultStore open_results(const std::string& folder) {
    const std::string path = folder + '/' + io::result_store_name;
    io::ResultStore store(path);
    if (store.n_damaged() > 0)
        std::cerr << fmt::format("{}: {} damaged rows removed; their points are computed again\n",
                                 path, store.n_damaged());
    return store;
}

void compute_missing(const std::vector<SweepPoint>& points, io::ResultStore& store,
                     const PointRuns& runs) {
    // Threads of BLAS beside other points would only be in each other's way.
    ::setenv("OPENBLAS_NUM_THREADS", "1", 1);
    const std::vector<std::size_t> open = missing(points, store, runs);
    const std::size_t n_found = points.size() - open.size();
    if (n_found > 0 && !runs.quiet)
        std::cerr << fmt::format("{} of {} points are there already\n", n_found, points.size());
    io::ProgressBar bar(std::cerr, io::ProgressBar::style_of_stderr(runs.quiet), runs.name, {},
                        "point");
    int n_done = 0;
    const auto task = [&](std::size_t i) { return compute_point(points[i], runs.folder); };
    const auto keep = [&](std::size_t i, const WorkerReport& report) {
        store.add(outcome_of(points[i], report));
        bar.update(++n_done, static_cast<int>(open.size()));
    };
    run_in_processes(open, runs.jobs, task, keep, runs.attend);
    if (!open.empty()) bar.finish();
}

std::size_t n_without_result(const std::vector<std::string>& keys, const io::ResultStore& store) {
    return static_cast<std::size_t>(std::count_if(keys.begin(), keys.end(), [&](const auto& key) {
        const auto found = store.find(key);
        return !found || found->error;
    }));
}

}  // namespace tricontact::app

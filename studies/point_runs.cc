#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <iostream>
#include <iterator>
#include <new>
#include <nlohmann/json.hpp>
#include <numeric>
#include <set>

#include "contact/base/interruption.h"
#include "files/version.h"
#include "io/results/progress.h"
#include "studies/study_kind.h"
#include "studies/worker_pool.h"

namespace tricontact::studies {

namespace {

// The same case may stand at several places of a study.
Places missing(const StudyPoints& points, const io::ResultStore& store, const PointRuns& runs) {
    const auto lacks_files = [&](const StudyPoint& point) {
        return !runs.folder.empty() &&
               !std::filesystem::exists(runs.folder + '/' + surface_file(point));
    };
    Places open;
    std::set<std::string> seen;
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (!seen.insert(points[i].key).second) continue;
        const auto found = store.find(points[i].key);
        if (!found || (found->error ? runs.retry_failed : lacks_files(points[i])))
            open.push_back(i);
    }
    return open;
}

/// Results, times or error in a line of text.
std::string compute_lot(const PointKind& kind, const StudyPoints& points, const Places& lot,
                        const PointRuns& runs) noexcept {
    const auto failed = [](const std::string& what, bool refused = false) {
        return json{{"error", what}, {"refused", refused}}.dump(-1, ' ', false,
                                                                json::error_handler_t::replace);
    };
    try {
        return kind.compute(points, lot, runs);
    } catch (const contact::InputError& error) {
        return failed(error.what(), true);
    } catch (const std::bad_alloc&) {
        return failed("not enough memory; " + kind.memory_remedy());
    } catch (const std::exception& error) {
        return failed(error.what());
    }
}

/// What that line, or the end of the process that should have written it, says of the points.
std::vector<io::PointOutcome> outcomes_of(const PointKind& kind, const StudyPoints& points,
                                          const Places& lot, const WorkerReport& report) {
    const json line =
        report.failure.empty() ? json::parse(report.text) : json{{"error", report.failure}};
    std::vector<io::PointOutcome> outcomes;
    for (std::size_t k = 0; k < lot.size(); ++k) {
        const StudyPoint& point = points[lot[k]];
        io::PointOutcome& outcome = outcomes.emplace_back(point.key, std::string(files::version),
                                                          point.model, point.resolved);
        if (line.contains("error")) {
            outcome.error = line.at("error").get<std::string>();
            if (report.killed) *outcome.error += "; perhaps for want of memory";
            kind.failed(point, *outcome.error, line.value("refused", false));
            continue;
        }
        const json& results = line.at("results");
        outcome.results = (results.is_array() ? results.at(k) : results).dump();
        outcome.cpu_s = line.at("cpu_s").get<double>();
        outcome.wall_s = line.value("wall_s", outcome.cpu_s);
    }
    return outcomes;
}

/// Stores outcomes, of many short points some at a time: each transaction waits for the disk.
class OutcomeBuffer {
  public:
    explicit OutcomeBuffer(io::ResultStore& store) : store_(store) {}

    void add(std::vector<io::PointOutcome> outcomes, bool may_wait) {
        std::ranges::move(outcomes, std::back_inserter(waiting_));
        if (may_wait)
            flush_if_due();
        else
            flush();
    }
    void flush_if_due() {
        if (Clock::now() - flushed_ >= longest_wait) flush();
    }
    void flush() {
        if (!waiting_.empty()) store_.add(waiting_);
        waiting_.clear();
        flushed_ = Clock::now();
    }

  private:
    using Clock = std::chrono::steady_clock;
    static constexpr auto longest_wait = 4 * short_task;

    io::ResultStore& store_;
    std::vector<io::PointOutcome> waiting_;
    Clock::time_point flushed_ = Clock::now();
};

}  // namespace

std::vector<Places> PointKind::lots(const StudyPoints&, const Places& open) const {
    std::vector<Places> lots;
    for (const std::size_t i : open) lots.push_back({i});
    return lots;
}

std::string PointKind::memory_remedy() const {
    return "use fewer --jobs or a coarser resolution";
}

io::ResultStore open_results(const std::string& folder) {
    const std::string path = folder + '/' + io::result_store_name;
    io::ResultStore store(path);
    if (store.n_damaged() > 0)
        std::cerr << fmt::format("{}: {} damaged rows removed; their points are computed again\n",
                                 path, store.n_damaged());
    return store;
}

void compute_missing(const PointKind& kind, const StudyPoints& points, io::ResultStore& store,
                     const PointRuns& runs) {
    // Threads of BLAS beside other points would only be in each other's way.
    ::setenv("OPENBLAS_NUM_THREADS", "1", 1);
    const Places open = missing(points, store, runs);
    const std::size_t n_found = points.size() - open.size();
    if (n_found > 0)
        runs.options.say(fmt::format("{} of {} points are there already", n_found, points.size()));
    for (const std::size_t i : open)  // once, not in each process
        runs.options.makers->load(points[i].model);
    const std::vector<Places> lots = kind.lots(points, open);
    Places all(lots.size());
    std::iota(all.begin(), all.end(), 0);
    io::ProgressBar bar = runs.options.progress_bar(runs.name, runs.noun);
    int n_done = 0;
    OutcomeBuffer outcomes(store);
    const auto task = [&](std::size_t i) { return compute_lot(kind, points, lots[i], runs); };
    const auto keep = [&](std::size_t i, const WorkerReport& report) {
        outcomes.add(outcomes_of(kind, points, lots[i], report), report.was_short);
        bar.update(n_done += static_cast<int>(lots[i].size()), static_cast<int>(open.size()));
    };
    const auto attend = [&] {
        outcomes.flush_if_due();
        if (contact::interruption_check) contact::interruption_check();
    };
    try {
        run_in_processes(all, runs.options.threads, task, keep, attend);
    } catch (...) {
        outcomes.flush();
        throw;
    }
    outcomes.flush();
    if (!open.empty()) bar.finish();
}

}  // namespace tricontact::studies

#include <fmt/format.h>

#include <charconv>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <set>
#include <stdexcept>

#include "app/commands.h"
#include "app/compute_point.h"
#include "app/sweep_points.h"
#include "app/sweep_table.h"
#include "app/worker_pool.h"
#include "contact/error.h"
#include "io/atomic_file.h"
#include "io/progress.h"
#include "io/result_store.h"
#include "io/study_reader.h"

namespace tricontact::app {

namespace {

constexpr const char* table_name = "results.csv";

struct Shard {
    int i = 1, n = 1;
};

Shard shard_of(const std::string& text) {
    constexpr int most = 100'000;
    Shard shard;
    const char* const end = text.data() + text.size();
    const auto i = std::from_chars(text.data(), end, shard.i);
    const bool slash = i.ec == std::errc() && i.ptr != end && *i.ptr == '/';
    const auto n = std::from_chars(slash ? i.ptr + 1 : end, end, shard.n);
    if (!slash || n.ec != std::errc() || n.ptr != end || shard.i < 1 || shard.n < shard.i ||
        shard.n > most)
        throw contact::InputError(fmt::format(
            "--shard {}: must be i/n with 1 <= i <= n <= {}; write for example --shard 1/8", text,
            most));
    return shard;
}

std::string folder_of(const SweepOptions& options) {
    if (!options.output.empty()) return options.output;
    std::string folder = "results/" + std::filesystem::path(options.study_file).stem().string();
    if (!options.shard.empty()) {
        const Shard shard = shard_of(options.shard);
        folder += fmt::format("_shard_{}_of_{}", shard.i, shard.n);
    }
    return folder;
}

/// The points of a study and what the store has of them.
class Sweep {
  public:
    Sweep(const SweepOptions& options, const std::vector<SweepPoint>& points,
          io::ResultStore& store)
        : options_(options), points_(points), store_(store) {}

    /// Computes what is missing; prints how far it is.
    void run() {
        const std::vector<std::size_t> open = missing();
        const std::size_t n_found = points_.size() - open.size();
        if (n_found > 0 && !options_.quiet)
            std::cerr << fmt::format("{} of {} points are there already\n", n_found,
                                     points_.size());
        io::ProgressBar bar(std::cerr, io::ProgressBar::style_of_stderr(options_.quiet), "sweep",
                            {}, "point");
        int n_done = 0;
        std::vector<std::size_t> killed;
        const auto task = [this](std::size_t i) { return compute_point(points_[i]); };
        const auto store = [&](std::size_t i, const WorkerReport& report) {
            store_.add(outcome_of(points_[i], report));
            bar.update(++n_done, static_cast<int>(open.size()));
        };
        run_in_processes(open, options_.jobs, task, [&](std::size_t i, const WorkerReport& report) {
            if (report.killed)
                killed.push_back(i);
            else
                store(i, report);
        });
        // Killed for want of memory it may do better alone; killed by hand it is no failure.
        run_in_processes(killed, 1, task, store);
        if (!open.empty()) bar.finish();
    }

    std::size_t n_failed() const {
        std::size_t n = 0;
        for (const SweepPoint& point : points_) {
            const auto found = store_.find(point.key);
            n += found && found->error;
        }
        return n;
    }

  private:
    // The same case may stand at several places of a study.
    std::vector<std::size_t> missing() const {
        std::vector<std::size_t> open;
        std::set<std::string> seen;
        for (std::size_t i = 0; i < points_.size(); ++i) {
            if (!seen.insert(points_[i].key).second) continue;
            const auto found = store_.find(points_[i].key);
            if (!found || (found->error && options_.retry_failed)) open.push_back(i);
        }
        return open;
    }

    const SweepOptions& options_;
    const std::vector<SweepPoint>& points_;
    io::ResultStore& store_;
};

std::vector<SweepPoint> points_of(const io::Study& study, const SweepOptions& options) {
    std::vector<SweepPoint> points = sweep_points(study);
    if (options.shard.empty()) return points;
    const Shard shard = shard_of(options.shard);
    std::erase_if(points,
                  [&](const SweepPoint& point) { return !in_shard(point, shard.i, shard.n); });
    return points;
}

}  // namespace

void sweep_command(const SweepOptions& options) {
    const std::string folder = folder_of(options);
    const io::Study study = io::read_study(options.study_file);
    const std::vector<SweepPoint> points = points_of(study, options);

    io::make_output_folder(folder);
    io::ResultStore store(folder + '/' + io::result_store_name);
    // Threads of BLAS beside other points would only be in each other's way.
    ::setenv("OPENBLAS_NUM_THREADS", "1", 1);
    const std::string table = folder + '/' + table_name;
    std::error_code ignored;  // a file that cannot be removed cannot be written either: said then
    std::filesystem::remove(table, ignored);  // it must not pass for that of an unfinished sweep
    Sweep sweep(options, points, store);
    sweep.run();
    io::write_file(table, sweep_table(study, points, store));
    if (!options.quiet) std::cerr << fmt::format("{} points in {}\n", points.size(), table);
    if (const std::size_t n = sweep.n_failed())
        throw std::runtime_error(
            fmt::format("{} of {} points failed: their errors stand in {}; --retry-failed computes "
                        "them again",
                        n, points.size(), table));
}

void merge_command(const MergeOptions& options) {
    for (const std::string& from : options.inputs)
        if (!std::filesystem::exists(from + '/' + io::result_store_name))
            throw contact::InputError(from + ": holds no " + io::result_store_name +
                                      "; name the folder of a sweep");
    io::make_output_folder(options.output);
    const std::string path = options.output + '/' + io::result_store_name;
    io::ResultStore store(path);
    for (const std::string& from : options.inputs) {
        std::error_code ignored;
        if (std::filesystem::equivalent(from, options.output, ignored))
            throw contact::InputError(from + ": is the output folder too; name it once");
        const io::ResultStore shard(from + '/' + io::result_store_name,
                                    io::ResultStore::Mode::read);
        const auto merged = store.merge(shard);
        std::cout << fmt::format("{}: {} points, {} failures\n", from, merged.points,
                                 merged.failures);
        if (merged.different > 0)
            std::cout << fmt::format(
                "{}: {} points have other results than in {}, which keeps its own\n", from,
                merged.different, path);
    }
}

}  // namespace tricontact::app

#include <fmt/format.h>

#include <charconv>
#include <filesystem>
#include <iostream>
#include <stdexcept>

#include "app/commands/commands.h"
#include "app/studies/point_runs.h"
#include "app/studies/study_run.h"
#include "contact/error.h"
#include "files/version.h"
#include "io/case/study_reader.h"
#include "io/results/atomic_file.h"
#include "io/results/output_folder.h"
#include "io/results/result_store.h"
#include "report/document.h"
#include "walking/input/walk_keys.h"

namespace tricontact::app {

namespace {

constexpr const char* table_name = "results.csv";
constexpr const char* report_name = "report.html";

Shard shard_of(const std::string& text) {
    constexpr int most = 100'000;
    Shard shard;
    if (text.empty()) return shard;
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
    std::string suffix;
    if (!options.shard.empty()) {
        const Shard shard = shard_of(options.shard);
        suffix = fmt::format("_shard_{}_of_{}", shard.i, shard.n);
    }
    return io::output_folder(options.output, options.study_file, suffix);
}

std::string report_of(const StudyRun& run, const io::Study& study, const io::ResultStore& store,
                      const std::string& folder, const std::string& shard) {
    report::Document document = run.report(store, folder);
    if (!shard.empty()) document.settings.emplace_back("shard", shard);
    document.files.insert(document.files.end(),
                          {{"table of all points", table_name},
                           {"everything that is stored, for SQLite", io::result_store_name}});
    document.command = "tricontact sweep " + study.name;
    if (!shard.empty()) document.command += " --shard " + shard;
    document.version = files::version;
    return report::document_html(document);
}

void merge(const std::string& from, io::ResultStore& store, const std::string& output) {
    const io::ResultStore shard(from + '/' + io::result_store_name, io::ResultStore::Mode::read);
    const auto merged = store.merge(shard);
    std::cout << fmt::format("{}: {} points, {} failures\n", from, merged.points, merged.failures);
    if (merged.different > 0)
        std::cout << fmt::format(
            "{}: {} points have other results than in {}, which keeps its own\n", from,
            merged.different, output + '/' + io::result_store_name);
    if (merged.damaged > 0)
        std::cout << fmt::format("{}: {} damaged rows left out: their sweep computes them again\n",
                                 from, merged.damaged);
}

}  // namespace

void sweep_command(const SweepOptions& options) {
    const std::string folder = folder_of(options);
    const io::Study study = io::read_study(options.study_file, walking::walk_key_list());
    const auto run =
        (study.walks ? walking_study : contact_study)(study, shard_of(options.shard), options);
    const std::vector<std::string> keys = run->keys();

    io::OutputNames names{{table_name, report_name, map_page_name}, io::result_store_files()};
    names.kept.push_back("points/");
    io::OutputFolder output(folder, names);
    std::size_t n_failed = 0;
    output.fill([&] {
        io::ResultStore store = open_results(folder);
        run->compute(store, folder);
        io::write_file(folder + '/' + table_name, run->table(store));
        if (options.report)
            io::write_file(folder + '/' + report_name,
                           report_of(*run, study, store, folder, options.shard));
        n_failed = n_without_result(keys, store);
    });
    const std::string table = folder + '/' + table_name;
    if (!options.quiet)
        std::cerr << fmt::format("{} points in {}{}\n", keys.size(), table,
                                 options.report ? " (open report.html)" : "");
    if (n_failed > 0)
        throw std::runtime_error(
            fmt::format("{} of {} points failed: their errors stand in {}; --retry-failed computes "
                        "them again",
                        n_failed, keys.size(), table));
}

void merge_command(const MergeOptions& options) {
    for (const std::string& from : options.inputs) {
        std::error_code ignored;
        if (std::filesystem::equivalent(from, options.output, ignored))
            throw contact::InputError(from + ": is the output folder too; name it once");
        if (!std::filesystem::exists(from + '/' + io::result_store_name))
            throw contact::InputError(from + ": holds no " + io::result_store_name +
                                      "; name the folder of a sweep");
        const io::ResultStore readable(from + '/' + io::result_store_name,
                                       io::ResultStore::Mode::read);
    }
    io::OutputFolder output(options.output, {{}, io::result_store_files()});
    output.fill([&] {
        io::ResultStore store = open_results(options.output);
        for (const std::string& from : options.inputs) merge(from, store, options.output);
    });
}

}  // namespace tricontact::app

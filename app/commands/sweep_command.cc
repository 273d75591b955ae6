#include <filesystem>
#include <nlohmann/json.hpp>

#include "app/commands/command.h"
#include "studies/study_kind.h"
#include "studies/sweep.h"

namespace tricontact::app {

namespace {

struct MergeOptions : CommandOptions {
    std::vector<std::string> inputs;  ///< folders of sweeps
};

/// What came from one of them.
struct Merged {
    std::string from;
    io::ResultStore::Merged counts;
};

std::string text_of(const Merged& one, const std::string& output) {
    const auto& [from, merged] = one;
    std::string text =
        fmt::format("{}: {} points, {} failures\n", from, merged.points, merged.failures);
    if (merged.different > 0)
        text += fmt::format("{}: {} points have other results than in {}, which keeps its own\n",
                            from, merged.different, output + '/' + io::result_store_name);
    if (merged.damaged > 0)
        text += fmt::format("{}: {} damaged rows left out: their sweep computes them again\n", from,
                            merged.damaged);
    return text;
}

nlohmann::ordered_json json_of(const Merged& one) {
    return {{"from", one.from},
            {"points", one.counts.points},
            {"failures", one.counts.failures},
            {"different", one.counts.different},
            {"damaged", one.counts.damaged}};
}

/// Brings the stores of sweeps together; prints what came from where.
void merge_sweeps(const MergeOptions& options) {
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
    std::vector<Merged> merged;
    options.fill({{}, io::result_store_files()}, [&] {
        io::ResultStore store = studies::open_results(options.output);
        for (const std::string& from : options.inputs)
            merged.push_back({from, store.merge(io::ResultStore(from + '/' + io::result_store_name,
                                                                io::ResultStore::Mode::read))});
    });
    Answer answer([&] {
        nlohmann::ordered_json json{{"folder", options.output}, {"merged", {}}};
        for (const Merged& one : merged) json["merged"].push_back(json_of(one));
        return json.dump(2);
    });
    for (const Merged& one : merged) answer.add(text_of(one, options.output));
    options.answer(answer);
}

}  // namespace

Command sweep_command() {
    return Declared<studies::SweepOptions>(Group::compute, "sweep",
                                           "Run the points of a study side by side; resumable",
                                           studies::sweep)
        .on_file("study", "Study file (TOML)", "STUDY.toml")
        .jobs()
        .option("--shard", &studies::SweepOptions::shard, "Only the i-th of n parts of the study",
                "i/n")
        .output("Folder (results/<study>)")
        .exports()
        .flag("--retry-failed", &studies::SweepOptions::retry_failed, "Compute failed points again")
        .flag("--vtk", &studies::SweepOptions::vtk, "Files for ParaView of each point (output.vtk)")
        .no_report()
        .json("Counts of points and failures as JSON on standard output")
        .quiet();
}

Command sweep_merge_command() {
    return Declared<MergeOptions>(Group::compute, "sweep merge",
                                  "Bring the results of sweeps into one folder", merge_sweeps)
        .required("output", &CommandOptions::output, "Folder of the whole", "OUT")
        .required("inputs", &MergeOptions::inputs, "Folders of sweeps", "IN")
        .json();
}

}  // namespace tricontact::app

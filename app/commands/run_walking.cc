#include <algorithm>
#include <cmath>
#include <vector>

#include "app/commands/run_kinds.h"
#include "walking/input/walk_reader.h"
#include "walking/report/walk_animation.h"
#include "walking/report/walk_document.h"

namespace tricontact::app {

namespace {

using walking::report_recording;
using walking::Snapshot;
using walking::Walk;
using walking::WalkCase;

const std::string walk_again = std::string("tricontact run ") + resolved_case_name;

/// The last period of a limit cycle, else some swings of the spring: not more than `most` states,
/// at equal intervals.
std::vector<Snapshot> frames_of(const Walk& walk, std::size_t most) {
    constexpr double swings = 20;
    const double shown = walk.result.period.value_or(swings) / report_recording.interval;
    const std::size_t n =
        std::min(walk.tail.size(), static_cast<std::size_t>(std::ceil(shown)) + 1);
    if (most == 0) return {};
    const std::size_t stride = (n + most - 1) / most;
    std::vector<Snapshot> frames;
    for (std::size_t i = walk.tail.size() - n; i < walk.tail.size(); i += stride)
        frames.push_back(walk.tail[i]);
    return frames;
}

void write_animation(const CommandOptions& options, const WalkCase& walk_case, const Walk& walk) {
    const auto frames = frames_of(walk, static_cast<std::size_t>(walk_case.frames));
    if (frames.empty()) return;
    const std::string folder = options.output + "/animation";
    io::make_output_folder(folder);
    walking::write_walk_animation(folder, walk_case, frames, {files::version, walk_again});
    options.write(io::paraview_macro_name, std::string(io::paraview_script));
}

void write_page(const CommandOptions& options, const WalkCase& walk_case, const Walk& walk) {
    report::Document document = walking::walk_document({walk_case, walk});
    document.files = {{"all numbers", "summary.json"},
                      {"means of the run, window by window", "windows.csv"},
                      {"motion and forces at its end", "motion.csv"},
                      {"the case, resolved", resolved_case_name}};
    if (walk_case.frames > 0)
        document.files.emplace_back("the body in motion, for ParaView", "animation/machine.ex2");
    options.write_report(document, walk_again);
}

}  // namespace

void run_walking(RunCommandOptions options) {
    const WalkCase walk_case = walking::read_walk_case(options.file, options.overrides);
    options.choose_folder();
    const std::string resolved = walking::write_walk_case(walk_case);
    Walk walk;
    options.fill({{resolved_case_name, "summary.json", "report.html", "windows.csv", "motion.csv",
                   "animation/machine.ex2", io::paraview_macro_name}},
                 [&] {
                     options.write(resolved_case_name, resolved);
                     io::ProgressBar bar = options.progress_bar("walk", "part");
                     walk = walking::walk(walk_case, report_recording,
                                          [&](int done, int total) { bar.update(done, total); });
                     bar.finish(std::string(word_of(walk.result.regime)));
                     options.write("summary.json",
                                   walking::walk_summary(walk_case, resolved, walk));
                     options.write("windows.csv", walking::windows_csv(walk_case, walk));
                     options.write("motion.csv", walking::motion_csv(walk_case, walk));
                     write_animation(options, walk_case, walk);
                     if (options.report) write_page(options, walk_case, walk);
                 });
    if (!options.quiet || options.json)
        options.answer(Answer([&] { return walking::walk_summary(walk_case, resolved, walk); },
                              walking::walk_text(walk_case, walk)));
    options.say(options.where());
}

}  // namespace tricontact::app

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <iostream>

#include "app/commands/commands.h"
#include "app/studies/compute_point.h"
#include "app/studies/point_runs.h"
#include "app/studies/sweep_points.h"
#include "comparisons/quantities/reference.h"
#include "comparisons/shakedown/line_fit_document.h"
#include "comparisons/shakedown/study_fit.h"
#include "contact/bodies/line_contact_scales.h"
#include "contact/error.h"
#include "contact/load_path.h"
#include "files/version.h"
#include "io/case/study_reader.h"
#include "io/results/atomic_file.h"
#include "io/results/output_folder.h"
#include "io/results/result_store.h"
#include "walking/input/walk_keys.h"

namespace tricontact::app {

namespace {

using comparisons::RollingRun;

/// What the fits run along.
constexpr std::array<std::string_view, 4> variables{"rolling.amplitude", "rolling.amplitude_ratio",
                                                    "load.tangential_force",
                                                    "load.tangential_ratio"};
/// How finely the rolling is followed: extrapolated from, not compared.
constexpr std::array<std::string_view, 3> step_keys{"rolling.steps", "rolling.steps_per_quarter",
                                                    "rolling.increment"};
constexpr const char* angle_key = "rolling.angle";

template <class Keys>
bool is_one_of(std::string_view path, const Keys& keys) {
    return std::find(keys.begin(), keys.end(), path) != keys.end();
}

std::string joined(const std::string& list, const std::string& item) {
    return list.empty() ? item : list + ", " + item;
}

void require_constant_rolling(const io::Study& study, const SweepPoint& point) {
    if (!point.c.rolling)
        throw contact::InputError(study.name +
                                  ": a case without [rolling] has neither kappa nor eta; give it "
                                  "rolling.amplitude_ratio, or vary it");
    if (!contact::is_hertz_round(point.c) && !point.c.is_line_contact())
        throw contact::InputError(study.name +
                                  ": kappa and eta are those of a paraboloid or sphere, the line "
                                  "contact's figures those of a cylinder; give it such an "
                                  "indenter.shape");
    if (!comparisons::constant_loads(point.c))
        throw contact::InputError(study.name +
                                  ": kappa and eta belong to rolling under constant loads; leave "
                                  "out load.normal_amplitude_ratio and "
                                  "load.tangential_amplitude_ratio");
}

/// lambda of a study of line contacts; empty where there is none.
std::optional<double> line_shift_factor(const io::Study& study,
                                        const std::vector<SweepPoint>& points) {
    constexpr double rounding = 1e-9;
    std::optional<double> factor;
    for (const SweepPoint& point : points) {
        if (!point.c.is_line_contact()) {
            if (!factor && &point == &points.front()) return {};
            throw contact::InputError(study.name +
                                      ": line contacts are evaluated by themselves; "
                                      "take one indenter.shape");
        }
        const double ratio = point.c.indenter.length / half_space_scales(point.c).contact_radius;
        const double here = contact::line_shift_factor(point.c.materials(), ratio);
        if (factor && std::abs(here / *factor - 1) > rounding)
            throw contact::InputError(study.name +
                                      ": of line contacts the shift depends on L/a and poisson; "
                                      "vary amplitude, F_T and thickness only");
        factor = here;
    }
    return factor;
}

RollingRun run_of(const io::Study& study, const SweepPoint& point,
                  const comparisons::Results& results) {
    RollingRun run{.model = point.model,
                   .group = comparisons::direction_name(point.c.rolling->angle),
                   .point = {},
                   .angle = point.c.rolling->angle,
                   .level = point.level,
                   .results = results};
    for (std::size_t i = 0; i < study.axes.size(); ++i) {
        const io::Key& key = *study.axes[i].key;
        if (is_one_of(key.path, step_keys)) continue;
        const std::string item = io::table_heading(key) + " = " + point.values[i];
        run.point = joined(run.point, item);
        if (!is_one_of(key.path, variables) && key.path != angle_key)
            run.group = joined(run.group, item);
    }
    if (const auto amplitude = results.number(comparisons::quantities::amplitude))
        run.steps_per_quarter = contact::steps_in_quarter(*point.c.rolling, *amplitude);
    return run;
}

std::vector<RollingRun> stored_runs(const io::Study& study, const std::vector<SweepPoint>& points,
                                    const std::string& folder, const FitOptions& options) {
    const std::string path = folder + '/' + io::result_store_name;
    const std::string sweep =
        fmt::format("tricontact sweep {} --output {}", options.study_file, folder);
    if (!std::filesystem::exists(path))
        throw contact::InputError(fmt::format("{}: holds no {}; compute the study first: {}",
                                              folder, io::result_store_name, sweep));
    const io::ResultStore store(path, io::ResultStore::Mode::read);
    std::vector<RollingRun> runs;
    std::size_t n_missing = 0, n_failed = 0;
    for (const SweepPoint& point : points) {
        const auto found = store.find(point.key);
        n_missing += !found;
        n_failed += found && !found->results;
        if (found && found->results) runs.push_back(run_of(study, point, results_of(*found)));
    }
    if (n_missing > 0)
        throw contact::InputError(
            fmt::format("{}: {} of {} points of {} have not been computed; {}", path, n_missing,
                        points.size(), study.name, sweep));
    if (n_failed > 0 && !options.quiet)
        std::cerr << fmt::format("{} of {} points failed and are left out\n", n_failed,
                                 points.size());
    return runs;
}

std::string command_of(const FitOptions& options) {
    std::string text = "tricontact fit " + options.study_file;
    if (!options.output.empty()) text += " --output " + options.output;
    return text + fmt::format(" --confidence {}", options.confidence);
}

std::vector<std::pair<std::string, std::string>> settings_of(const io::Study& study,
                                                             std::size_t n_runs,
                                                             const FitOptions& options) {
    std::string varied;
    for (const auto& axis : study.axes) varied = joined(varied, std::string(axis.key->path));
    return {{"study", study.name},
            {"varied", varied},
            {"levels of refinement", std::to_string(study.levels)},
            {"runs", std::to_string(n_runs)},
            {"level of confidence", fmt::format("{}", options.confidence)}};
}

// `line_factor`: of line contacts, which have no fits.
void write(const comparisons::StudyFit& fit, std::optional<double> line_factor,
           const std::string& folder) {
    io::write_file(folder + "/fit.json", comparisons::fit_json(fit));
    io::write_file(folder + "/points.csv", comparisons::points_csv(fit));
    if (!line_factor) io::write_file(folder + "/fits.csv", comparisons::fits_csv(fit));
    io::write_file(
        folder + "/fit.html",
        report::document_html(line_factor ? comparisons::line_fit_document(fit, *line_factor)
                                          : comparisons::fit_document(fit)));
}

}  // namespace

void fit_command(const FitOptions& options) {
    const std::string folder = io::output_folder(options.output, options.study_file);
    const io::Study study = io::read_study(options.study_file, walking::walk_key_list());
    if (study.walks)
        throw contact::InputError(study.name +
                                  ": is a study of walking machines, which have neither kappa of a "
                                  "shakedown nor eta; see the report of tricontact sweep");
    const std::vector<SweepPoint> points = sweep_points(study);
    for (const SweepPoint& point : points) require_constant_rolling(study, point);

    io::OutputFolder output(folder, {{"fit.json", "points.csv", "fits.csv", "fit.html"}});
    comparisons::StudyFit fit;
    fit.title = study.title.empty() ? study.name : study.title;
    fit.command = command_of(options);
    fit.version = files::version;
    fit.confidence = options.confidence;
    fit.settings = settings_of(study, points.size(), options);
    fit.points = comparisons::rolling_points(stored_runs(study, points, folder, options));
    const bool relaxes = std::ranges::any_of(
        points, [](const SweepPoint& point) { return point.c.relaxation.has_value(); });
    if (relaxes) fit.caveat = comparisons::relaxing_caveat();
    const auto line_factor = line_shift_factor(study, points);
    output.fill([&] {
        if (!line_factor) comparisons::evaluate(fit);
        write(fit, line_factor, folder);
    });
    if (relaxes && !options.quiet) std::cerr << fit.caveat << '\n';
    if (!options.quiet)
        std::cerr << fmt::format("{} points of {} runs: open {}/fit.html\n", fit.points.size(),
                                 points.size(), folder);
}

}  // namespace tricontact::app

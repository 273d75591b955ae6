#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "app/commands/command.h"
#include "comparisons/quantities/reference.h"
#include "comparisons/shakedown/study_fit.h"
#include "contact/half_space_scales.h"
#include "contact/load_path.h"
#include "io/keys/messages.h"
#include "studies/study_kind.h"
#include "theory/rolling/rolled_law.h"
#include "walking/input/walk_keys.h"

namespace tricontact::app {

namespace {

struct FitOptions : CommandOptions {
    double confidence = 0.95;  ///< of the intervals
};

/// What the fits run along.
constexpr std::array<std::string_view, 4> variables{"rolling.amplitude", "rolling.amplitude_ratio",
                                                    "load.tangential_force",
                                                    "load.tangential_ratio"};
/// How finely the rolling is followed: extrapolated from, not compared.
constexpr std::array<std::string_view, 3> step_keys{"rolling.steps", "rolling.steps_per_quarter",
                                                    "rolling.increment"};
constexpr const char* angle_key = "rolling.angle";

/// The law of friction of a case. No study varies it: keys can be varied, but not left out.
const theory::RolledLaw& law_of(const FitOptions& options, const Case& c) {
    const std::string place = options.file + ": friction";
    if (c.is_line_contact()) c.require_coulomb("a fit of line contacts", place);
    return theory::require_rolled_law(c, "kappa and eta", place);
}

void require_constant_rolling(const FitOptions& options, const Case& c) {
    if (!c.rolling)
        options.refuse(
            "a case without [rolling] has neither kappa nor eta; give it "
            "rolling.amplitude_ratio, or vary it");
    if (!contact::is_hertz_round(c) && !c.is_line_contact())
        options.refuse(
            "kappa and eta are those of a paraboloid or sphere, the line contact's figures "
            "those of a cylinder; give it such an indenter.shape");
    if (c.load.is_by_limit())
        options.refuse(
            fmt::format("{}: models are compared and fitted at one F_T, not each at its own; vary "
                        "load.tangential_ratio",
                        c.load.limit_key()));
    if (!comparisons::constant_loads(c))
        options.refuse(
            "kappa and eta belong to rolling under constant loads; leave out "
            "load.normal_amplitude_ratio and load.tangential_amplitude_ratio");
}

/// lambda of a study of line contacts; empty where there is none.
std::optional<double> line_shift_factor(const FitOptions& options,
                                        const std::vector<studies::StudyPoint>& points) {
    constexpr double rounding = 1e-9;
    std::optional<double> factor;
    for (const studies::StudyPoint& point : points) {
        const Case& c = point.contact();
        if (!c.is_line_contact()) {
            if (!factor && &point == &points.front()) return {};
            options.refuse("line contacts are evaluated by themselves; take one indenter.shape");
        }
        const double here = contact::line_shift_factor(c);
        if (factor && std::abs(here / *factor - 1) > rounding)
            options.refuse(
                "of line contacts the shift depends on L/a and poisson; vary amplitude, F_T and "
                "thickness only");
        factor = here;
    }
    return factor;
}

comparisons::RollingRun run_of(const io::Study& study, const studies::StudyPoint& point,
                               const comparisons::Results& results) {
    const Case& c = point.contact();
    std::vector<std::string> stated, group{comparisons::direction_name(c.rolling->angle)};
    for (std::size_t i = 0; i < study.axes.size(); ++i) {
        const io::Key& key = *study.axes[i].key;
        if (std::ranges::count(step_keys, key.path)) continue;
        stated.push_back(io::table_heading(key) + " = " + point.values[i]);
        if (!std::ranges::count(variables, key.path) && key.path != angle_key)
            group.push_back(stated.back());
    }
    comparisons::RollingRun run{.model = point.model,
                                .group = io::joined(group),
                                .point = io::joined(stated),
                                .angle = c.rolling->angle,
                                .level = point.level,
                                .results = results};
    if (const auto amplitude = results.number(comparisons::quantities::amplitude))
        run.steps_per_quarter = contact::steps_in_quarter(*c.rolling, *amplitude);
    return run;
}

std::vector<comparisons::RollingRun> stored_runs(const io::Study& study,
                                                 const std::vector<studies::StudyPoint>& points,
                                                 const FitOptions& options) {
    const std::string &folder = options.output, path = folder + '/' + io::result_store_name;
    const std::string sweep = fmt::format("tricontact sweep {} --output {}", options.file, folder);
    if (!std::filesystem::exists(path))
        throw contact::InputError(fmt::format("{}: holds no {}; compute the study first: {}",
                                              folder, io::result_store_name, sweep));
    const io::ResultStore store(path, io::ResultStore::Mode::read);
    std::vector<comparisons::RollingRun> runs;
    std::size_t n_missing = 0, n_failed = 0;
    for (const studies::StudyPoint& point : points) {
        const auto found = store.find(point.key);
        n_missing += !found;
        n_failed += found && !found->results;
        if (const auto results = studies::results_of(found))
            runs.push_back(run_of(study, point, *results));
    }
    if (n_missing > 0)
        throw contact::InputError(
            fmt::format("{}: {} of {} points of {} have not been computed; {}", path, n_missing,
                        points.size(), study.name, sweep));
    if (n_failed > 0)
        options.say(
            fmt::format("{} of {} points failed and are left out", n_failed, points.size()));
    return runs;
}

std::vector<std::pair<std::string, std::string>> settings_of(const io::Study& study,
                                                             std::size_t n_runs,
                                                             const FitOptions& options) {
    return {{"study", study.name},
            {"varied", io::joined(study.axes, [](const auto& axis) { return axis.key->path; })},
            {"levels of refinement", std::to_string(study.levels)},
            {"runs", std::to_string(n_runs)},
            {"level of confidence", fmt::format("{}", options.confidence)}};
}

// `line_factor`: of line contacts, which have no fits.
void write(const comparisons::StudyFit& fit, std::optional<double> line_factor,
           const FitOptions& options) {
    options.write("fit.json", comparisons::fit_json(fit));
    options.write("points.csv", comparisons::points_csv(fit));
    if (!line_factor) options.write("fits.csv", comparisons::fits_csv(fit));
    options.write_report(line_factor ? comparisons::line_fit_document(fit, *line_factor)
                                     : comparisons::fit_document(fit),
                         fit.command, "fit.html");
}

/// Evaluates a finished sweep: kappa, eta, differences of models, beside its results.
void fit_study(FitOptions options) {
    std::string command = "tricontact fit " + options.file;
    if (!options.output.empty()) command += " --output " + options.output;
    command += fmt::format(" --confidence {}", options.confidence);
    options.choose_folder();
    const io::Study study = io::read_study(options.file, walking::walk_key_list());
    if (study.walks)
        options.refuse(
            "is a study of walking machines, which have neither kappa of a shakedown nor eta; see "
            "the report of tricontact sweep");
    const std::vector<studies::StudyPoint> points =
        studies::contact_kind().points(study, *options.makers);
    for (const studies::StudyPoint& point : points) {
        law_of(options, point.contact());
        require_constant_rolling(options, point.contact());
    }

    comparisons::StudyFit fit;
    fit.law = &law_of(options, points.front().contact());
    fit.title = study.title.empty() ? study.name : study.title;
    fit.command = command;
    fit.version = files::version;
    fit.confidence = options.confidence;
    fit.settings = settings_of(study, points.size(), options);
    fit.points = comparisons::rolling_points(stored_runs(study, points, options));
    const bool relaxes = std::ranges::any_of(points, [](const studies::StudyPoint& point) {
        return point.contact().relaxation.has_value();
    });
    if (relaxes) fit.caveat = comparisons::relaxing_caveat();
    const auto line_factor = line_shift_factor(options, points);
    options.fill({{"fit.json", "points.csv", "fits.csv", "fit.html"}}, [&] {
        if (!line_factor) comparisons::evaluate(fit);
        write(fit, line_factor, options);
    });
    options.answer(Answer([&] { return comparisons::fit_json(fit); }));
    if (relaxes) options.say(fit.caveat);
    for (const std::string& line : left_out_of(points)) options.say(line);
    runs::say_unread_parts(options, study, "fit");
    options.say(fmt::format("{} points of {} runs; report: {}/fit.html", fit.points.size(),
                            points.size(), options.output));
}

}  // namespace

Command fit_command() {
    return Declared<FitOptions>(Group::ask, "fit",
                                "Fit kappa and eta to a finished sweep; compare models", fit_study)
        .on_file("study", "Study file (TOML)", "STUDY.toml")
        .output("Folder of the sweep (results/<study>)")
        .exports("sweep")
        .number("--confidence", &FitOptions::confidence, "Level of the intervals (0.95)", 0.5,
                0.9999)
        .json()
        .quiet("No closing line");
}

}  // namespace tricontact::app

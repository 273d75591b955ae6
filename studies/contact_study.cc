#include <algorithm>
#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "atlas/prediction.h"
#include "atlas/shipped.h"
#include "bem/settings.h"
#include "comparisons/resolution/fineness.h"
#include "contact/models/model_kind.h"
#include "fem/settings.h"
#include "io/case/case_reader.h"
#include "io/case/rolling_on.h"
#include "io/results/output.h"
#include "report/format.h"
#include "runs/case_run.h"
#include "runs/point_key.h"
#include "studies/study_kind.h"

namespace tricontact::studies {

namespace {

using io::Study;

void check_models(const Study& study, const contact::ModelMakers& makers) {
    for (const std::string& name : study.models)
        if (!makers.has(name))
            throw contact::InputError(
                fmt::format("{}: models: this program was built without the model {}; name others",
                            study.name, name));
}

}  // namespace

StudyPoint study_point(const Study& study, const Combination& combination, const std::string& model,
                       int level) {
    try {
        std::vector<io::Entry> entries = combination.entries;
        entries.push_back(io::overriding("models", std::vector<std::string>{model}, "models"));
        StudyPoint point =
            make_point(io::resolve_case(study.base, entries), model, level, study.base.name);
        io::refuse_rolling_on(point.contact(), study.base.name);
        point.values = combination.values;
        return point;
    } catch (const contact::InputError& error) {
        const std::string values = text_of(study, combination);
        throw contact::InputError(fmt::format("{}: point {}{}{}, level {}: {}", study.name, values,
                                              values.empty() ? "" : ", ", model, level,
                                              error.what()));
    }
}

namespace {

std::string folder_of(const StudyPoint& point) {
    return "points/" + point.key;
}

contact::History history_with_files(const StudyPoint& point, const PointRuns& runs) {
    Case c = point.contact();
    c.of<io::Output>() = point.output;
    c.of<bem::Settings>().volume_depth = point.volume_depth;
    const std::string text = io::write_case(c);
    runs::RunOptions options;
    options.makers = runs.options.makers;
    options.output = runs.folder + '/' + folder_of(point);
    options.quiet = true;
    io::make_output_folder(options.output);
    options.write(runs::resolved_case_name, text);
    return runs::run_model(point.model, c, text, options);
}

comparisons::Sweep::Point reported(const StudyPoint& point, const io::ResultStore& store,
                                   const std::string& folder) {
    comparisons::Sweep::Point result{.values = {}, .model = point.model, .level = point.level};
    for (const std::string& value : point.values) result.values.push_back(cell_of(value));
    const auto outcome = store.find(point.key);
    if (const auto results = results_of(outcome)) result.results = *results;
    if (const auto why = failure_of(outcome); !why.empty()) result.error = why;
    if (std::filesystem::exists(folder + '/' + surface_file(point)))
        result.surface = surface_file(point);
    return result;
}

/// By the most complete model that an atlas is about.
std::string read_in_atlas(const Case& c) {
    const atlas::Prediction p = atlas::predict(c, atlas::predictable_models(c).back());
    return json{{"results", comparisons::stored_results(atlas::results_of(p))}, {"cpu_s", 0}}
        .dump();
}

/// What a result depends on beside case and program.
std::string other_digests(const Case& c, const std::string& model) {
    return runs::file_digests(c) +
           (contact::model_kind(model).is_read() ? std::string(atlas::shipped_digest()) : "");
}

/// Every point by every model.
class ContactKind : public StudyKind {
  public:
    StudyPoints points(const Study& study, const contact::ModelMakers& makers) const override {
        check_models(study, makers);
        const std::size_t n_each = study.models.size() * static_cast<std::size_t>(study.levels);
        StudyPoints points;
        for_each_combination(study, n_each, [&](const Combination& combination) {
            for (const std::string& model : study.models)
                for (int level = 0; level < study.levels; ++level)
                    points.push_back(study_point(study, combination, model, level));
        });
        return points;
    }

    void require_files(const StudyPoints& points) const override {
        for (const StudyPoint& point : points)
            if (point.output.vtk == io::Output::Vtk::none)
                throw contact::InputError(
                    "--vtk: output.vtk = \"none\" leaves nothing to write; set output.vtk = "
                    "\"frames\" in the case or in [set], or omit --vtk");
    }

    std::string compute(const StudyPoints& points, const Places& lot,
                        const PointRuns& runs) const override {
        const StudyPoint& point = points[lot.front()];
        if (contact::model_kind(point.model).is_read()) return read_in_atlas(point.contact());
        const contact::ModelRunner alone(*runs.options.makers, 1);
        const contact::History history = runs.folder.empty()
                                             ? alone.history_of(point.model, point.contact())
                                             : history_with_files(point, runs);
        return outcome_text(point.contact(), history);
    }

    std::vector<std::string> result_names() const override {
        std::vector<std::string> names;
        for (const auto* quantity : comparisons::column_quantities())
            names.emplace_back(quantity->key);
        return names;
    }

    report::Document report(const Study& study, const StudyPoints& points,
                            const io::ResultStore& store,
                            const std::string& folder) const override {
        comparisons::Sweep sweep{.title = {},
                                 .settings = {{"case", study.base.name},
                                              {"models", report::display_names(study.models)}},
                                 .levels = study.levels,
                                 .axes = {},
                                 .points = {}};
        if (study.levels > 1) sweep.settings.emplace_back("levels", std::to_string(study.levels));
        describe(study, sweep);
        for (const std::string& line : left_out_of(points))
            sweep.settings.emplace_back("not computed", line);
        for (const StudyPoint& point : points)
            sweep.points.push_back(reported(point, store, folder));
        return comparisons::sweep_document(sweep);
    }
};

}  // namespace

const StudyKind& contact_kind() {
    static const ContactKind kind;
    return kind;
}

std::string key_of(Case c, const std::string& model) {
    c.of<fem::Settings>().cache.clear();  // where things are kept changes no number
    return runs::point_key(io::write_case(c) + other_digests(c, model));
}

std::string outcome_text(const Case& c, const contact::History& history) {
    return json{{"results", comparisons::stored_results({c, history})},
                {"cpu_s", history.cpu_s},
                {"wall_s", history.wall_s}}
        .dump();
}

StudyPoint make_point(const Case& c, const std::string& model, int level, const std::string& name) {
    Case of_point = c;
    of_point.title.clear();
    of_point.models = {model};
    of_point.of<io::Output>() = {.vtk = io::Output::Vtk::none};
    of_point.of<bem::Settings>().volume_depth.reset();
    if (level > 0)
        of_point = io::parse_case(io::write_case(of_point), name,
                                  comparisons::level_keys(of_point, contact::model_kind(model),
                                                          {.finer = std::pow(2., level / 2.)}));
    return {.model = model,
            .level = level,
            .c = of_point,
            .output = c.of<io::Output>(),
            .volume_depth = c.of<bem::Settings>().volume_depth,
            .resolved = io::write_case(of_point),
            .key = key_of(of_point, model)};
}

std::string surface_file(const StudyPoint& point) {
    return folder_of(point) + '/' + point.model + "/surface.ex2";
}

std::optional<comparisons::Results> results_of(const std::optional<io::PointOutcome>& outcome) {
    if (!outcome || !outcome->results) return {};
    comparisons::Results results = comparisons::read_stored_results(json::parse(*outcome->results));
    results.model = outcome->model;
    return results;
}

}  // namespace tricontact::studies

#include "app/studies/sweep_points.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/commands/commands.h"
#include "app/models.h"
#include "app/studies/point_key.h"
#include "app/studies/study_combinations.h"
#include "contact/error.h"
#include "io/case/case_reader.h"
#include "io/case/case_writer.h"

namespace tricontact::app {

namespace {

using contact::Case;
using io::Study;

std::string metres_text(double value) {
    return fmt::format("\"{} m\"", value);
}

/// The resolution of a model on level k, as overrides; see RefinementPlan, which does the same.
std::vector<std::string> finer(const std::string& model, const Case& c, int k) {
    const double factor = std::pow(2., k / 2.);
    if (model == "mdr-layer")
        throw contact::InputError(
            "levels: mdr-layer chooses its elements by itself; omit levels, or leave it out");
    if (model == "mdr") return {fmt::format("mdr.springs={}", std::lround(c.mdr.springs * factor))};
    if (model.starts_with("bem"))
        return {c.bem.spacing
                    ? "bem.spacing=" + metres_text(*c.bem.spacing / factor)
                    : fmt::format("bem.cells_per_radius={}", *c.bem.cells_per_radius * factor)};
    if (!c.fem.size)
        throw contact::InputError(
            "levels: fem is refined from fem.size, which is not given; give it, or omit levels");
    constexpr double least_growth = 1.05;  // that a case file may ask for
    const double growth = std::max(std::pow(c.fem.growth, 1 / factor), least_growth);
    return {"fem.size=" + metres_text(*c.fem.size / factor), fmt::format("fem.growth={}", growth)};
}

std::string key_of(const Case& c) {
    Case content = c;
    content.fem.cache.clear();  // where things are kept changes no number
    return point_key(io::write_case(content) + file_digests(content));
}

io::Entry models_entry(const std::string& model) {
    return {.path = "models",
            .value = std::vector<std::string>{model},
            .place = "models",
            .key_place = "models"};
}

void check_models(const Study& study) {
    for (const std::string& name : study.models)
        if (std::none_of(known_models().begin(), known_models().end(),
                         [&](const auto& known) { return known.name == name; }))
            throw contact::InputError(
                fmt::format("{}: models: this program was built without the model {}; name others",
                            study.name, name));
}

SweepPoint point_of(const Study& study, const Combination& combination, const std::string& model,
                    int level) {
    try {
        std::vector<io::Entry> entries = combination.entries;
        entries.push_back(models_entry(model));
        SweepPoint point =
            make_point(io::resolve_case(study.base, entries), model, level, study.base.name);
        refuse_rolling_on(point.c, study.base.name);
        point.values = combination.values;
        return point;
    } catch (const contact::InputError& error) {
        const std::string values = text_of(study, combination);
        throw contact::InputError(fmt::format("{}: point {}{}{}, level {}: {}", study.name, values,
                                              values.empty() ? "" : ", ", model, level,
                                              error.what()));
    }
}

}  // namespace

std::vector<SweepPoint> sweep_points(const Study& study) {
    check_models(study);
    const std::size_t n_each = study.models.size() * static_cast<std::size_t>(study.levels);
    std::vector<SweepPoint> points;
    for_each_combination(study, n_each, [&](const Combination& combination) {
        for (const std::string& model : study.models)
            for (int level = 0; level < study.levels; ++level)
                points.push_back(point_of(study, combination, model, level));
    });
    return points;
}

SweepPoint make_point(const Case& c, const std::string& model, int level, const std::string& name) {
    SweepPoint point{.values = {}, .model = model, .level = level, .c = c, .output = c.output};
    point.c.title.clear();
    point.c.models = {model};
    point.c.output = {
        .vtk = Case::VtkOutput::none, .volume = Case::VolumeOutput::none, .volume_depth = {}};
    if (level > 0)
        point.c = io::parse_case(io::write_case(point.c), name, finer(model, point.c, level));
    point.resolved = io::write_case(point.c);
    point.key = key_of(point.c);
    return point;
}

}  // namespace tricontact::app

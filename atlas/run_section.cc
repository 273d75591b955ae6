#include "atlas/run_section.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "atlas/prediction.h"
#include "comparisons/quantities/quantities.h"
#include "contact/base/error.h"
#include "contact/base/special_values.h"
#include "contact/models/model_kind.h"
#include "report/format.h"

namespace tricontact::atlas {

namespace {

using comparisons::Quantity;
using comparisons::Results;
using contact::Case;
namespace quantities = comparisons::quantities;

const Quantity* const compared[] = {&quantities::static_shift_ratio,
                                    &quantities::settled_shift_ratio, &quantities::kappa,
                                    &quantities::shift_increment_ratio, &quantities::eta};

constexpr int n_amplitudes = 36, n_loads = 40;

/// Whose maps stand beside a model.
std::string mapped(const std::string& model) {
    const std::string maps = contact::model_kind(model).maps;
    return maps.empty() ? model : maps;
}

std::vector<std::string> models_of_maps(const Case& c) {
    try {
        return predictable_models(c);
    } catch (const contact::InputError&) {
        return {};
    }
}

/// The case at another amplitude over its own radius and another load over mu F_N.
Case moved(Case c, double w, double f) {
    c.rolling->amplitude.reset();
    c.rolling->amplitude_ratio = w;
    c.rolling->amplitude_reference = Case::AmplitudeReference::model;
    c.load.set_tangential_ratio(f);
    return c;
}

std::vector<double> steps_to(double end, int n) {
    std::vector<double> values;
    for (int i = 1; i <= n; ++i) values.push_back(end * i / n);
    return values;
}

report::Figure figure_of(const Case& c, const Prediction& here) {
    constexpr double right_end = .85;
    const std::string model = report::display_name(here.model);
    report::ContourMap map{.label = "u_sd",
                           .x = steps_to(right_end, n_amplitudes),
                           .y = steps_to(1, n_loads),
                           .values = {}};
    for (const double f : map.y)
        for (const double w : map.x) {
            const Prediction there = predict(moved(c, w, std::min(f, 1 - 1e-9)), here.model);
            const auto* u = there.find(quantities::settled_shift_ratio);
            map.values.push_back(u ? u->value.value : contact::undefined);
        }
    report::Curve limit{.name = "limit of shakedown f_T,lim", .theory = true};
    for (const double w : map.x) {
        const Prediction there = predict(moved(c, w, .5), here.model);
        if (const auto* f = there.find(quantities::limit_tangential_ratio))
            limit.add(w, f->value.value);
    }
    report::Curve point{.name = "this case", .kind = report::Curve::Kind::points, .colour = 0};
    const auto* w = here.find(quantities::amplitude_ratio);
    const auto* f = here.find(quantities::tangential_ratio);
    if (w && f) point.add(w->value.value, f->value.value);
    return {.id = "place_in_maps",
            .title = "Where the case lies",
            .caption = fmt::format(
                "Settled shift u_sd = U_sd/U_max of {} over amplitude and load, at the direction, "
                "Poisson's ratio, friction and thickness of the case, from {}; "
                "without colour where they do not reach. Above the limit contacts ratchet.",
                model, fmt::join(here.rests_on, ", ")),
            .x = {.label = "w = W/a", .low = 0, .high = right_end},
            .y = {.label = c.friction.is_coulomb() ? "f_T = F_T/(mu F_N)" : "f_T = F_T/F_lim",
                  .low = 0,
                  .high = 1},
            .curves = {limit, point},
            .map = map};
}

report::DocumentTable table_of(const Case& c, const std::vector<Results>& results,
                               const std::vector<std::string>& models) {
    report::DocumentTable table{
        .id = "beside_maps",
        .title = "The run beside the maps",
        .note =
            "± is the half width of the maps' bar of 95 %; FEM stands beside the maps of "
            "boundary elements on the layer. The run's own error, of its cells and steps, is "
            "not in the bar.",
        .columns = report::columns("model", "result", "run", "maps", "run/maps - 1 [%]:2")};
    table.columns.back().change = true;
    for (const Results& run : results) {
        if (std::ranges::count(models, mapped(run.model)) == 0) continue;
        const Prediction maps = predict(c, mapped(run.model));
        for (const Quantity* q : compared) {
            const auto* entry = maps.find(*q);
            const auto computed = run.number(*q);
            if (!entry || !computed) continue;
            const auto [value, error] = entry->value;
            table.rows.push_back({report::display_name(run.model), std::string(q->symbol),
                                  *computed, report::WithError{value, error},
                                  100 * (*computed / value - 1)});
        }
    }
    return table;
}

}  // namespace

std::optional<report::DocumentSection> place_in_maps(const Case& c,
                                                     const std::vector<Results>& results) {
    if (!c.rolling) return {};
    const std::vector<std::string> models = models_of_maps(c);
    std::string drawn;
    for (const std::string& model : models)
        if (std::ranges::any_of(results,
                                [&](const Results& r) { return mapped(r.model) == model; }))
            drawn = model;
    if (drawn.empty()) return {};
    const Prediction here = predict(c, drawn);
    report::DocumentSection section{.id = "maps", .heading = "The case in the maps"};
    section.paragraphs.push_back(
        "The shipped maps predict contacts at other amplitudes and loads without a run: tricontact "
        "predict.");
    for (const std::string& gap : here.gaps)
        section.paragraphs.push_back("Not predicted: " + gap + ".");
    section.figures.push_back(figure_of(c, here));
    report::DocumentTable table = table_of(c, results, models);
    if (!table.rows.empty()) section.tables.push_back(std::move(table));
    return section;
}

}  // namespace tricontact::atlas

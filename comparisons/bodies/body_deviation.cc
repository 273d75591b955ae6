#include "comparisons/bodies/body_deviation.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <nlohmann/json.hpp>

#include "comparisons/quantities/model_traits.h"
#include "comparisons/quantities/quantities.h"
#include "contact/models/model_kind.h"
#include "report/format.h"
#include "report/json_number.h"

namespace tricontact::comparisons {

namespace {

using contact::Case;
using contact::ElasticBody;
using json = nlohmann::ordered_json;
using Row = BodyDeviation::Row;

const Results* results_of(const std::vector<Results>& results, const std::string& model) {
    const auto found = std::ranges::find(results, model, &Results::model);
    return found == results.end() ? nullptr : &*found;
}

const NumericalError* error_of(const std::vector<NumericalError>& errors,
                               const std::string& model) {
    const auto found = std::ranges::find(errors, model, &NumericalError::model);
    return found == errors.end() || !found->why_none.empty() ? nullptr : &*found;
}

/// In the order of the table: pressed, loaded, rolled. Without rolling a limit is 1 of itself.
std::vector<const Quantity*> compared_quantities(const Case& c) {
    using namespace quantities;
    std::vector<const Quantity*> list{&normal_force,  &indentation,      &contact_radius,
                                      &peak_pressure, &normal_stiffness, &unit_shift,
                                      &static_shift};
    if (c.rolling)
        list.insert(list.end(), {&limit_tangential_ratio, &settled_shift, &shift_increment});
    for (const Quantity* q : prescribed_quantities(c)) std::erase(list, q);
    return list;
}

/// Whether there is a load for a shift to be of.
bool is_pulled(const Results& r) {
    return is_loaded(r.number(quantities::tangential_ratio).value_or(0));
}

bool tells_something(const Quantity* q, const Results& r) {
    const bool is_shift = q == &quantities::static_shift;
    return r.told(*q) && *r.told(*q) != 0 && (!is_shift || is_pulled(r));
}

/// "1.20 times", "0.83 of"
std::string told(const Row& row) {
    const std::string by = report::percent(1 + row.deviation());
    const auto error = row.error();
    return fmt::format("{} {}{}", row.label, by,
                       error ? " ± " + report::share(*error) : std::string());
}

bool is_resolved(const Row& row) {
    const auto error = row.error();
    return !error || std::abs(row.deviation()) > *error;
}

}  // namespace

std::optional<double> Row::error() const {
    if (!body_error || !half_space_error) return {};
    return std::abs(half_space / body) *
           (*body_error / std::abs(body) + *half_space_error / std::abs(half_space));
}

std::optional<BodyPair> body_pair(const Case& c) {
    if (!c.indenter.body) return {};
    BodyPair pair;
    for (const std::string& model : c.models)
        if (contact::model_kind(model).sees_indenter_body) pair.body = model;
    if (pair.body.empty()) return {};
    const unsigned own = traits_of(c, pair.body);
    int least = 0;
    for (const std::string& model : c.models) {
        const unsigned set = traits_of(c, model);
        if (!(set & half_space_indenter)) continue;
        const int size =
            2 * std::popcount(set & ~own) + (contact::model_kind(model).is_on_cells() ? 0 : 1);
        if (!pair.half_space.empty() && size > least) continue;
        pair.half_space = model;
        least = size;
    }
    return pair.half_space.empty() ? std::nullopt : std::optional(pair);
}

std::optional<BodyDeviation> body_deviation(const Case& c, const std::vector<Results>& results,
                                            const LoadingStudy& study,
                                            const std::vector<NumericalError>& errors) {
    const auto pair = body_pair(c);
    if (!pair) return {};
    const Results* body = results_of(results, pair->body);
    const Results* half_space = results_of(results, pair->half_space);
    if (!body || !half_space) return {};
    BodyDeviation deviation{.models = *pair};
    deviation.others = names_of(traits_of(c, pair->half_space) & ~traits_of(c, pair->body) &
                                ~static_cast<unsigned>(half_space_indenter));
    const NumericalError *of_body = error_of(errors, pair->body),
                         *of_half_space = error_of(errors, pair->half_space);
    const auto width = [](const NumericalError* error, const Quantity& q) {
        return error ? error->of(q) : std::nullopt;
    };
    const auto add_stiffness = [&] {
        const auto ours = study.tangential_stiffness.find(pair->body),
                   theirs = study.tangential_stiffness.find(pair->half_space);
        if (ours == study.tangential_stiffness.end() || theirs == study.tangential_stiffness.end())
            return;
        const Quantity& q = quantities::tangential_stiffness;
        deviation.rows.push_back({q.key, "tangential stiffness k_t", q.unit, q.over, ours->second,
                                  theirs->second, width(of_body, q), width(of_half_space, q)});
    };
    for (const Quantity* q : compared_quantities(c)) {
        if (q == &quantities::unit_shift) add_stiffness();
        if (!tells_something(q, *body) || !tells_something(q, *half_space)) continue;
        deviation.rows.push_back({q->key, label_of(*q), q->unit, q->over, *body->told(*q),
                                  *half_space->told(*q), width(of_body, *q),
                                  width(of_half_space, *q)});
    }
    return deviation;
}

std::vector<std::string> body_deviation_sentences(const Case& c, const BodyDeviation& deviation) {
    const std::string body = report::display_name(deviation.models.body),
                      half_space = report::display_name(deviation.models.half_space);
    std::vector<std::string> list, lost;
    for (const Row& row : deviation.rows)
        is_resolved(row) ? list.push_back(told(row)) : lost.push_back(row.label);
    std::vector<std::string> sentences;
    if (!list.empty())
        sentences.push_back(
            fmt::format("A half-space in place of the indenter's body ({} beside "
                        "{}) changes: {}.",
                        half_space, body, fmt::join(list, ", ")));
    if (!lost.empty())
        sentences.push_back(
            fmt::format("Less than what meshes and steps leave: {}.", fmt::join(lost, ", ")));
    if (!deviation.others.empty())
        sentences.push_back(
            fmt::format("These numbers hold for all that {} takes for granted: "
                        "indenter as half-space, {}.",
                        half_space, deviation.others));
    if (c.is_line_contact() && !deviation.rows.empty())
        sentences.emplace_back(
            "In plane strain depth and shifts of a half-space grow with the logarithm of its "
            "length: "
            "how far they are off goes with indenter.length. Those of force, size and pressure do "
            "not.");
    const bool knows_u_max =
        std::ranges::find(deviation.rows, std::string(quantities::unit_shift.key), &Row::key) !=
        deviation.rows.end();
    if (c.indenter.body->support == ElasticBody::Support::plates && knows_u_max)
        sentences.emplace_back(
            "Nothing holds a body between plates against a tangential force: its U_max is that of "
            "the half held along x in the middle plane.");
    if (c.indenter.body->is_loose() && knows_u_max)
        sentences.emplace_back(
            "Nothing holds a body that a pressure presses against a tangential force: its U_max is "
            "that of the body held at the face that the pressure loads.");
    return sentences;
}

report::DocumentTable body_deviation_table(const BodyDeviation& deviation) {
    const std::string body = report::display_name(deviation.models.body),
                      half_space = report::display_name(deviation.models.half_space);
    report::DocumentTable table{
        .id = "half_space_deviation",
        .title = "The indenter's body beside a half-space",
        .note = fmt::format("Deviation: {} over {} minus 1. ±: what mesh and steps leave in either "
                            "model; of the deviation both together. k_t: F_T over U as F_T sets "
                            "in, everything sticking, pressed without friction.",
                            half_space, body),
        .columns = report::columns("quantity", "unit", body, half_space)};
    table.columns.push_back({.heading = "deviation [%]", .change = true});
    table.columns.push_back({.heading = "± [%]", .digits = 2});
    const auto cell = [](double value, std::optional<double> error, double factor) {
        return error && *error > 0
                   ? report::Cell(report::WithError{value / factor, *error / factor})
                   : report::number_cell(value, factor);
    };
    for (const Row& row : deviation.rows) {
        const report::Unit unit = *row.unit ? report::fitting_unit(std::abs(row.body), row.unit)
                                            : report::Unit{1, row.over};
        table.rows.push_back({row.label, unit.symbol, cell(row.body, row.body_error, unit.factor),
                              cell(row.half_space, row.half_space_error, unit.factor),
                              100 * row.deviation(), report::number_cell(row.error(), .01)});
    }
    return table;
}

json body_deviation_json(const BodyDeviation& deviation) {
    json rows = json::object();
    for (const Row& row : deviation.rows)
        rows[row.key] = {{"body", report::number(row.body)},
                         {"body_half_width", report::number(row.body_error)},
                         {"half_space", report::number(row.half_space)},
                         {"half_space_half_width", report::number(row.half_space_error)},
                         {"deviation", report::number(row.deviation())},
                         {"deviation_half_width", report::number(row.error())}};
    return {{"body_model", deviation.models.body},
            {"half_space_model", deviation.models.half_space},
            {"other_assumptions", deviation.others.empty() ? json() : json(deviation.others)},
            {"quantities", rows}};
}

}  // namespace tricontact::comparisons

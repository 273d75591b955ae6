// Laws of friction beside tables and a record: sentences, tables, a figure and JSON.

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "contact/base/special_values.h"
#include "experiments/identification/identification_report.h"
#include "experiments/predictions/record_laws.h"
#include "experiments/records/experiment_report.h"
#include "io/keys/messages.h"
#include "report/format.h"
#include "report/json_number.h"

namespace tricontact::experiments {

namespace {

using report::Verdict;
using enum Verdict::Standing;

std::string law_at(const RecordLaws& laws, std::size_t i) {
    return law_name(laws.tables.laws[i]);
}

/// The law of one number that alone of these is left.
std::optional<std::size_t> only_simple_one(const RecordLaws& laws,
                                           const std::vector<std::size_t>& left) {
    std::optional<std::size_t> only;
    int n_compared = 0;
    for (std::size_t i = 0; i < laws.laws.size(); ++i) {
        if (laws.tables.laws[i].law->n_numbers() > 1) continue;
        ++n_compared;
        if (!std::ranges::count(left, i)) continue;
        if (only) return {};
        only = i;
    }
    return n_compared > 1 ? only : std::nullopt;
}

Verdict laws_supported(const RecordLaws& laws) {
    const auto left = laws.supported();
    if (laws.laws.size() == 1)
        return {finding, fmt::format("One law of friction, {}, was named: it was not compared with "
                                     "others.",
                                     law_at(laws, 0))};
    if (left.empty())
        return {fail,
                "None of the laws of friction explains tables and record; their numbers are not to "
                "be used before the reason is known."};
    if (laws.named)
        return {finding, fmt::format("Tables and record support the law of friction {}.",
                                     law_at(laws, *laws.named))};
    std::string sentence = "Tables and record cannot tell the laws of friction " +
                           io::joined(left, [&](std::size_t i) { return law_at(laws, i); }) +
                           " apart.";
    if (const auto simple = only_simple_one(laws, left))
        sentence += fmt::format(" Of those of one number {} alone is left.", law_at(laws, *simple));
    for (const std::size_t i : left)
        if (const std::string& room = laws.tables.laws[i].not_told_from; !room.empty())
            sentence += fmt::format(" Beside {} the tables leave room for {}.",
                                    laws.tables.laws[i].law->name, room);
    return {not_resolved,
            sentence + " Measure the force of full sliding over a wider range of loads."};
}

std::string limit_text(const RecordedLaw& law) {
    return fmt::format("W_lim = {} mm by the law's closed form, measured from {} to {} mm",
                       report::with_error(mm * law.predicted_limit->value,
                                          mm * law.predicted_limit->half_width(), 3),
                       report::significant(mm * law.measured_limit->low, 3),
                       report::significant(mm * law.measured_limit->high, 3));
}

std::string model_text(const ExperimentEvaluation& e, const SeriesDeviation& one) {
    if (is_of_springs(one.model)) {
        const ComparisonError& error = static_deviation(e, one.model).error;
        return fmt::format("{}: U_stat measured minus computed {} µm",
                           report::display_name(one.model),
                           report::with_error(um * error.difference(), um * error.half_width(), 3));
    }
    const std::size_t n = one.error.furthest();
    return fmt::format(
        "{}: measured minus computed {} µm at n = {}", report::display_name(one.model),
        report::with_error(um * one.error.values[n].difference(), um * one.error.half_width(n), 3),
        n);
}

std::string record_text(const RecordLaws& laws, std::size_t i) {
    const RecordedLaw& law = laws.laws[i];
    if (const auto end = laws.end_of(i))
        return fmt::format("its numbers are at the end of their range, where it is {}",
                           law_at(laws, *end));
    if (!law.evaluation) return "the record is not compared: " + law.why_not;
    if (law.measured_limit) return limit_text(law);
    if (law.evaluation->series.empty()) return "the record has no limit";
    std::vector<std::string> models;
    for (const SeriesDeviation& one : law.evaluation->series)
        models.push_back(model_text(*law.evaluation, one));
    return fmt::format("{}", fmt::join(models, "; "));
}

Verdict law_verdict(const RecordLaws& laws, std::size_t i) {
    const LawFit& fit = laws.tables.laws[i];
    const RecordedLaw& law = laws.laws[i];
    const auto differs = law.differs();
    std::string ending = differs == true       ? ": the record disagrees"
                         : differs.has_value() ? ": the record agrees"
                         : law.evaluation      ? ": the record cannot tell"
                                               : "";
    if (fit.is_excluded()) ending += "; the tables exclude it (" + fit.why_excluded + ")";
    Verdict verdict{law.is_excluded()  ? violated
                    : differs == false ? holds
                                       : not_resolved,
                    fmt::format("{}, {}: {}{}.", law_name(fit), law_numbers(fit),
                                record_text(laws, i), ending)};
    verdict.subject = "law of friction: " + law_name(fit);
    verdict.number = law_numbers(fit);
    verdict.effect = record_text(laws, i) + ending;
    return verdict;
}

report::DocumentTable record_table(const RecordLaws& laws) {
    report::DocumentTable table{
        .id = "laws_and_record",
        .title = "The record under each law",
        .note =
            "Largest difference over all periods in its half widths, which hold for all of "
            "them in 95 %; of springs, which settle otherwise than a half-space does, U_stat, "
            "which counts where they are the only models; of limit runs W_lim by the law's "
            "closed form. The numbers of each law are those of the tables.",
        .columns = report::columns("law", "numbers", "measured and computed", "record", "verdict")};
    for (std::size_t i = 0; i < laws.laws.size(); ++i) {
        const auto differs = laws.laws[i].differs();
        table.rows.push_back({law_at(laws, i), law_numbers(laws.tables.laws[i]),
                              record_text(laws, i),
                              !differs   ? "not resolved"
                              : *differs ? "disagrees"
                                         : "agrees",
                              laws.laws[i].is_excluded() ? "excluded: " + laws.laws[i].why_excluded
                                                         : "not excluded"});
    }
    return table;
}

/// By the model that was named last, the most complete one as cases list them.
std::optional<report::Figure> laws_figure(const RecordLaws& laws) {
    report::Figure figure{.id = "laws_over_periods",
                          .title = "Shift over the rolling periods, by law of friction",
                          .caption =
                              "U upright: measured, and by the last model of the case under "
                              "each law with the numbers of the tables.",
                          .x = {"period n [-]"},
                          .y = {"shift U [µm]"}};
    const ExperimentEvaluation* any = nullptr;
    for (std::size_t i = 0; i < laws.laws.size(); ++i) {
        const auto& evaluation = laws.laws[i].evaluation;
        if (!evaluation || evaluation->predictions.empty()) continue;
        any = &*evaluation;
        report::Curve& curve = figure.curves.emplace_back(
            report::Curve{.name = std::string(laws.tables.laws[i].law->name)});
        const auto& shift = evaluation->predictions.back().shift;
        for (std::size_t n = 0; n < shift.size(); ++n)
            curve.add(static_cast<double>(n), um * shift[n]);
    }
    if (!any) return {};
    report::Curve measured{.name = "measured", .kind = report::Curve::Kind::points};
    for (std::size_t n = 0; n < any->shift.size(); ++n) {
        measured.add(static_cast<double>(n), um * any->shift[n].value);
        measured.y_error.push_back(um * any->shift[n].half_width());
    }
    figure.curves.push_back(std::move(measured));
    return figure;
}

}  // namespace

std::vector<Verdict> record_law_verdicts(const RecordLaws& laws) {
    std::vector<Verdict> verdicts{laws_supported(laws)};
    for (std::size_t i = 0; i < laws.laws.size(); ++i) verdicts.push_back(law_verdict(laws, i));
    return verdicts;
}

report::DocumentSection record_law_section(const RecordLaws& laws) {
    report::DocumentSection section{.id = "friction_laws",
                                    .heading = "Laws of friction",
                                    .tables = {record_table(laws), law_table(laws.tables)}};
    if (auto figure = laws_figure(laws)) section.figures.push_back(std::move(*figure));
    return section;
}

nlohmann::ordered_json record_law_json(const RecordLaws& laws) {
    using json = nlohmann::ordered_json;
    json compared = json::object();
    for (std::size_t i = 0; i < laws.laws.size(); ++i) {
        const RecordedLaw& law = laws.laws[i];
        json models = json::object();
        if (law.evaluation)
            for (const SeriesDeviation& one : law.evaluation->series)
                models[one.model] = series_json(one);
        const auto limit = [](const std::optional<Estimate>& w) {
            return w ? json{{"low", w->low}, {"value", w->value}, {"high", w->high}} : json();
        };
        compared[std::string(laws.tables.laws[i].law->name)] = {
            {"record_differs", law.differs()},
            {"models", std::move(models)},
            {"measured_limit_m", limit(law.measured_limit)},
            {"predicted_limit_m", limit(law.predicted_limit)},
            {"why_not_compared", law.why_not},
            {"is_excluded", law.is_excluded()},
            {"reason", law.why_excluded}};
    }
    return {{"tables", law_json(laws.tables)},
            {"record", std::move(compared)},
            {"named", laws.named ? json(laws.tables.laws[*laws.named].law->name) : json(nullptr)},
            {"best", laws.tables.laws[laws.best].law->name}};
}

}  // namespace tricontact::experiments

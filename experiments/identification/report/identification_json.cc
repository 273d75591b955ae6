
#include <nlohmann/json.hpp>

#include "experiments/identification/estimation/told_combination.h"
#include "experiments/identification/identification_report.h"
#include "experiments/identification/report/loop_report.h"
#include "report/json_number.h"

namespace tricontact::experiments {

namespace {

using json = nlohmann::ordered_json;

// An open end of an interval is null.
json interval_json(const Interval& interval) {
    return json::array({interval.low, interval.high});
}

json estimate_json(const IdentifiedModel& model, std::size_t k) {
    const ParameterEstimate& estimate = model.found.parameters[k];
    json inputs = json::object();
    for (const InputContribution& input : model.contributions) inputs[input.key] = input.change[k];
    return {{"value", estimate.value},
            {"standard_error", estimate.standard_error},
            {"interval", interval_json(full_interval(model, k))},
            {"linearised_interval", interval_json({estimate.low, estimate.high})},
            {"likelihood_interval", interval_json(estimate.likelihood)},
            {"change_by_standard_errors_of_inputs", inputs},
            {"combined_standard_error", combined_standard_error(model, k)}};
}

json posterior_json(const IdentifiedModel& model) {
    if (!model.posterior) return nullptr;
    const Posterior& p = *model.posterior;
    json result{{"points", p.points.size()},
                {"effective_size", p.effective_size},
                {"autocorrelation_time", p.autocorrelation_time},
                {"acceptance", p.acceptance}};
    const auto& free = model.found.free;
    for (std::size_t k = 0; k < free.size(); ++k)
        result[free[k].name] = {{"median", p.median[k]},
                                {"interval", interval_json(p.interval[k])}};
    for (std::size_t i = 0; i < free.size(); ++i)
        for (std::size_t k = i + 1; k < free.size(); ++k)
            result["correlations"][free[i].name][free[k].name] = p.correlation[i][k];
    return result;
}

json correlation_json(const TableResiduals& residuals) {
    json result{{"has_pattern", residuals.has_pattern},
                {"has_strong_pattern", residuals.has_strong_one},
                {"lack_of_fit", residuals.lack_of_fit}};
    if (const auto& found = residuals.correlation)
        result.update({{"correlation_of_neighbours", found->lag_one},
                       {"chance", found->chance},
                       {"correlation_of_errors", found->of_errors},
                       {"correlation_not_excluded", found->not_excluded}});
    return result;
}

json outlying_json(const IdentificationStudy& study, const Identification& found) {
    json list = json::array();
    for (const statistics::OutlyingRow& one : found.outlying) {
        std::size_t t = 0, row = one.row;
        while (row >= study.input.tables[t].observed.size())
            row -= study.input.tables[t++].observed.size();
        json without;
        for (std::size_t k = 0; k < found.free.size(); ++k)
            without[found.free[k].name] =
                found.free[k].changed(found.parameters[k].value, one.change[k]);
        list.push_back({{"table", name_of(study.input.tables[t])},
                        {"row", row + 1},
                        {"deviation_over_standard_error", one.deviation},
                        {"chance", one.chance},
                        {"values_without", without}});
    }
    return list;
}

json table_json(const TableFit& fit, const TableResiduals& residuals) {
    return {{"origin", fit.origin},
            {"fitted", fit.fitted},
            {"residuals", fit.residuals},
            {"standard_errors", fit.standard_errors},
            {"sum_of_squares", fit.sum_of_squares},
            {"degrees_of_freedom", fit.degrees_of_freedom},
            {"residual_standard_deviation", fit.residual_standard_deviation},
            {"r_squared", fit.r_squared},
            {"goodness", fit.goodness},
            {"residual_pattern", correlation_json(residuals)}};
}

json combinations_json(const Identification& found) {
    json list = json::array();
    for (const ToldCombination& one : told_combinations(found)) {
        json exponents;
        for (std::size_t i = 0; i < one.parameters.size(); ++i)
            exponents[found.free[one.parameters[i]].name] = one.exponents[i];
        list.push_back({{"exponents", exponents}, {"relative_standard_error", one.standard_error}});
    }
    return list;
}

json model_json(const IdentifiedModel& model, const IdentificationStudy& study) {
    const Identification& found = model.found;
    json result;
    for (const FreeParameter& p : study.input.parameters) {
        const auto k = found.find(p.key, p.index);
        result[p.name] = k ? estimate_json(model, *k) : json(nullptr);
    }
    for (std::size_t i = 0; i < found.free.size(); ++i)
        for (std::size_t k = i + 1; k < found.free.size(); ++k)
            result["correlations"][found.free[i].name][found.free[k].name] =
                found.correlation(i, k);
    result["told_combinations"] = combinations_json(found);
    result["sum_of_squares"] = found.sum_of_squares;
    result["degrees_of_freedom"] = found.degrees_of_freedom;
    result["r_squared"] = found.r_squared;
    result["goodness"] = found.goodness;
    result["is_rejected"] = is_rejected(model);
    result["has_pattern"] = found.has_pattern();
    result["outlying_rows"] = outlying_json(study, found);
    for (std::size_t k = 0; k < found.widening.size(); ++k)
        result["widening_by_correlated_errors"][found.free[k].name] = found.widening[k];
    result["possible_widening"] = found.possible_widening;
    result["interpolation_error"] = model.interpolation_error;
    result["posterior"] = posterior_json(model);
    for (std::size_t t = 0; t < found.tables.size(); ++t)
        result["tables"][name_of(study.input.tables[t])] =
            table_json(found.tables[t], found.residuals.at(t));
    return result;
}

/// "young_over_reference": the name without its unit.
std::string ratio_name(const FreeParameter& p) {
    std::string name = p.name.starts_with("friction") ? "friction" : p.name;
    if (!p.unit.empty()) name.resize(name.rfind('_'));
    return name + "_over_reference";
}

}  // namespace

json identification_json(const IdentificationStudy& study) {
    json result;
    result["version"] = study.version;
    result["command"] = study.command;
    result["title"] = study.title;
    result["confidence"] = study.models.front().found.confidence;
    for (const auto& [name, value] : study.settings) result["settings"][name] = value;
    for (const auto& table : study.input.tables)
        result["tables"][name_of(table)] = {{"given", table.given},
                                            {"observed", table.observed},
                                            {"standard_errors", table.standard_errors}};
    for (const auto& table : study.input.tables)
        if (!table.normal_forces.empty())
            result["tables"][name_of(table)]["normal_forces"] = table.normal_forces;
    const IdentifiedModel& reference = reference_model(study);
    result["reference"] = reference.name;
    result["thickness_over_contact_width"] = study.thickness_ratio;
    for (const IdentifiedModel& model : study.models) {
        json values = model_json(model, study);
        for (std::size_t k = 0; k < model.found.free.size(); ++k) {
            const FreeParameter& p = model.found.free[k];
            if (const auto other = reference.found.find(p.key, p.index))
                values[ratio_name(p)] =
                    model.found.parameters[k].value / reference.found.parameters[*other].value;
        }
        result["models"][model.name] = std::move(values);
    }
    if (study.loops) result["friction_loops"] = loop_json(*study.loops);
    if (study.laws) result["laws_of_friction"] = law_json(*study.laws);
    if (study.interfaces) result["interfaces"] = interface_json(*study.interfaces);
    result["verdicts"] = report::list_of(identification_verdicts(study),
                                         [](const auto& verdict) { return verdict.sentence; });
    return result;
}

}  // namespace tricontact::experiments

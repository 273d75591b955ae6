#include "comparisons/finite_strain/strain_output.h"

#include <nlohmann/json.hpp>

#include "report/csv.h"
#include "report/json_number.h"

namespace tricontact::comparisons {

namespace {

using json = nlohmann::ordered_json;

json threshold_json(double tolerance, const std::optional<StrainThreshold>& threshold) {
    if (!threshold) return {{"deviation", tolerance}, {"known", false}};
    return {{"deviation", tolerance},       {"known", true},
            {"from", threshold->at},        {"from_begin", threshold->from_begin},
            {"low", threshold->low},        {"high", threshold->high},
            {"returns", threshold->returns}};
}

json thresholds_json(const StrainDeviation& deviation, const Quantity* q, StrainAxis axis) {
    const auto points = deviation_along(deviation, q, axis);
    json list = json::array();
    for (const double tolerance : strain_tolerances)
        list.push_back(threshold_json(
            tolerance, strain_threshold(points, tolerance, axis == StrainAxis::normal_force)));
    return list;
}

json row_json(const StrainDeviation& deviation, const StrainRow& row) {
    return {{"linear", row.linear},
            {"finite_strains", row.finite},
            {"deviation", row.deviation},
            {"error", row.error},
            {"force", thresholds_json(deviation, row.quantity, StrainAxis::normal_force)},
            {"thickness", thresholds_json(deviation, row.quantity, StrainAxis::thickness)},
            {quantities::tangential_ratio.key,
             thresholds_json(deviation, row.quantity, StrainAxis::tangential_ratio)}};
}

json pair_json(const StrainContact& contact, const StrainPair& pair) {
    const StrainPoint& point = pair.point;
    json values = json::object();
    for (const Quantity* q : strain_quantities) {
        const double *linear = found(pair.linear, q), *finite = found(pair.finite, q);
        if (!linear && !finite) continue;
        values[q->key] = {{"linear", linear ? json(*linear) : json()},
                          {"finite_strains", finite ? json(*finite) : json()},
                          {"deviation", pair.deviation(q)}};
    }
    return {
        {quantities::normal_force.key, point.normal_force},
        {"thickness_m", point.thickness},
        {quantities::tangential_ratio.key, point.tangential_ratio},
        {"linear_contact_radius_m", contact.contact_radius(point.normal_force, point.thickness)},
        {"rolled", point.rolled},
        {"level", point.level},
        {"values", values}};
}

}  // namespace

std::string strain_csv(const StrainDeviation& deviation) {
    std::string text =
        report::csv_line({quantities::normal_force.key, "thickness_m",
                          quantities::tangential_ratio.key, "linear_contact_radius_m", "rolled",
                          "level", "quantity", "linear", "finite_strains", "deviation"});
    const auto value = [](const double* v) { return v ? std::optional(*v) : std::nullopt; };
    for (const StrainPair& pair : deviation.pairs) {
        const StrainPoint& point = pair.point;
        const double radius = deviation.contact.contact_radius(point.normal_force, point.thickness);
        for (const Quantity* q : strain_quantities)
            if (const auto one = pair.deviation(q))
                text += report::csv_row(
                    point.normal_force, point.thickness, point.tangential_ratio, radius,
                    point.rolled ? "true" : "false", static_cast<double>(point.level), q->key,
                    value(found(pair.linear, q)), value(found(pair.finite, q)), one);
    }
    return text;
}

std::string strain_json(const std::string& version, const std::string& case_text,
                        const StrainDeviation& deviation) {
    const StrainPoint own = own_point(deviation.contact, false);
    json rows = json::object();
    for (const StrainRow& row : strain_rows(deviation))
        rows[row.quantity->key] = row_json(deviation, row);
    const json document{{"version", version},
                        {"case", case_text},
                        {"law", name_of(deviation.contact.law())},
                        {"elements_in_radius", deviation.contact.elements},
                        {quantities::normal_force.key, own.normal_force},
                        {"thickness_m", own.thickness},
                        {quantities::tangential_ratio.key, own.tangential_ratio},
                        {"settling_amplitude_ratio", deviation.contact.amplitude},
                        {"here", rows},
                        {"points", report::list_of(deviation.pairs,
                                                   [&](const StrainPair& pair) {
                                                       return pair_json(deviation.contact, pair);
                                                   })},
                        {"failed_runs", deviation.n_failed_runs}};
    return document.dump(2) + "\n";
}

}  // namespace tricontact::comparisons

#include "comparisons/finite_strain/strain_output.h"

#include <nlohmann/json.hpp>

#include "report/json_table.h"

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

json point_json(const StrainContact& contact, const StrainPoint& point) {
    return {
        {quantities::normal_force.key, point.normal_force},
        {"thickness_m", point.thickness},
        {quantities::tangential_ratio.key, point.tangential_ratio},
        {"linear_contact_radius_m", contact.contact_radius(point.normal_force, point.thickness)},
        {"rolled", point.rolled},
        {"level", point.level}};
}

json value_json(const StrainPair& pair, const Quantity* q) {
    const auto in = [q](const ByQuantity<double>& values) {
        const double* value = found(values, q);
        return value ? json(*value) : json();
    };
    return {{"linear", in(pair.linear)},
            {"finite_strains", in(pair.finite)},
            {"deviation", pair.deviation(q)}};
}

json pair_json(const StrainContact& contact, const StrainPair& pair) {
    json values = json::object();
    for (const Quantity* q : strain_quantities)
        if (found(pair.linear, q) || found(pair.finite, q)) values[q->key] = value_json(pair, q);
    json result = point_json(contact, pair.point);
    result["values"] = values;
    return result;
}

}  // namespace

std::string strain_csv(const StrainDeviation& deviation) {
    json rows = json::array();
    for (const StrainPair& pair : deviation.pairs)
        for (const Quantity* q : strain_quantities) {
            if (!pair.deviation(q)) continue;
            rows.push_back(point_json(deviation.contact, pair.point));
            rows.back()["quantity"] = q->key;
            rows.back().update(value_json(pair, q));
        }
    return report::csv_of(
        rows, {quantities::normal_force.key, "thickness_m", quantities::tangential_ratio.key,
               "linear_contact_radius_m", "rolled", "level", "quantity", "linear", "finite_strains",
               "deviation"});
}

report::DocumentTable strain_points_table(const StrainDeviation& deviation) {
    std::vector<report::ValueColumn> columns{{quantities::normal_force.key, "F_N [N]"},
                                             {"thickness_m", "b [mm]", 1e-3},
                                             {quantities::tangential_ratio.key, "f_T:3"},
                                             {"rolled", "rolled"},
                                             {"level", "level"}};
    for (const Quantity* q : strain_quantities)
        columns.push_back({q->key, q->symbol + std::string(":3"), .01});
    const auto row = [&](const StrainPair& pair) {
        json point = point_json(deviation.contact, pair.point);
        for (const Quantity* q : strain_quantities) point[q->key] = pair.deviation(q);
        return point;
    };
    return report::table_of(
        {.id = "points",
         .title = "All points: deviation [%]",
         .note = "Level 1: elements smaller by sqrt(2), twice the steps of "
                 "pressing. Empty: not rolled, does not settle, or the run failed.",
         .folded = true},
        report::list_of(deviation.pairs, row), columns);
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

#include "comparisons/half_space/deviation_output.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "comparisons/half_space/deviation_rows.h"
#include "comparisons/quantities/quantities.h"
#include "report/csv.h"
#include "report/format.h"
#include "report/json_number.h"

namespace tricontact::comparisons {

namespace {

using json = nlohmann::ordered_json;
using theory::LayerBase;

/// What the ratios of one body belong to.
struct Body {
    const char* part;
    LayerBase base;
    double poisson, thickness_ratio;
    std::string coupled;
};

std::string row(const Body& body, const Quantity& q, double ratio, double error) {
    return report::csv_line({body.part, name_of(body.base), report::csv_field(body.poisson),
                             body.coupled, report::csv_field(body.thickness_ratio), ratio_key(q),
                             report::csv_field(ratio), report::csv_field(error)});
}

std::string rows(const Body& body, const ExactRatios& ratios) {
    std::string text;
    for (const ExactQuantity q : exact_quantities())
        if (const auto ratio = ratios.at(static_cast<std::size_t>(q)))
            text += row(body, describe(q), *ratio, 0);
    return text;
}

json ratio_json(const std::optional<RolledRatio>& ratio) {
    if (!ratio) return nullptr;
    return {{"ratio", report::number(ratio->value)}, {"error", report::number(ratio->error)}};
}

json needed_json(const NeededThicknesses& needed) {
    json result = json::array();
    for (std::size_t i = 0; i < needed.size(); ++i)
        result.push_back({{"deviation", deviation_tolerances.at(i)},
                          {"thickness_ratio", report::number(needed.at(i).ratio)},
                          {"low", report::number(needed.at(i).low)},
                          {"high", report::number(needed.at(i).high)},
                          {"last_of_several", needed.at(i).last_of_several}});
    return result;
}

json rows_json(const HalfSpaceDeviation& deviation) {
    json result = json::object();
    for (const DeviationRow& r : rows_here(deviation))
        result[r.computed ? "computed" : "exact"][ratio_key(*r.quantity)] = ratio_json(r.ratio);
    return result;
}

json exact_curve_json(const ExactCurve& curve) {
    json needed = json::object();
    for (const ExactQuantity q : exact_quantities())
        if (const auto& n = curve.needed.at(static_cast<std::size_t>(q)))
            needed[ratio_key(describe(q))] = needed_json(*n);
    return {{"part", "exact"},
            {"base", name_of(curve.base)},
            {"poisson", curve.poisson},
            {"needed", needed}};
}

json rolled_curve_json(const RolledCurve& curve) {
    json needed = json::object(), points = json::array();
    for (const RolledQuantity q : rolled_quantities())
        if (const auto& n = curve.needed.at(static_cast<std::size_t>(q)))
            needed[ratio_key(describe(q))] = needed_json(*n);
    for (const RolledDeviation& point : curve.points) {
        json ratios = json::object();
        for (const RolledQuantity q : rolled_quantities())
            ratios[ratio_key(describe(q))] =
                ratio_json(point.ratios.at(static_cast<std::size_t>(q)));
        points.push_back(
            {{"thickness_ratio", report::number(point.body.thickness_ratio)},
             {quantities::state.key, point.state ? json(contact::name_of(*point.state)) : json()},
             {"ratios", ratios}});
    }
    return {{"part", "computed"},       {"base", "bonded"}, {"poisson", curve.poisson},
            {"coupled", curve.coupled}, {"needed", needed}, {"points", points}};
}

}  // namespace

std::string deviation_csv(const HalfSpaceDeviation& deviation) {
    std::string text = report::csv_line(
        {"part", "base", "poisson", "coupled", "thickness_ratio", "quantity", "ratio", "error"});
    for (const ExactCurve& curve : deviation.curves)
        for (std::size_t i = 0; i < curve.ratios.size(); ++i)
            text += rows({"exact", curve.base, curve.poisson, curve.thickness_ratios[i], ""},
                         curve.ratios[i]);
    const ExactMap& map = deviation.map;
    for (std::size_t i = 0; i < map.ratios.size(); ++i)
        text += rows({"exact map", LayerBase::bonded, map.poissons[i / map.thickness_ratios.size()],
                      map.thickness_ratios[i % map.thickness_ratios.size()], ""},
                     map.ratios[i]);
    for (const RolledCurve& curve : deviation.rolled)
        for (const RolledDeviation& point : curve.points)
            for (const RolledQuantity q : rolled_quantities())
                if (const auto& ratio = point.ratios.at(static_cast<std::size_t>(q)))
                    text += row({"computed", LayerBase::bonded, curve.poisson,
                                 point.body.thickness_ratio, curve.coupled ? "true" : "false"},
                                describe(q), ratio->value, ratio->error);
    return text;
}

std::string deviation_json(const std::string& version, const std::string& case_text,
                           const HalfSpaceDeviation& deviation) {
    json curves = json::array();
    for (const ExactCurve& curve : deviation.curves) curves.push_back(exact_curve_json(curve));
    for (const RolledCurve& curve : deviation.rolled) curves.push_back(rolled_curve_json(curve));
    const ApparentModuli& apparent = deviation.apparent;
    const json document{
        {"version", version},
        {"case", case_text},
        {"hertz_diameter_m", report::number(deviation.contact.hertz_diameter)},
        {quantities::normal_force.key, report::number(deviation.contact.normal_force)},
        {"thickness_ratio", report::number(deviation.thickness_ratio)},
        {"base", name_of(deviation.base)},
        {quantities::tangential_ratio.key, report::number(deviation.contact.tangential_ratio)},
        {quantities::amplitude_ratio.key, report::number(deviation.contact.amplitude_ratio)},
        {"settling_amplitude_ratio", report::number(deviation.amplitudes.settling)},
        {"ratcheting_amplitude_ratio", report::number(deviation.amplitudes.ratcheting)},
        {"layer", rows_json(deviation)},
        {"apparent_young_Pa",
         {{"from_indentation", report::number(apparent.from_indentation)},
          {"from_contact_radius", report::number(apparent.from_contact_radius)},
          {"from_unit_shift", report::number(apparent.from_unit_shift)}}},
        {"curves", curves},
        {"failed_runs", deviation.n_failed_runs}};
    return document.dump(2) + "\n";
}

}  // namespace tricontact::comparisons

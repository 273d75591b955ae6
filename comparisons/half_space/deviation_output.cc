#include "comparisons/half_space/deviation_output.h"

#include <nlohmann/json.hpp>

#include "comparisons/quantities/quantities.h"
#include "report/csv.h"
#include "report/format.h"
#include "report/json_number.h"

namespace tricontact::comparisons {

namespace {

using json = nlohmann::ordered_json;
using theory::LayerBase;

std::string exact_rows(const char* part, LayerBase base, double poisson, double thickness_ratio,
                       const ExactRatios& ratios) {
    std::string text;
    for (const Quantity* q : exact_quantities)
        if (const double* ratio = found(ratios, q))
            text += report::csv_row(part, name_of(base), poisson, "", thickness_ratio,
                                    ratio_key(*q), *ratio, 0.);
    return text;
}

json ratio_json(const RolledRatio* ratio) {
    return ratio ? json{{"ratio", ratio->value}, {"error", ratio->error}} : json();
}

json needed_json(const NeededThicknesses& needed) {
    json result = json::array();
    for (std::size_t i = 0; i < needed.size(); ++i)
        result.push_back({{"deviation", deviation_tolerances.at(i)},
                          {"thickness_ratio", needed.at(i).ratio},
                          {"low", needed.at(i).low},
                          {"high", needed.at(i).high},
                          {"last_of_several", needed.at(i).last_of_several}});
    return result;
}

/// Of the quantities, in their order.
json needed_json(std::span<const Quantity* const> of, const ByQuantity<NeededThicknesses>& known) {
    json result = json::object();
    for (const Quantity* q : of)
        if (const auto* needed = found(known, q)) result[ratio_key(*q)] = needed_json(*needed);
    return result;
}

json rows_json(const HalfSpaceDeviation& deviation) {
    json result = json::object();
    for (const DeviationRow& r : rows_here(deviation))
        result[r.computed ? "computed" : "exact"][ratio_key(*r.quantity)] =
            ratio_json(r.ratio ? &*r.ratio : nullptr);
    return result;
}

json exact_curve_json(const ExactCurve& curve) {
    return {{"part", "exact"},
            {"base", name_of(curve.base)},
            {"poisson", curve.poisson},
            {"needed", needed_json(exact_quantities, curve.needed)}};
}

json point_json(const RolledDeviation& point) {
    json ratios = json::object();
    for (const Quantity* q : rolled_quantities)
        ratios[ratio_key(*q)] = ratio_json(found(point.ratios, q));
    return {{"thickness_ratio", point.body.thickness_ratio},
            {quantities::state.key, point.state ? json(contact::name_of(*point.state)) : json()},
            {"ratios", ratios}};
}

json rolled_curve_json(const RolledCurve& curve) {
    return {{"part", "computed"},
            {"base", "bonded"},
            {"poisson", curve.poisson},
            {"coupled", curve.coupled},
            {"needed", needed_json(rolled_quantities, curve.needed)},
            {"points", report::list_of(curve.points, point_json)}};
}

}  // namespace

std::string deviation_csv(const HalfSpaceDeviation& deviation) {
    std::string text = report::csv_line(
        {"part", "base", "poisson", "coupled", "thickness_ratio", "quantity", "ratio", "error"});
    for (const ExactCurve& curve : deviation.curves)
        for (std::size_t i = 0; i < curve.ratios.size(); ++i)
            text += exact_rows("exact", curve.base, curve.poisson, curve.thickness_ratios[i],
                               curve.ratios[i]);
    const ExactMap& map = deviation.map;
    for (std::size_t i = 0; i < map.ratios.size(); ++i)
        text += exact_rows("exact map", LayerBase::bonded,
                           map.poissons[i / map.thickness_ratios.size()],
                           map.thickness_ratios[i % map.thickness_ratios.size()], map.ratios[i]);
    for (const RolledCurve& curve : deviation.rolled)
        for (const RolledDeviation& point : curve.points)
            for (const Quantity* q : rolled_quantities)
                if (const RolledRatio* ratio = found(point.ratios, q))
                    text += report::csv_row("computed", name_of(LayerBase::bonded), curve.poisson,
                                            curve.coupled ? "true" : "false",
                                            point.body.thickness_ratio, ratio_key(*q), ratio->value,
                                            ratio->error);
    return text;
}

std::string deviation_json(const std::string& version, const std::string& case_text,
                           const HalfSpaceDeviation& deviation) {
    json curves = json::array();
    for (const ExactCurve& curve : deviation.curves) curves.push_back(exact_curve_json(curve));
    for (const RolledCurve& curve : deviation.rolled) curves.push_back(rolled_curve_json(curve));
    const ApparentModuli& apparent = deviation.apparent;
    const json document{{"version", version},
                        {"case", case_text},
                        {"hertz_diameter_m", deviation.contact.hertz_diameter},
                        {quantities::normal_force.key, deviation.contact.normal_force},
                        {"thickness_ratio", deviation.thickness_ratio},
                        {"base", name_of(deviation.base)},
                        {quantities::tangential_ratio.key, deviation.contact.tangential_ratio},
                        {quantities::amplitude_ratio.key, deviation.contact.amplitude_ratio},
                        {"settling_amplitude_ratio", deviation.amplitudes.settling},
                        {"ratcheting_amplitude_ratio", deviation.amplitudes.ratcheting},
                        {"layer", rows_json(deviation)},
                        {"apparent_young_Pa",
                         {{"from_indentation", apparent.from_indentation},
                          {"from_contact_radius", apparent.from_contact_radius},
                          {"from_unit_shift", apparent.from_unit_shift}}},
                        {"curves", curves},
                        {"failed_runs", deviation.n_failed_runs}};
    return document.dump(2) + "\n";
}

}  // namespace tricontact::comparisons

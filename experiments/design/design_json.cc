#include <nlohmann/json.hpp>

#include "experiments/design/design_report.h"
#include "files/version.h"
#include "io/keys/units.h"
#include "report/json_number.h"

namespace tricontact::experiments {

namespace {

using Json = nlohmann::ordered_json;

Json end_json(const DesignStudy& study, std::size_t axis, double fraction,
              const std::optional<std::size_t>& requirement) {
    return {{"value", study.value(axis, fraction)},
            {"requirement", requirement ? Json(study.requirements[*requirement].name) : Json()}};
}

Json varied_json(const DesignStudy& study, std::size_t axis) {
    const DesignAxis& one = study.input.axes[axis];
    const DesignSolution& s = study.solution;
    Json json{{"unit", io::si_unit(one.key().dimension)},
              {"from", one.range().from},
              {"to", one.range().to},
              {"best", study.value(axis, s.best.fractions[axis])}};
    if (s.stretches.empty()) return json;
    const Stretch& stretch = s.stretches[axis];
    json["least"] = end_json(study, axis, stretch.low, stretch.low_requirement);
    json["largest"] = end_json(study, axis, stretch.high, stretch.high_requirement);
    return json;
}

Json point_json(const DesignStudy& study, const DesignPoint& p) {
    Json values = Json::array(), ratios = Json::array();
    for (std::size_t axis = 0; axis < p.fractions.size(); ++axis)
        values.push_back(study.value(axis, p.fractions[axis]));
    for (const double ratio : p.ratios) ratios.push_back(report::number(ratio));
    return {{"values", values}, {"ratios", ratios}};
}

Json comparison_json(const DesignStudy& study) {
    if (!study.comparison) return {};
    const ComparisonError& error = *study.comparison;
    Json shares = Json::object();
    for (const auto& [name, share] : error.shares()) shares[name] = share;
    return {{"quantity", study.input.quantity},
            {"model", study.model},
            {"computed", error.computed},
            {"standard_error", error.standard_error()},
            {"half_width", error.half_width()},
            {"resolution", error.resolution()},
            {"shares", shares}};
}

}  // namespace

std::string design_json(const DesignStudy& study) {
    const DesignSolution& s = study.solution;
    Json varied = Json::object(), requirements = Json::array(), binding = Json::array(),
         widen = Json::array(), points = Json::array();
    for (std::size_t axis = 0; axis < study.input.axes.size(); ++axis)
        varied[std::string(study.input.axes[axis].key().path)] = varied_json(study, axis);
    for (std::size_t i = 0; i < study.requirements.size(); ++i) {
        const Requirement& r = study.requirements[i];
        const bool at_most = r.relation == Criterion::Relation::at_most;
        requirements.push_back({{"name", r.name},
                                {"symbol", r.symbol},
                                {"assumption", r.claim},
                                {"unit", r.unit},
                                {at_most ? "at_most" : "at_least", r.limit},
                                {"finding", report::number(r.finding(s.best.ratios[i]))},
                                {"ratio", report::number(s.best.ratios[i])}});
    }
    for (const std::size_t i : s.best.binding()) binding.push_back(study.requirements[i].name);
    for (const Widening& one : s.widenings)
        widen.push_back({{"key", study.input.axes[one.axis].key().path},
                         {"towards", one.upwards ? "larger" : "smaller"}});
    for (const DesignPoint& p : s.grid) points.push_back(point_json(study, p));
    const Json all{{"version", files::version},
                   {"title", study.title},
                   {"feasible", s.best.is_feasible()},
                   {"worst_ratio", s.best.worst()},
                   {"binding", binding},
                   {"widen", widen},
                   {"varied", varied},
                   {"requirements", requirements},
                   {"comparison", comparison_json(study)},
                   {"separation", separation_json(study)},
                   {"points", points}};
    return all.dump(2) + '\n';
}

}  // namespace tricontact::experiments

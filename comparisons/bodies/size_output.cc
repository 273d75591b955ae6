#include "comparisons/bodies/size_output.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "contact/bodies/body_forms.h"
#include "report/format.h"
#include "report/json_number.h"
#include "report/json_table.h"

namespace tricontact::comparisons {

namespace {

using contact::ElasticBody;
using json = nlohmann::ordered_json;
using Standing = report::Verdict::Standing;

constexpr double tolerable = .05;  // from which on the half-space is said to fail

json body_json(const SizedBody& body, double radius) {
    const bool hub = body.body.support == ElasticBody::Support::hub;
    return {{"body", contact::body_form(body.body.form).word},
            {"support", contact::word_of(body.body.support)},
            {"hub_radius_over_R", hub ? json(body.body.hub_radius / radius) : json()},
            {"poisson", body.poisson}};
}

json limit_json(double tolerance, const std::optional<StrainThreshold>& limit) {
    const auto value = [](std::optional<double> x) { return report::number(x); };
    return {{"deviation", tolerance},
            {"up_to_size", limit ? value(limit->at) : json()},
            {"low", limit ? value(limit->low) : json()},
            {"high", limit ? value(limit->high) : json()},
            {"returns", limit && limit->returns}};
}

json points_json(const std::vector<SizePoint>& points) {
    json list = json::array();
    for (const SizePoint& p : points)
        list.push_back({{"size", p.size}, {"ratio", p.ratio}, {"error", p.error}, {"own", p.own}});
    return list;
}

json curve_json(const SizeCurve& curve, double radius) {
    json measures = json::object();
    for (const SizeMeasure& measure : size_measures()) {
        const auto found = curve.points.find(&measure);
        if (found == curve.points.end()) continue;
        const SizeLimits limits = size_limits(found->second);
        json list = json::array();
        for (std::size_t i = 0; i < limits.size(); ++i)
            list.push_back(limit_json(size_tolerances[i], limits[i]));
        measures[measure.key] = {{"limits", list}, {"points", points_json(found->second)}};
    }
    json result = body_json(curve.body, radius);
    result["quantities"] = measures;
    return result;
}

/// Of the case's own body, in the order of size_measures().
template <class Use>
void for_each_own(const SizeDeviation& deviation, const Use& use) {
    if (deviation.curves.empty()) return;
    for (const SizeMeasure& measure : size_measures())
        if (const auto found = deviation.curves.front().points.find(&measure);
            found != deviation.curves.front().points.end())
            use(measure, found->second);
}

const SizePoint* own_point(const std::vector<SizePoint>& points) {
    const auto found = std::ranges::find(points, true, &SizePoint::own);
    return found == points.end() ? nullptr : &*found;
}

/// "up to a/R = 0.062 (0.0618 to 0.0622) within 5 %"
std::string within_text(const SizeLimits& limits, double largest) {
    std::vector<std::string> parts;
    for (std::size_t i = 0; i < limits.size(); ++i) {
        if (!limits[i]) continue;
        parts.push_back(fmt::format(
            "within {:.0f} % {} a/R = {}", 100 * size_tolerances[i],
            limits[i]->at ? "up to" : "as far as was looked,",
            limits[i]->at ? limit_text(limits[i], largest) : report::significant(largest, 2)));
        if (!limits[i]->at) break;
    }
    return fmt::format("{}", fmt::join(parts, ", "));
}

}  // namespace

std::string limit_text(const std::optional<StrainThreshold>& limit, double largest) {
    if (!limit) return "–";
    if (!limit->at) return "beyond " + report::significant(largest, 2);
    const std::string text = report::significant(*limit->at, 3);
    if (!limit->low || !limit->high) return text;
    const std::string low = report::significant(*limit->low, 3),
                      high = report::significant(*limit->high, 3);
    return low == text && high == text ? text : fmt::format("{} ({} to {})", text, low, high);
}

std::string size_csv(const SizeDeviation& deviation) {
    json rows = json::array();
    for (const SizeCurve& curve : deviation.curves)
        for (const SizeMeasure& measure : size_measures()) {
            const auto found = curve.points.find(&measure);
            if (found == curve.points.end()) continue;
            for (const SizePoint& p : found->second) {
                rows.push_back(body_json(curve.body, deviation.contact.c.indenter.radius));
                rows.back().update(json{{"quantity", measure.key},
                                        {"size", p.size},
                                        {"ratio", p.ratio},
                                        {"error", p.error}});
            }
        }
    return report::csv_of(rows, {"body", "support", "hub_radius_over_R", "poisson", "quantity",
                                 "size", "ratio", "error"});
}

std::string size_json(const std::string& version, const std::string& case_text,
                      const SizeDeviation& deviation) {
    const double radius = deviation.contact.c.indenter.radius;
    json here = json::object();
    for_each_own(deviation, [&](const SizeMeasure& measure, const std::vector<SizePoint>& points) {
        if (const SizePoint* own = own_point(points))
            here[measure.key] = {{"size", own->size}, {"ratio", own->ratio}, {"error", own->error}};
    });
    const json document{{"version", version},
                        {"case", case_text},
                        {"model", deviation.contact.model()},
                        {"size", deviation.contact.size},
                        {"here", here},
                        {"bodies", report::list_of(deviation.curves,
                                                   [&](const SizeCurve& curve) {
                                                       return curve_json(curve, radius);
                                                   })},
                        {"failed_runs", deviation.n_failed_runs}};
    return document.dump(2) + "\n";
}

std::vector<report::Verdict> size_verdicts(const SizeDeviation& deviation) {
    std::vector<report::Verdict> verdicts;
    for_each_own(deviation, [&](const SizeMeasure& measure, const std::vector<SizePoint>& points) {
        std::string text = report::capitalised(name_of(measure)) + ": ";
        const SizePoint* own = own_point(points);
        if (own)
            text +=
                fmt::format("{} % {} a half-space's here, at a/R = {}; ",
                            report::with_error(100 * std::abs(own->ratio - 1), 100 * own->error, 3),
                            own->ratio < 1 ? "below" : "above", report::significant(own->size, 3));
        text += within_text(size_limits(points), points.back().size);
        const Standing standing = !own                                   ? Standing::finding
                                  : std::abs(own->ratio - 1) > tolerable ? Standing::violated
                                                                         : Standing::holds;
        verdicts.push_back({standing, text + "."});
    });
    if (deviation.n_failed_runs > 0)
        verdicts.push_back(
            {Standing::fail,
             fmt::format("Failed runs: {}; their values are missing.", deviation.n_failed_runs)});
    return verdicts;
}

report::DocumentTable size_table(const SizeDeviation& deviation) {
    report::DocumentTable table{
        .id = "here",
        .title = "The case's body, and how small contacts have to be",
        .note =
            "Deviation: the body's value over that of Hertz' half-space at the same depth or "
            "force, "
            "minus 1, at the case's own load. 1, 2, 5 %: a/R up to which the body is no further "
            "off, a of Hertz' contact, with the interval of the numerical error.",
        .columns =
            report::columns("quantity", "a/R here:3", "deviation [%]:3", "1 %", "2 %", "5 %")};
    for_each_own(deviation, [&](const SizeMeasure& measure, const std::vector<SizePoint>& points) {
        const SizePoint* own = own_point(points);
        std::vector<report::Cell> row{
            name_of(measure), report::number_cell(own ? std::optional(own->size) : std::nullopt),
            own ? report::Cell(report::WithError{100 * (own->ratio - 1), 100 * own->error})
                : report::number_cell({})};
        for (const auto& limit : size_limits(points))
            row.push_back(limit_text(limit, points.back().size));
        table.rows.push_back(std::move(row));
    });
    return table;
}

}  // namespace tricontact::comparisons

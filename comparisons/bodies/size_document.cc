#include <fmt/format.h>

#include "comparisons/bodies/size_output.h"
#include "contact/models/model_kind.h"
#include "report/format.h"

namespace tricontact::comparisons {

namespace {

std::string label_of(const SizedBody& body, double radius) {
    return fmt::format("{}, nu = {}", name_of(body, radius), report::as_given(body.poisson));
}

report::Curve curve_of(const std::string& name, const std::vector<SizePoint>& points) {
    report::Curve curve{.name = name, .kind = report::Curve::Kind::line_and_points};
    for (const SizePoint& p : points) {
        curve.add(p.size, 100 * (p.ratio - 1));
        curve.y_error.push_back(100 * p.error);
    }
    return curve;
}

report::Figure empty_figure(const std::string& id, const std::string& title) {
    return {.id = id,
            .title = title,
            .caption =
                "Body over Hertz' half-space, minus 1; bars: what a mesh of twice the size is "
                "off.",
            .x = {"a/R of Hertz' contact [-]"},
            .y = {"deviation [%]"}};
}

report::DocumentTable bodies_table(const SizeDeviation& deviation) {
    report::DocumentTable table{
        .id = "bodies",
        .title = "Other bodies: a/R up to which they are half-spaces",
        .note = "The same limits for the support, hub and Poisson's ratio named.",
        .columns = report::columns("body", "nu:3", "quantity", "1 %", "2 %", "5 %")};
    const double radius = deviation.contact.c.indenter.radius;
    for (const SizeCurve& curve : deviation.curves)
        for (const SizeMeasure& measure : size_measures()) {
            const auto found = curve.points.find(&measure);
            if (found == curve.points.end()) continue;
            std::vector<report::Cell> row{name_of(curve.body, radius), curve.body.poisson,
                                          name_of(measure)};
            for (const auto& limit : size_limits(found->second))
                row.push_back(limit_text(limit, found->second.back().size));
            table.rows.push_back(std::move(row));
        }
    return table;
}

report::DocumentSection size_method(const SizeDeviation& deviation) {
    report::DocumentSection section{.id = "method", .heading = "How it was computed"};
    section.paragraphs = {
        fmt::format(
            "{} of the body on a rigid plane, pressed without friction, on meshes of 16 and "
            "32 elements in Hertz' contact radius; the ratios are those of the finer one. "
            "Moduli cancel. The gap is that of the case's shape.",
            report::display_name(deviation.contact.model())),
        "Half-space: Hertz, E* = E/(1 - nu^2), at the same depth or force as the body. Between the "
        "points deviations are monotone interpolants over a/R, from 0 on, where a body is a "
        "half-space; nothing is extrapolated.",
        "Errors: 1.25 times what separates both meshes, of the point or its neighbours. Small "
        "strains and one direction of "
        "contact: "
        "beyond a/R = 0.1 what small strains neglect may be as large as 1 %."};
    if (deviation.contact.is_line())
        section.paragraphs.emplace_back(
            "A half-space in plane strain has no depth of its own: the approach of cylinders is "
            "not "
            "compared.");
    return section;
}

}  // namespace

std::vector<report::Figure> size_figures(const SizeDeviation& deviation) {
    std::vector<report::Figure> figures;
    if (deviation.curves.empty()) return figures;
    const double radius = deviation.contact.c.indenter.radius;
    report::Figure own = empty_figure("over_size", "Deviation of the case's body over a/R");
    for (const SizeMeasure& measure : size_measures())
        if (const auto found = deviation.curves.front().points.find(&measure);
            found != deviation.curves.front().points.end())
            own.curves.push_back(curve_of(name_of(measure), found->second));
    if (!own.curves.empty()) figures.push_back(std::move(own));
    for (const SizeMeasure& measure : size_measures()) {
        report::Figure figure = empty_figure(measure.key, report::capitalised(name_of(measure)));
        for (const SizeCurve& curve : deviation.curves)
            if (const auto found = curve.points.find(&measure); found != curve.points.end())
                figure.curves.push_back(curve_of(label_of(curve.body, radius), found->second));
        if (!figure.curves.empty()) figures.push_back(std::move(figure));
    }
    return figures;
}

report::Document size_document(const SizeDeviation& deviation) {
    const contact::Case& c = deviation.contact.c;
    std::vector<report::Figure> figures = size_figures(deviation), others;
    if (figures.size() > 1) {
        others.assign(figures.begin() + 1, figures.end());
        figures.resize(1);
    }
    return {
        .kind = "Size of the body",
        .title = c.title.empty() ? "Bodies and half-spaces" : c.title,
        .lead = "How large must a body be to press as a half-space does?",
        .verdicts = size_verdicts(deviation),
        .settings = {{"body", name_of(deviation.contact.own, c.indenter.radius)},
                     {"R", report::given_quantity(c.indenter.radius, "m")},
                     {"nu", report::as_given(deviation.contact.own.poisson)},
                     {"a/R of Hertz", report::significant(deviation.contact.size, 3)}},
        .sections = {{.id = "here",
                      .heading = "The case's body",
                      .figures = figures,
                      .tables = {size_table(deviation)}},
                     {.id = "bodies",
                      .heading = "Other bodies",
                      .figures = others,
                      .tables = {bodies_table(deviation)}},
                     size_method(deviation)},
        .files = {{"all ratios (CSV)", "body_size.csv"}, {"everything (JSON)", "body_size.json"}}};
}

}  // namespace tricontact::comparisons

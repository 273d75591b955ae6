#include "comparisons/half_space/deviation_output.h"
#include "comparisons/quantities/quantities.h"
#include "contact/base/special_values.h"
#include "report/format.h"

namespace tricontact::comparisons {

namespace {

using theory::LayerBase;

report::Cell percent_cell(const RolledRatio& ratio) {
    return report::WithError{100 * (ratio.value - 1), 100 * ratio.error};
}

std::vector<report::Cell> with_needed(std::vector<report::Cell> row,
                                      const NeededThicknesses* needed, double thinnest) {
    for (std::size_t i = 0; i < deviation_tolerances.size(); ++i)
        row.push_back(needed ? report::Cell(needed_text(needed->at(i), thinnest))
                             : report::Cell(contact::undefined));
    return row;
}

report::DocumentTable needed_table(const HalfSpaceDeviation& deviation) {
    report::DocumentTable table{
        .id = "needed",
        .title = "Thickness over contact width from which on a half-space will do",
        .note =
            "Least b/D_c for 1, 2 and 5 %. Where a deviation passes the limit several times, "
            "the last one. Exact: roots of the exact ratio. Computed: monotone interpolation "
            "over D_c/b between computed layers and the half-space, interval in brackets.",
        .columns = report::columns("quantity", "base", "nu", "coupling", "1 %", "2 %", "5 %")};
    for (const ExactCurve& curve : deviation.curves)
        for (const Quantity* q : exact_quantities)
            if (const auto* needed = found(curve.needed, q))
                table.rows.push_back(with_needed(
                    {q->symbol, name_of(curve.base),
                     curve.base == LayerBase::frictionless ? report::Cell("any")
                                                           : report::Cell(curve.poisson),
                     q == &quantities::coupled_tangential_stiffness ? "yes" : "no"},
                    needed, curve.thickness_ratios.front()));
    for (const RolledCurve& curve : deviation.rolled)
        for (const Quantity* q : rolled_quantities)
            if (const auto* needed = found(curve.needed, q))
                table.rows.push_back(with_needed({std::string(q->symbol) + ", computed", "bonded",
                                                  curve.poisson, curve.coupled ? "yes" : "no"},
                                                 needed,
                                                 curve.points.front().body.thickness_ratio));
    return table;
}

report::DocumentTable rolled_table(const HalfSpaceDeviation& deviation) {
    report::DocumentTable table{
        .id = "computed",
        .title = "Computed deviations [%]",
        .note =
            "Layer over half-space of the same nu and coupling, minus 1, in percent, with the "
            "numerical error. Empty: not defined, such as the settled shift of what ratchets. "
            "State: of the run that settles on the half-space.",
        .columns = report::columns("b/D_c:3", "nu", "coupling", quantities::state.key)};
    for (const Quantity* q : rolled_quantities) table.columns.push_back({q->symbol, 3});
    for (const RolledCurve& curve : deviation.rolled)
        for (const RolledDeviation& point : curve.points) {
            auto& row = table.rows.emplace_back(std::vector<report::Cell>{
                point.body.thickness_ratio, curve.poisson, curve.coupled ? "yes" : "no",
                point.state ? contact::name_of(*point.state) : ""});
            for (const Quantity* q : rolled_quantities) {
                const RolledRatio* ratio = found(point.ratios, q);
                row.push_back(ratio ? percent_cell(*ratio) : report::Cell(contact::undefined));
            }
        }
    return table;
}

report::DocumentSection rolled_section(const HalfSpaceDeviation& deviation) {
    report::DocumentSection section{.id = "rolling", .heading = "Friction and rolling"};
    if (deviation.rolled.empty()) {
        section.paragraphs.push_back(
            deviation.base == LayerBase::frictionless
                ? "On a frictionless base nothing holds the layer against a tangential force: "
                  "shifts are not defined, and only the limits are compared."
            : deviation.contact.tangential_ratio == 0
                ? "Nothing was computed: the case has no tangential load."
                : "Nothing was computed: the runs were left out.");
        return section;
    }
    section.paragraphs = {
        "Boundary elements of the layer (bem-layer) over those of the half-space (bem), each at "
        "the same F_N, f_T and w = W/a of its own contact radius a, pressed as in the case. Shifts "
        "are compared in metres (capital letters) and over each body's own U_max (small "
        "letters): what U_max explains drops out of the latter.",
        "Each value was computed with 8, 11 and 16 cells in Hertz' contact radius; the finest is "
        "given, the error is the largest distance of the others from it. Shifts per period are "
        "those of the tenth period in four steps per quarter; their error also has twice what half "
        "steps change on the coarsest grid."};
    section.figures = rolled_figures(deviation);
    section.tables.push_back(rolled_table(deviation));
    return section;
}

report::DocumentSection method_section(const HalfSpaceDeviation& deviation) {
    report::DocumentSection section{.id = "method", .heading = "How it was computed"};
    section.paragraphs = {
        "D_c is the diameter of Hertz' contact under the same force; b/D_c the layer's thickness "
        "over it. E* is the same for all Poisson's ratios, and so is D_c. The indenter is rigid.",
        "a, d, p0, U_max and dF_N/dd: exact frictionless contact on the layer (a Fredholm equation "
        "in one dimension, solved to 1e-10). k_t is the slope dF_T/dU as F_T sets in and "
        "everything sticks, without and with the coupling of normal and tangential contact. The "
        "limits are those of uncoupled contact, 1 - ∫_0^W q dx / ∫_0^a q dx with the line load q, "
        "which is exact.",
        "On a frictionless base the normal compliance over that of the half-space does not depend "
        "on Poisson's ratio: one curve holds for all.",
        "On thick layers the ground takes away the same displacement everywhere: the shape of the "
        "pressure stays. So d, U_max and the stiffnesses deviate by the first power of D_c/b, the "
        "contact radius and p0 by the third, the limits at equal w by the fifth: the contact looks "
        "like Hertz' long before it is as compliant."};
    if (deviation.c.indenter.shape == contact::Case::Shape::sphere)
        section.paragraphs.push_back(
            "The indenter is the exact sphere on both bodies; D_c is that of the paraboloid.");
    return section;
}

std::vector<std::pair<std::string, std::string>> settings(const HalfSpaceDeviation& deviation) {
    const contact::Case& c = deviation.c;
    std::vector<std::pair<std::string, std::string>> result{
        {"layer", report::given_quantity(*c.layer.thickness, "m") + ", " + name_of(deviation.base)},
        {"b/D_c", report::significant(deviation.thickness_ratio, 4)},
        {"E, nu", report::given_quantity(c.substrate.young, "Pa") + ", " +
                      report::as_given(c.substrate.poisson)},
        {"R", report::given_quantity(c.indenter.radius, "m")},
        {"F_N", report::quantity(deviation.contact.normal_force, "N")},
        {"D_c", report::quantity(deviation.contact.hertz_diameter, "m")},
        {"f_T", report::significant(deviation.contact.tangential_ratio, 3)}};
    if (deviation.contact.amplitude_ratio > 0)
        result.emplace_back("w = W/a", report::significant(deviation.contact.amplitude_ratio, 3));
    if (!deviation.rolled.empty() && deviation.amplitudes.ratcheting > 0) {
        result.emplace_back("w that settles",
                            report::significant(deviation.amplitudes.settling, 3));
        result.emplace_back("w that ratchets",
                            report::significant(deviation.amplitudes.ratcheting, 3));
    }
    return result;
}

}  // namespace

report::DocumentTable deviation_table(const HalfSpaceDeviation& deviation) {
    report::DocumentTable table{
        .id = "layer",
        .title = "This layer, and how thick it would have to be",
        .note =
            "Deviation: the layer's value over the half-space's under the same force, minus 1. "
            "Thicknesses: b/D_c from which on the quantity deviates by less; of computed ones "
            "with the interval of their numerical error.",
        .columns =
            report::columns("quantity", "symbol", "by", "deviation [%]:3", "1 %", "2 %", "5 %")};
    for (const DeviationRow& r : rows_here(deviation))
        table.rows.push_back(with_needed({r.quantity->name, r.quantity->symbol,
                                          r.computed ? "boundary elements" : "exact theory",
                                          !r.ratio     ? report::Cell(contact::undefined)
                                          : r.computed ? percent_cell(*r.ratio)
                                                       : report::Cell(100 * (r.ratio->value - 1))},
                                         r.needed, r.thinnest));
    return table;
}

report::Document deviation_document(const HalfSpaceDeviation& deviation) {
    return {
        .kind = "Half-space deviation",
        .title = deviation.c.title.empty() ? "Layer and half-space" : deviation.c.title,
        .lead =
            "How wrong is it to take this layer for a half-space, and how thick would it have "
            "to be?",
        .verdicts = deviation_verdicts(deviation),
        .settings = settings(deviation),
        .sections = {{.id = "this_layer",
                      .heading = "This layer",
                      .figures = thickness_figures(deviation),
                      .tables = {deviation_table(deviation)}},
                     rolled_section(deviation),
                     {.id = "maps",
                      .heading = "Any layer: thickness and Poisson's ratio",
                      .figures = map_figures(deviation)},
                     {.id = "needed_thickness",
                      .heading = "How thick is thick enough?",
                      .tables = {needed_table(deviation)}},
                     method_section(deviation)},
        .files = {{"all ratios (CSV)", "deviation.csv"}, {"everything (JSON)", "deviation.json"}}};
}

}  // namespace tricontact::comparisons

#include "comparisons/finite_strain/strain_output.h"
#include "report/format.h"

namespace tricontact::comparisons {

report::DocumentTable strain_table(const StrainDeviation& deviation) {
    report::DocumentTable table{
        .id = "here",
        .title = "This case, and the loads from which on the linear law is off",
        .note =
            "Deviation: the linear law's value over that at finite strains on the same mesh, "
            "minus 1. Forces: F_N from which on it is larger at this thickness, with the "
            "interval of the numerical error.",
        .columns = report::columns("quantity", "symbol", "linear", "finite strains",
                                   "deviation [%]:3", "1 %", "2 %", "5 %")};
    for (const StrainRow& r : strain_rows(deviation)) {
        auto& row = table.rows.emplace_back(std::vector<report::Cell>{
            r.quantity->name, r.quantity->symbol, report::quantity(r.linear, r.quantity->unit),
            report::quantity(r.finite, r.quantity->unit),
            r.error ? report::Cell(report::WithError{100 * r.deviation, 100 * *r.error})
                    : report::Cell(100 * r.deviation)});
        for (const auto& threshold : r.forces)
            row.push_back(threshold_text(threshold, 0, r.largest_force, "N"));
    }
    return table;
}

namespace {

report::DocumentSection strain_method(const StrainDeviation& deviation) {
    const StrainContact& contact = deviation.contact;
    report::DocumentSection section{.id = "method", .heading = "How it was computed"};
    section.paragraphs = {
        "Finite elements (fem) by the linear law and by the law " +
            std::string(name_of(contact.law())) +
            ", contact and friction in the current configuration, on meshes of the same "
            "settings: " +
            report::as_given(contact.elements) +
            " elements in the contact radius of the linear layer, at least three in its "
            "thickness. The quotient of both depends on the mesh far less than either. d, a and "
            "p_0 are those of pressing without friction; U_stat follows pressing as in the case.",
        "Errors: the change of the case's own deviation on elements smaller by sqrt(2) with twice "
        "the steps of pressing; it stands for the other points as well.",
        "Between the points deviations are monotone interpolants, over the cube root of F_N, with "
        "which strains grow, from 0 on, where the linear law is exact; nothing is extrapolated."};
    if (contact.amplitude > 0)
        section.paragraphs.push_back(
            "Points of the case's thickness from F_N/4 to 4 F_N were rolled back and forth by "
            "turning "
            "points until the "
            "shift was settled, with w = W/a = " +
            report::significant(contact.amplitude, 3) + " of the linear layer's contact radius.");
    return section;
}

}  // namespace

report::Document strain_document(const StrainDeviation& deviation) {
    const contact::Case& c = deviation.contact.c;
    const StrainPoint own = own_point(deviation.contact, false);
    report::Document document{
        .kind = "Finite strains",
        .title = c.title.empty() ? "Linear law and finite strains" : c.title,
        .lead = "How far is linear elasticity off, and from which load on?",
        .verdicts = strain_verdicts(deviation),
        .settings = {{"layer", report::given_quantity(own.thickness, "m")},
                     {"E, nu", report::given_quantity(c.substrate.young, "Pa") + ", " +
                                   report::as_given(c.substrate.poisson)},
                     {"law", name_of(deviation.contact.law())},
                     {"R", report::given_quantity(c.indenter.radius, "m")},
                     {"F_N", report::quantity(own.normal_force, "N")},
                     {"f_T", report::significant(own.tangential_ratio, 3)},
                     {"mu", report::as_given(c.friction_coefficient())}},
        .sections = {{.id = "here", .heading = "This case", .tables = {strain_table(deviation)}},
                     {.id = "maps",
                      .heading = "Other loads and layers",
                      .figures = strain_maps(deviation),
                      .tables = {strain_points_table(deviation)}},
                     {.id = "curves",
                      .heading = "Over the forces",
                      .figures = strain_curves(deviation)},
                     strain_method(deviation)},
        .files = {{"all points (CSV)", "finite_strain.csv"},
                  {"everything (JSON)", "finite_strain.json"}}};
    return document;
}

}  // namespace tricontact::comparisons

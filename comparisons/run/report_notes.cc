#include "comparisons/half_space/layer_report.h"
#include "comparisons/run/loading_study.h"
#include "comparisons/run/report_tables.h"

namespace tricontact::comparisons {

using contact::Case;

std::string derived_note(const Case& c) {
    if (c.is_cylindrical())
        return "Hertz' line contact of the half width a on the half-space; indentation and shift "
               "are those of a strip of the length L, at half length (docs/cylinder.md).";
    const std::string body =
        contact::is_hertz_round(c)
            ? "Hertz' solution of the case's paraboloid; a sphere counts as the paraboloid that "
              "touches it."
            : "The case's body pressed without friction on the half-space.";
    const std::string ellipse =
        c.indenter.shape == Case::Shape::ellipsoid
            ? ", μ [d + (E*/G* − 1) a_x^2/R] of an ellipse, whose a is the geometric mean of its "
              "half axes"
            : "";
    return body + " The unit of shift is U_max = μ (E*/G*) d" + ellipse + ".";
}

std::string results_note(const Case& c, bool several_models) {
    std::string text = "Ratios u are over each model's own U_max. ";
    if (contact::is_hertz_round(c))
        text +=
            "The theory column is Hertz (pressed), Cattaneo and Mindlin (static shift) and, after "
            "rolling, the closed form of the method of dimensionality reduction (MDR); its limit "
            "f_T,lim = 1 − 3/2 w + 1/2 w^3 is exact for every uncoupled contact under Hertz' "
            "pressure.";
    else if (c.is_cylindrical())
        text +=
            "The theory column is the line contact of the half-space, without coupling: Hertz "
            "(pressed), Cattaneo (static shift) and, after rolling, the exact solution of "
            "docs/cylinder.md with the limit f_T,lim = (2/π) [arccos w − w (1 − w^2)^(1/2)].";
    else
        text +=
            "The theory column is frictionless contact on the half-space (pressed), the "
            "superposition of two normal contacts (static shift) and, after rolling, the method "
            "of dimensionality reduction (MDR) where it holds; the limit f_T,lim is what the "
            "least pressures over the path carry, exact for uncoupled contact.";
    if (several_models) text += " Last columns: by how much a model differs from the last model.";
    return text;
}

std::string rolling_note(const Case& c) {
    const bool round = contact::is_hertz_round(c);
    std::string text;
    if (round)
        text +=
            "Mapping parameter κ: from f_T = 1 − κ w u − (1 − u)^(3/2) with the settled shift u; "
            "3/2 for MDR, about 1 along and 1.1 across the load for three-dimensional contact "
            "(Wetter); only after shakedown. ";
    text += "Ratcheting slope η: Δu/(w − w_lim) with the last period's Δu and ";
    text += round ? "1 − 3/2 w_lim + 1/2 w_lim^3 = f_T" : "the half-space's limit w_lim at f_T";
    text += "; only while ratcheting.";
    if (c.is_cylindrical())
        text +=
            " W_0: frictional work of one cycle of a tangential force oscillating between ±f_T "
            "μF_N in line contact, μ^2 2 F_N^2/(πE*L) [f (2 − f) + 2 (1 − f) ln(1 − f)].";
    if (round)
        text +=
            " W_0: frictional work of one cycle of a tangential force oscillating between ±f_T "
            "μF_N, after Mindlin and Deresiewicz, with each model's own F_N and a.";
    return text;
}

std::string layer_note(const Case& c) {
    const bool line = c.is_cylindrical();
    return std::string(
               "Pressed without friction. Exact layer: the frictionless contact of a "
               "rigid body with an infinitely wide layer on its rigid ground, ") +
           (line ? "a singular integral equation of plane strain"
                 : "a Fredholm equation in one dimension") +
           ". Half-space: " + (contact::is_hertz_round(c) ? "Hertz" : "the body's contact there") +
           ". The stiffness of half-space models is " + (line ? "πE*L/(2 ln(2L/a))" : "2 E*a") +
           ", that of others is taken from presses at 0.6, 0.8 and 1 times the load.";
}

std::string variants_note(const Case& c) {
    return std::string("Each row loads the case once more with one key changed.") +
           (c.rolling ? " Contacts that shake down are rolled by turning points until nothing "
                        "moves, or 40 "
                        "periods, “this run” too, so that its value may differ from that of the "
                        "case's own steps and periods; what ratchets is rolled as the case has it."
                      : "");
}

}  // namespace tricontact::comparisons

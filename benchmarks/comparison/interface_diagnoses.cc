#include <fmt/format.h>

#include <cmath>

#include "benchmarks/comparison/diagnoses.h"
#include "report/format.h"

// Of the way in which a code enforces contact and friction.
namespace tricontact::benchmarks {

namespace {

namespace keys = quantity_keys;
constexpr double wished = 1e-3;  // what a remedy aims at

const Explained* explained_by(const Evidence& e, const char* id, const ComparedNumber** of) {
    for (const ComparedNumber& n : e.c.numbers)
        for (const Explained& x : n.explained)
            if (x.id == id) {
                *of = &n;
                return &x;
            }
    return nullptr;
}

double radius_of(const Evidence& e) {
    return e.c.reference.c.indenter.radius;
}

}  // namespace

std::optional<Diagnosis> penalty(const Evidence& e) {
    const ComparedNumber* n = nullptr;
    const Explained* x = explained_by(e, "penalty", &n);
    if (!x || std::abs(x->change) < noteworthy_share * n->tolerance) return {};
    const double k = *e.c.submission.contact.stiffness;
    return Diagnosis{
        "penalty",
        fmt::format("The normal penalty yields by p0/K = {:.3g} µm and changes {} by {}: "
                    "dF = -(1/2K) d/dd of the integral of p^2",
                    1e6 * e.peak_pressure() / k, n->title, report::signed_share(x->change, 2)),
        fmt::format("a stiffness of {:.3g} MPa/mm changes it by 0.1 %, an augmented Lagrangian by "
                    "nothing",
                    1e-9 * k * std::abs(x->change) / wished)};
}

std::optional<Diagnosis> elastic_slip(const Evidence& e) {
    const ComparedNumber* n = nullptr;
    const Explained* x = explained_by(e, "stick_slope", &n);
    if (!x || std::abs(x->change) < noteworthy_share * n->tolerance) return {};
    const double k = *e.c.submission.contact.stick_slope;
    const double mu = e.c.reference.c.friction_coefficient();
    return Diagnosis{
        "tangential_springs",
        fmt::format("Points that stick slip elastically by up to mu p0/K_T = {:.3g} µm, which "
                    "changes {} by {}",
                    1e6 * mu * e.peak_pressure() / k, n->title, report::signed_share(x->change, 2)),
        fmt::format("a stick slope of {:.3g} MPa/mm changes it by 0.1 %",
                    1e-9 * k * std::abs(x->change) / wished)};
}

std::optional<Diagnosis> facets(const Evidence& e) {
    const auto& k = e.c.submission.contact.stiffness;
    const double h = e.finest().result.size, radius = radius_of(e);
    if (!k || !(radius > 0) || !alternating_pressure(e)) return {};
    const double excess = *k * h * h / (8 * radius);
    if (excess < .2 * e.peak_pressure()) return {};
    return Diagnosis{
        "facets",
        fmt::format("Straight faces of {:.3g} mm leave gaps under the curved body: K h^2/(8 R) = "
                    "{:.2g} p0, so that pressures of a penalty alternate from node to node",
                    1e3 * h, excess / e.peak_pressure()),
        fmt::format("a stiffness below p0 8 R/(5 h^2) = {:.3g} MPa/mm, quadratic faces, or mortar "
                    "contact",
                    1e-9 * e.peak_pressure() * 8 * radius / (5 * h * h))};
}

std::optional<Diagnosis> faceted_indenter(const Evidence& e) {
    if (!e.c.submission.contact.faceted_indenter) return {};
    const ReferenceValue* d = e.c.reference.find(keys::indentation);
    const double h = e.finest().result.size, radius = radius_of(e);
    if (!d || !(radius > 0)) return {};
    const double chord = h * h / (8 * radius);
    // F goes with d^(3/2): relative to the force, one and a half times.
    if (1.5 * chord / d->value < noteworthy_share * e.c.submission.tolerances.usual) return {};
    return Diagnosis{
        "indenter_facets",
        fmt::format("The meshed indenter's faces stand back from its surface by up to h^2/(8 R) = "
                    "{:.3g} µm, {:.2g} % of the depth",
                    1e6 * chord, 100 * chord / d->value),
        "an analytic surface, or faces half as long: the distance falls to a quarter"};
}

std::optional<Diagnosis> pressed_in_one_step(const Evidence& e) {
    const ComparedNumber* n = nullptr;
    const Explained* x = explained_by(e, "one_step", &n);
    if (!x || std::abs(x->change) < noteworthy_share * n->tolerance) return {};
    return Diagnosis{
        "one_step",
        fmt::format("It was pressed in one step, where the case presses in {}: with "
                    "friction this changes {} by {}",
                    e.c.reference.c.load.press_steps, n->title, report::signed_share(x->change, 2)),
        "press in as many steps as the case"};
}

std::optional<Diagnosis> no_friction_in_pressing(const Evidence& e) {
    const Reference& reference = e.c.reference;
    const auto& points = e.finest().result.points;
    if (e.samples.empty() || !reference.has_friction() || points.empty() ||
        !std::isfinite(points.front().values.traction_x))
        return {};
    double code = 0, own = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const SurfaceValues &v = points[i].values, &r = e.samples.back().values[i];
        code += points[i].area * std::abs(v.traction_x);
        own += points[i].area * std::hypot(r.traction_x, r.traction_y);
    }
    if (!(own > 0) || code > .05 * own) return {};
    return Diagnosis{"uncoupled",
                     fmt::format("The code's tangential tractions are {:.2g} % of the reference's: "
                                 "friction did not act, or they were not written",
                                 100 * code / own),
                     "let friction act from the first touch on, and write both components"};
}

}  // namespace tricontact::benchmarks

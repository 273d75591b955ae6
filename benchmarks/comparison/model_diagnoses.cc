#include <fmt/format.h>

#include <array>
#include <cmath>

#include "benchmarks/comparison/diagnoses.h"
#include "benchmarks/comparison/explained.h"
#include "report/format.h"

// Of what a code's model is: kinematics, block, material.
namespace tricontact::benchmarks {

namespace {

namespace keys = quantity_keys;
using Kinematics = ContactMethod::Kinematics;
constexpr double large_slope = .2;  // a/R, where finite strains matter beside the tolerance
constexpr double least_locking_poisson = .45, least_locking = .1, least_other = .05;

const ComparedNumber* force_or_depth(const Evidence& e) {
    const ComparedNumber* force = e.find(keys::normal_force);
    return force ? force : e.find(keys::indentation);
}

}  // namespace

std::optional<Diagnosis> displaced_kinematics(const Evidence& e) {
    const ComparedNumber* n = force_or_depth(e);
    const Kinematics kinematics = e.c.submission.contact.kinematics;
    if (!n || (kinematics != Kinematics::displaced && kinematics != Kinematics::finite)) return {};
    const auto x = displaced_surface(n->key, e.c.reference);
    if (!x || std::abs(x->change) < noteworthy_share * n->tolerance) return {};
    return Diagnosis{"displaced_surface",
                     fmt::format("Gap and normal on the displaced surface change {} by {} ± {:.2g} "
                                 "% at a/R = {:.3g}; the reference has them on the undeformed one",
                                 n->title, report::signed_share(x->change), 100 * x->bar,
                                 edge_slope(e.c.reference)),
                     "small displacements in the contact's kinematics, or a smaller depth: the "
                     "change goes with a/R"};
}

std::optional<Diagnosis> unknown_kinematics(const Evidence& e) {
    const ComparedNumber* n = force_or_depth(e);
    if (!n || e.c.submission.contact.kinematics != Kinematics::unknown) return {};
    const auto x = displaced_surface(n->key, e.c.reference);
    if (!x || std::abs(x->change) < n->tolerance / 2 || n->standing == Standing::pass) return {};
    if (std::abs(n->left() - x->change) > x->bar + std::min(n->discretisation, x->bar)) return {};
    return Diagnosis{
        "kinematics_unknown",
        fmt::format("{} differs by {}; contact on the displaced surface would change it by {} ± "
                    "{:.2g} %",
                    n->title, report::signed_share(n->left()), report::signed_share(x->change),
                    100 * x->bar),
        "say in the submission which surface the gap is measured on: contact.kinematics"};
}

std::optional<Diagnosis> finite_strains(const Evidence& e) {
    const Kinematics kinematics = e.c.submission.contact.kinematics;
    const double slope = edge_slope(e.c.reference);
    if (kinematics != Kinematics::finite &&
        !(kinematics == Kinematics::displaced && slope > large_slope))
        return {};
    return Diagnosis{
        "finite_strain",
        fmt::format("Strains are of the order a/R = {:.3g}; the reference's are small. "
                    "What they change beyond the displaced surface is of the order "
                    "(a/R)^2 = {:.2g} %",
                    slope, 100 * slope * slope),
        "compare at a smaller depth, or with fem and substrate.law = \"neo-hookean\""};
}

std::optional<Diagnosis> finite_block(const Evidence& e) {
    const auto& width = e.c.submission.block_width;
    if (!width) return {};
    for (const ComparedNumber& n : e.c.numbers)
        for (const Explained& x : n.explained)
            if (x.id == "block" && std::abs(x.change) + x.bar > noteworthy_share * n.tolerance)
                return Diagnosis{
                    "block",
                    fmt::format("The block ends at {:.3g} a from the centre: against an unbounded "
                                "layer this changes {} by {} ± {:.1g} %",
                                *width / e.c.reference.contact_radius, n.title,
                                report::signed_share(x.change), 100 * x.bar),
                    "a wider block"};
    return {};
}

std::optional<Diagnosis> locking(const Evidence& e) {
    const double poisson = e.c.reference.c.substrate.poisson;
    const ComparedNumber* n = e.find(keys::normal_force);
    if (!n || !(poisson > least_locking_poisson) || n->finest < least_locking) return {};
    std::optional<double> last;
    for (const auto& value : n->values) {
        if (!value) continue;
        if (last && !(*value < *last)) return {};
        last = value;
    }
    const double first = n->values.front().value_or(0) / n->reference.value - 1;
    return Diagnosis{
        "locking",
        fmt::format("At nu = {:.4g} the force is {:.0f} % too large on the coarsest mesh and "
                    "{:.0f} % on the finest: elements that cannot keep their volume lock",
                    poisson, 100 * first, 100 * n->finest),
        "the control experiment is the same deck at nu = 0.3; if that agrees, take quadratic, "
        "reduced or mixed elements"};
}

std::optional<Diagnosis> other_load(const Evidence& e) {
    const auto& totals = e.finest().result.totals;
    for (const std::string& key : e.c.reference.prescribed) {
        const ReferenceValue* due = e.c.reference.find(key);
        const auto given = totals.find(key);
        if (!due || due->value == 0 || given == totals.end()) continue;
        const double off = std::abs(given->second / due->value) - 1;
        if (std::abs(off) < noteworthy_share * e.c.submission.tolerances.usual) continue;
        return Diagnosis{"load",
                         fmt::format("The code's {} is {:+.3g} % off what the case prescribes, "
                                     "{:.6g} in SI units: all else follows it",
                                     key, 100 * off, due->value),
                         "compute the case's load, or give this one's as a case file"};
    }
    return {};
}

std::optional<Diagnosis> half_load(const Evidence& e) {
    const ComparedNumber* n = e.find(keys::normal_force);
    if (!n) return {};
    for (const double factor : {.5, 2., .25, 4.})
        if (std::abs((1 + n->finest) / factor - 1) < .03)
            return Diagnosis{
                "half_load",
                fmt::format("The force is {:.4g} of the reference's, near {:g}, and so "
                            "is the integral of the pressures",
                            1 + n->finest, factor),
                "look for a half of the load or of the contact: a symmetric part whose "
                "force was taken as that of the whole, or the reverse"};
    return {};
}

std::optional<Diagnosis> other_parameters(const Evidence& e) {
    const ComparedNumber *force = e.find(keys::normal_force), *a = e.find(keys::contact_radius),
                         *p0 = e.find(keys::peak_pressure);
    if (!force || !a || !p0 || force->standing != Standing::fail || locking(e)) return {};
    if (std::abs(force->left()) < least_other) return {};
    // At a given depth of the half-space a^2 = R d and p0 goes with E* d/a.
    const double radius = std::pow(1 + a->difference, 2);
    const double modulus = (1 + p0->difference) * (1 + a->difference);
    if (std::abs((1 + force->difference) / (modulus * std::sqrt(radius)) - 1) > .1) return {};
    const double nu = e.c.reference.c.substrate.poisson;
    struct Cause {
        double modulus, radius;
        const char* text;
    };
    const std::array causes{Cause{1 - nu * nu, 1, "E in place of E/(1 - nu^2): plane stress"},
                            Cause{1, 2, "the diameter in place of the radius"},
                            Cause{1, .5, "the radius in place of the diameter"},
                            Cause{1 / (2 * (1 + nu)), 1, "the shear modulus in place of E"},
                            Cause{2 * (1 + nu), 1, "E in place of the shear modulus"},
                            Cause{1 / (1 - nu * nu), 1, "E* in place of E"}};
    std::string text;
    for (const Cause& cause : causes)
        if (std::abs(modulus / cause.modulus - 1) < .04 &&
            std::abs(radius / cause.radius - 1) < .08)
            text = std::string(": as if by ") + cause.text;
    return Diagnosis{
        "parameters",
        fmt::format("Force, radius and peak together are those of {:.3g} E* and {:.3g} R, "
                    "as on the half-space at one depth{}",
                    modulus, radius, text),
        "compare E, nu and R of the input with those of the case"};
}

}  // namespace tricontact::benchmarks

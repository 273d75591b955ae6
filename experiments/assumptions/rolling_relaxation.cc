// A substrate whose relaxation is known: is it relaxed when shifts are read, and at the drive's
// speed?
#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "contact/substrates/relaxation.h"
#include "experiments/assumptions/rolling_parts.h"

namespace tricontact::experiments {

namespace {

constexpr double largest_loss_ratio = 0.01;
constexpr const char* maxwell = "generalised Maxwell solid, Christensen (1982), ch. 1";

/// g_i = G_i/G_inf and tau_i [s] of all branches in turn.
void add_branches(std::vector<Given>& given, const contact::Relaxation& relaxation) {
    int i = 0;
    for (const auto& [ratio, time] : relaxation.branches) {
        ++i;
        given.push_back({fmt::format("g_{}", i), {ratio}, "1"});
        given.push_back({fmt::format("tau_{}", i), {time}, "s"});
    }
}

/// Of values whose branches stand behind the first n.
contact::Relaxation relaxation_of(const Values& x, std::size_t n) {
    contact::Relaxation relaxation;
    for (std::size_t i = n; i + 1 < x.size(); i += 2)
        relaxation.branches.push_back({x[i], x[i + 1]});
    return relaxation;
}

/// Of values of v, w, a and the branches.
std::complex<double> dynamic_ratio(const Values& x) {
    return relaxation_of(x, 3).dynamic_ratio(2 * std::numbers::pi * x[0] / (4 * x[1] * x[2]));
}

/// What is still to come of the shift under a force that acts for the first value [s], over its
/// end: 1 - J(t)/J(infinite).
double creep_left(const Values& x) {
    const contact::Retardation creep(relaxation_of(x, 1), 0);
    double left = 0;
    for (const auto& [compliance, time] : creep.branches)
        left += compliance * std::exp(-x[0] / time);
    return left / creep.relaxed;
}

void decide_at_drive(Assumption& a, const Rig& rig) {
    using enum Criterion::Relation;
    if (!has_all(a, rig, "v w a'")) return;
    std::vector<Given> values = given(rig, "v w a'");
    add_branches(values, *rig.relaxation);
    a.criteria.push_back(
        {calculate("loss_ratio", "G''/G_1",
                   "sum g_i omega tau_i/(1 + (omega tau_i)^2), omega = 2 pi v/(4 w a)", maxwell,
                   "1", values, [](const Values& x) { return dynamic_ratio(x).imag(); }),
         at_most, largest_loss_ratio, "bounds the loss angle"});
    a.criteria.push_back(
        {calculate("stiffening", "G'/G_1 - 1",
                   "sum g_i (omega tau_i)^2/(1 + (omega tau_i)^2), omega = 2 pi v/(4 w a)", maxwell,
                   "1", values, [](const Values& x) { return dynamic_ratio(x).real() - 1; }),
         at_most, accepted_difference, accepted_reason});
    a.consequence = fmt::format(
        "At the drive's lowest frequency the substrate is {} stiffer than relaxed, and {} of that "
        "stiffness is "
        "loss.",
        percent_text(a.criteria.back().calculation.result.value, 2),
        percent_text(
            dynamic_ratio(values_of(values)).imag() / dynamic_ratio(values_of(values)).real(), 2));
}

void decide_at_rest(Assumption& a, const Rig& rig) {
    if (!has_all(a, rig, "t_rest")) return;
    std::vector<Given> values = given(rig, "t_rest");
    add_branches(values, *rig.relaxation);
    a.criteria.push_back({calculate("creep_left", "1 - J(t_rest)/J_inf",
                                    "sum j_i exp(-t_rest/lambda_i), J the creep of G(t)",
                                    "Tschoegl (1989), ch. 4", "1", std::move(values), creep_left),
                          Criterion::Relation::at_most, accepted_difference, accepted_reason});
    a.consequence +=
        fmt::format("{}After {} under F_T {} of the static shift is still to come.",
                    a.consequence.empty() ? "" : " ", quantity(rig["t_rest"].value, "s", 3),
                    percent_text(a.criteria.back().calculation.result.value, 2));
}

}  // namespace

Assumption relaxed_substrate(const Rig& rig) {
    Assumption a{.name = "elastic_substrate",
                 .title = "Elastic substrate",
                 .claim =
                     "The substrate is elastic, and relaxed, at the speed of the drive and "
                     "when static shifts are read"};
    decide_at_drive(a, rig);
    decide_at_rest(a, rig);
    return a;
}

}  // namespace tricontact::experiments

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
std::vector<Given> branches_of(const Rig& rig) {
    std::vector<Given> given;
    int i = 0;
    for (const auto& [ratio, time] : rig.c.relaxation->branches) {
        ++i;
        given.push_back({fmt::format("g_{}", i), {ratio}, "1"});
        given.push_back({fmt::format("tau_{}", i), {time}, "s"});
    }
    return given;
}

std::complex<double> dynamic_ratio(const contact::Relaxation& relaxation, const RigData& r) {
    return relaxation.dynamic_ratio(2 * std::numbers::pi * r.v / (4 * r.w * r.a_reference));
}

/// What is still to come of the shift under a force that acts for a time, over its end:
/// 1 - J(t)/J(infinite).
double creep_left(const contact::Relaxation& relaxation, double after) {
    const contact::Retardation creep(relaxation, 0);
    double left = 0;
    for (const auto& [compliance, time] : creep.branches)
        left += compliance * std::exp(-after / time);
    return left / creep.relaxed;
}

void decide_at_drive(Assumption& a, const Rig& rig) {
    using enum Criterion::Relation;
    constexpr Inputs drive{&Rig::v, &Rig::w, &Rig::a_reference};
    if (!has_all(a, rig, drive)) return;
    const auto ratio = [relaxation = *rig.c.relaxation](const RigData& r) {
        return dynamic_ratio(relaxation, r);
    };
    const std::vector<Given> branches = branches_of(rig);
    a.criteria.push_back(
        {calculate(
             rig, "loss_ratio", "G''/G_1",
             "sum g_i omega tau_i/(1 + (omega tau_i)^2), omega = 2 pi v/(4 w a)", maxwell, "1",
             drive, [ratio](const RigData& r) { return ratio(r).imag(); }, branches),
         at_most, largest_loss_ratio, "bounds the loss angle"});
    a.criteria.push_back(
        {calculate(
             rig, "stiffening", "G'/G_1 - 1",
             "sum g_i (omega tau_i)^2/(1 + (omega tau_i)^2), omega = 2 pi v/(4 w a)", maxwell, "1",
             drive, [ratio](const RigData& r) { return ratio(r).real() - 1; }, branches),
         at_most, accepted_difference, accepted_reason});
    const auto loss = a.criteria.front().calculation.result.value,
               stiffening = a.criteria.back().calculation.result.value;
    a.consequence = fmt::format(
        "At the drive's lowest frequency the substrate is {} stiffer than relaxed, and {} of that "
        "stiffness is "
        "loss.",
        percent_text(stiffening, 2), percent_text(loss / (1 + stiffening), 2));
}

void decide_at_rest(Assumption& a, const Rig& rig) {
    constexpr Inputs rest{&Rig::t_rest};
    if (!has_all(a, rig, rest)) return;
    a.criteria.push_back({calculate(
                              rig, "creep_left", "1 - J(t_rest)/J_inf",
                              "sum j_i exp(-t_rest/lambda_i), J the creep of G(t)",
                              "Tschoegl (1989), ch. 4", "1", rest,
                              [relaxation = *rig.c.relaxation](const RigData& r) {
                                  return creep_left(relaxation, r.t_rest);
                              },
                              branches_of(rig)),
                          Criterion::Relation::at_most, accepted_difference, accepted_reason});
    a.consequence += fmt::format("{}After {} under F_T {} of the static shift is still to come.",
                                 a.consequence.empty() ? "" : " ", quantity(rig.t_rest, "s", 3),
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

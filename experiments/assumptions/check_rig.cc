#include "experiments/assumptions/check_rig.h"

#include <cmath>

#include "experiments/assumptions/assumption_list.h"
#include "experiments/assumptions/rolling_parts.h"

namespace tricontact::experiments {

std::optional<ForceCurves> force_curves(const Rig& rig) {
    if (rig.kind != Rig::Kind::sphere || !rig.b.is_known() || !roller_is_rigid(rig)) return {};
    constexpr int n_points = 31;
    ForceCurves curves;
    curves.rig_force = rig.F_N;
    if (rig.D_c.is_known()) curves.measured_diameter = rig.D_c;
    RigData loaded = rig;
    for (int i = 0; i < n_points; ++i) {
        const double force = curves.rig_force.value * 1.5 * (i + 1) / n_points;
        loaded.F_N = force;
        const contact::HalfSpaceScales hertz = hertz_of(loaded);
        const theory::LayerContact layer = layer_of(loaded);
        curves.force.push_back(force);
        curves.diameter.hertz.push_back(2 * hertz.contact_radius);
        curves.diameter.layer.push_back(2 * layer.contact_radius);
        curves.indentation.hertz.push_back(hertz.indentation);
        curves.indentation.layer.push_back(layer.indentation);
    }
    return curves;
}

namespace {

using Agreement = PrintedCheck::Agreement;

// In half digits: prints are computed from rounded numbers, which moves them a little further.
constexpr double rounding_margin = 1.1;

const Calculation* find(const std::string& name, const std::vector<Assumption>& assumptions) {
    for (const Assumption& assumption : assumptions)
        if (const Calculation* found = assumption.find(name)) return found;
    return nullptr;
}

Agreement agreement(const PrintedValue& printed, const Estimate& computed) {
    const double difference = std::abs(printed.value.value - computed.value);
    if (difference <= printed.half_digit * rounding_margin) return Agreement::agrees;
    const double error = std::max(printed.value.standard_error, computed.standard_error);
    return difference <= error ? Agreement::within_error : Agreement::differs;
}

PrintedCheck check(const PrintedValue& printed, const Calculation* calculation) {
    PrintedCheck check;
    check.printed = printed;
    if (!calculation) return check;
    check.calculation = *calculation;
    const Estimate& computed = calculation->result;
    check.agreement = agreement(printed, computed);
    check.ratio = printed.value.value / computed.value;
    if (printed.value.standard_error > 0 && computed.standard_error > 0) {
        check.error_ratio = printed.value.standard_error / computed.standard_error;
        check.error_agrees = std::abs(printed.value.standard_error - computed.standard_error) <=
                             printed.half_error_digit * rounding_margin;
    }
    if (check.agreement != Agreement::agrees)
        check.substitutes = substitutes(*calculation, printed.value.value);
    return check;
}

}  // namespace

bool has_soft_indenter(const Rig& rig) {
    const bool is_ball_or_line = rig.kind == Rig::Kind::sphere || rig.kind == Rig::Kind::cylinder;
    return is_ball_or_line && rig.b.is_known() && !roller_is_rigid(rig);
}

RigReport check_rig(const Rig& rig, const StaticShift& static_shift, const RolledGrowth& growth,
                    const IndenterRun& indenter) {
    RigReport report{.title = rig.title, .assumptions = assumptions_of(rig, static_shift, growth)};
    if (has_soft_indenter(rig))
        report.assumptions.push_back(at_values_of(rig, half_space_indenter(rig, indenter)));
    report.effects = effects_on_measured(rig, report.assumptions);
    report.printed = check_printed(rig.printed, report.assumptions);
    return report;
}

std::vector<PrintedCheck> check_printed(const std::vector<PrintedValue>& printed,
                                        const std::vector<Assumption>& assumptions) {
    std::vector<PrintedCheck> checks;
    for (const PrintedValue& value : printed)
        checks.push_back(check(value, find(value.name, assumptions)));
    return checks;
}

}  // namespace tricontact::experiments

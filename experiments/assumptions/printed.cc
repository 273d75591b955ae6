#include "experiments/assumptions/printed.h"

#include <cmath>

namespace tricontact::experiments {

namespace {

using Agreement = PrintedCheck::Agreement;

// In half digits: prints are computed from rounded numbers, which moves them a little further.
constexpr double rounding_margin = 1.1;

const Calculation* find(const std::string& name, const std::vector<Assumption>& assumptions) {
    for (const Assumption& assumption : assumptions) {
        for (const Criterion& criterion : assumption.criteria)
            if (criterion.calculation.name == name) return &criterion.calculation;
        for (const Calculation& calculation : assumption.background)
            if (calculation.name == name) return &calculation;
    }
    return nullptr;
}

Agreement agreement(const PrintedValue& printed, const statistics::Uncertain& computed) {
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
    const statistics::Uncertain& computed = calculation->result;
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

std::vector<PrintedCheck> check_printed(const std::vector<PrintedValue>& printed,
                                        const std::vector<Assumption>& assumptions) {
    std::vector<PrintedCheck> checks;
    for (const PrintedValue& value : printed)
        checks.push_back(check(value, find(value.name, assumptions)));
    return checks;
}

}  // namespace tricontact::experiments

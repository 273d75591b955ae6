#include "experiments/predictions/found_numbers.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "experiments/identification/law_parameters.h"
#include "experiments/identification/loop_values.h"
#include "io/case/case_keys.h"

namespace tricontact::experiments {

namespace {

std::string override_of(const io::CaseKey& key, double value) {
    const std::string_view unit = io::si_unit(key.dimension);
    return key.dimension == io::Dimension::none ? fmt::format("{}={}", key.path, value)
                                                : fmt::format("{}={} {}", key.path, value, unit);
}

bool tells_all(const LawFit& fit) {
    for (std::size_t k = 0; k < fit.found.free.size(); ++k)
        if (fit.found.free[k].key != rig_stiffness_key &&
            !std::isfinite(fit.found.parameters[k].standard_error))
            return false;
    return true;
}

}  // namespace

std::vector<std::string> overrides_of(contact::Case c, const Identification& found) {
    std::vector<std::string> overrides;
    for (const io::CaseKey& key : io::case_keys()) {
        const bool is_found = found.find(std::string(key.path)).has_value();
        if (key.section() != "friction" && !is_found) continue;
        if (const double* number = io::number_of(key, c))
            overrides.push_back(override_of(key, *number));
    }
    return overrides;
}

bool is_at_an_end(const LawFit& fit) {
    for (std::size_t k = 0; k < fit.found.free.size(); ++k) {
        const FreeParameter& p = fit.found.free[k];
        if (p.key == rig_stiffness_key || p.key == drift_key) continue;  // a rigid rig is one
        if (const double value = fit.found.parameters[k].value;
            !std::isfinite(value) || p.is_at_bound(value))
            return true;
    }
    return false;
}

bool has_largest_exponent(const LawFit& fit) {
    const auto k = fit.found.find(std::string(exponent_key));
    return k && fit.found.parameters[*k].value > 1 &&
           fit.found.free[*k].is_at_bound(fit.found.parameters[*k].value);
}

std::string why_untold(const LawFit& fit) {
    if (has_largest_exponent(fit)) return "its exponent is at the end of its range";
    if (is_at_an_end(fit))
        return "its numbers are at the end of their range, where it is a law that it contains";
    return tells_all(fit) ? "" : "the tables do not tell its numbers";
}

}  // namespace tricontact::experiments

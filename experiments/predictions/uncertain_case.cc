#include "experiments/predictions/uncertain_case.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "contact/base/error.h"
#include "contact/load_path.h"
#include "experiments/identification/identification_models.h"
#include "io/case/case_keys.h"

namespace tricontact::experiments {

namespace {

using contact::Case;

/// Of an uncertain f_T or w: the force, or the length, that the rig sets.
std::optional<CaseQuantity> set_quantity(const io::CaseKey& key, double standard_error, Case c,
                                         double friction_limit, double amplitude) {
    const double* stated = io::number_of(key, c);
    const std::string name(key.path);
    if (stated && name == "load.tangential_ratio")
        return CaseQuantity{
            .name = name,
            .standard_error = standard_error * friction_limit,
            .of_case = [](Case& set) -> double& { return *set.load.tangential_force; }};
    if (stated && name == "rolling.amplitude_ratio")
        return CaseQuantity{
            .name = name,
            .standard_error = standard_error * amplitude / *stated,
            .of_case = [](Case& set) -> double& { return *set.rolling->amplitude; }};
    return {};
}

}  // namespace

UncertainCase uncertain_case(const Case& c, double friction_limit, double amplitude,
                             const std::vector<io::UncertainKey>& uncertain) {
    UncertainCase result{as_the_rig_sets(c, friction_limit, amplitude), {}};
    for (const io::UncertainKey& one : uncertain) {
        const io::CaseKey& key = *io::find_key(one.key->path);
        const double error = one.number.value.standard_error;
        auto quantity = set_quantity(key, error, c, friction_limit, amplitude);
        if (!quantity && !io::number_of(key, result.set))
            throw contact::InputError(fmt::format(
                "{}: {}: an uncertainty of this ratio is not propagated; state the length or the "
                "force that it stands for",
                one.place, key.path));
        if (!quantity)
            quantity = CaseQuantity{
                .name = std::string(key.path),
                .standard_error = error,
                .of_case = [&key](Case& any) -> double& { return *io::number_of(key, any); },
                .largest = key.range.high};
        quantity->distribution = one.number.distribution;
        result.quantities.push_back(std::move(*quantity));
    }
    return result;
}

UncertainCase uncertain_case(const Case& c, const std::vector<io::UncertainKey>& uncertain) {
    const contact::HalfSpaceScales scales = contact::half_space_scales(c);
    const double amplitude = c.rolling ? contact::path_amplitude(c, scales.contact_radius) : 0;
    return uncertain_case(c, scales.friction_limit, amplitude, uncertain);
}

std::vector<double> steepest_direction(const std::vector<double>& changes,
                                       const statistics::Correlations::Matrix& correlation) {
    const double variance = statistics::combined_variance(changes, correlation);
    if (!(variance > 0)) return {};
    std::vector<double> direction(changes.size(), 0.);
    for (std::size_t i = 0; i < changes.size(); ++i)
        for (std::size_t k = 0; k < changes.size(); ++k) {
            const double r = correlation.empty() ? (i == k ? 1. : 0.) : correlation[i][k];
            direction[i] += r * changes[k] / std::sqrt(variance);
        }
    return direction;
}

Case displaced(const UncertainCase& uncertain, const std::vector<double>& direction,
               double deviations) {
    constexpr double least_share_of_value = 1e-6;  // of what has to stay positive
    Case c = uncertain.set;
    for (std::size_t i = 0; i < direction.size(); ++i) {
        const CaseQuantity& quantity = uncertain.quantities[i];
        double& number = quantity.of_case(c);
        const double before = number;
        const double probability = std::erfc(-deviations * direction[i] / std::sqrt(2.)) / 2;
        number += quantity.standard_error *
                  statistics::standard_quantile(quantity.distribution, probability);
        if (number > quantity.largest) number = 2 * quantity.largest - number;
        if (before > 0) number = std::max(number, least_share_of_value * before);
    }
    return c;
}

std::vector<std::string> UncertainCase::names() const {
    std::vector<std::string> names;
    for (const CaseQuantity& one : quantities) names.push_back(one.name);
    return names;
}

}  // namespace tricontact::experiments

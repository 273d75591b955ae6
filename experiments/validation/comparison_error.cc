#include "experiments/validation/comparison_error.h"

#include <fmt/format.h>

#include <algorithm>
#include <boost/algorithm/string/replace.hpp>
#include <cmath>

#include "experiments/validation/student_sum.h"
#include "report/format.h"

namespace tricontact::experiments {

namespace {

constexpr double confidence = .95;
constexpr double least_told_share = .01;  // of a contributor

/// "+1.4 ± 6.8": both to the second digit of the half width.
std::string signed_with_half_width(double value, double half_width) {
    const int decimals =
        half_width > 0 ? std::max(0, 1 - static_cast<int>(std::floor(std::log10(half_width)))) : 3;
    const double unit = std::pow(10., -decimals);
    const double rounded = std::round(value / unit) * unit + 0.0;  // no "−0"
    return boost::replace_all_copy(
        fmt::format("{:+.{}f} ± {:.{}f}", rounded, decimals, half_width, decimals), "-", "−");
}

}  // namespace

double ComparisonError::standard_error() const {
    double squares = covariance;
    for (const UncertaintySource& one : sources) squares += one.standard_error * one.standard_error;
    return std::sqrt(std::max(0., squares));
}

double ComparisonError::half_width() const {
    double known = covariance;
    std::vector<EstimatedError> estimated;
    for (const UncertaintySource& one : sources)
        if (std::isfinite(one.degrees_of_freedom))
            estimated.push_back({one.standard_error, one.degrees_of_freedom});
        else
            known += one.standard_error * one.standard_error;
    return half_width_of_sum(known, std::move(estimated));
}

bool ComparisonError::agrees() const {
    return std::abs(difference()) <= half_width();
}

double ComparisonError::resolution() const {
    constexpr double one_sided = 2 * confidence - 1;  // as the confidence of a two-sided interval
    return (half_width() + statistics::normal_quantile(one_sided) * standard_error()) /
           std::abs(computed);
}

std::vector<std::pair<std::string, double>> ComparisonError::shares() const {
    std::vector<std::pair<std::string, double>> shares;
    const double error = standard_error();
    if (error == 0) return shares;
    for (const UncertaintySource& one : sources)
        shares.emplace_back(one.name, std::pow(one.standard_error / error, 2));
    if (covariance != 0) shares.emplace_back("correlations", covariance / (error * error));
    std::ranges::stable_sort(shares, std::greater(), &std::pair<std::string, double>::second);
    return shares;
}

bool is_excluded(double difference, double creep, double half_width) {
    const auto [low, high] = std::minmax({difference, difference + creep});
    return low > half_width || high < -half_width;
}

std::string largest_contributors(const ComparisonError& error, std::size_t most) {
    std::vector<std::string> told;
    for (const auto& [name, share] : error.shares()) {
        if (share < least_told_share || told.size() == most) break;
        told.push_back(fmt::format("{} {:.0f} %", name, 100 * share));
    }
    if (const double share = error.covariance / std::pow(error.standard_error(), 2);
        share <= -least_told_share)  // else others would seem to add up to more than all
        told.push_back(fmt::format("correlations −{:.0f} %", -100 * share));
    return fmt::format("{}", fmt::join(told, ", "));
}

std::string difference_text(double difference, double half_width, const std::string& unit) {
    const auto fitting = report::fitting_unit(std::max(std::abs(difference), half_width), unit);
    return signed_with_half_width(difference / fitting.factor, half_width / fitting.factor) + ' ' +
           fitting.symbol;
}

std::string statement(const ComparisonError& error, const std::string& unit) {
    return fmt::format(
        "measured minus computed: {} (95 %): {}; this comparison would have seen {} %; largest "
        "contributors: {}",
        difference_text(error.difference(), error.half_width(), unit),
        error.agrees() ? "agrees" : "disagrees", report::significant(100 * error.resolution(), 2),
        largest_contributors(error));
}

}  // namespace tricontact::experiments

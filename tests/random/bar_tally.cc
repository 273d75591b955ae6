#include "tests/random/bar_tally.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace tricontact::random_cases {

namespace {

// Where all agree: rounding.
constexpr double rounding = 1e-9;
constexpr double meant = .95;  // Roache's half widths

/// What each of the other runs changes.
std::string changes(const comparisons::NumericalError& error, const comparisons::Quantity& q,
                    double value) {
    std::string text;
    const auto add = [&](const char* name, const std::optional<comparisons::ResolvedRun>& run) {
        const auto other = run ? run->results.number(q) : std::nullopt;
        if (other) text += fmt::format(" {} {:+.2g}", name, *other - value);
    };
    add("2h", error.coarser);
    add("4h", error.coarsest);
    add("2h, 2dW", error.long_steps);
    add("2h, dW/4", error.short_steps);
    add("2h, wider", error.wide_block);
    return text;
}

}  // namespace

std::string BarTally::Place::text() const {
    return fmt::format("{} {} {} {}", i, model, body, loading);
}

std::string BarTally::Place::kind() const {
    const auto letter = loading.find_first_not_of("0123456789 ");
    return loading.substr(letter == std::string::npos ? 0 : letter);
}

void BarTally::count(const Place& place, const comparisons::NumericalError& error,
                     const comparisons::Quantity& q, std::optional<double> truth, double more) {
    const auto width = error.of(q), value = error.run->results.number(q);
    if (!width || !value || !truth) return;
    // After shakedown an increment is what is left of nothing; files tell it all the same.
    const bool is_told = error.run->results.told(q).has_value();
    const bool is_exact = error.is_exact(q);
    const std::string key = q.key + std::string(is_exact  ? " (exact)"
                                                : is_told ? ""
                                                          : " (not told)");
    const double off = std::abs(*value - *truth);
    if (*width == 0 && !is_exact) {
        ++n_zero_;
        fmt::print("{} {}: 0 and not exact\n", place.text(), key);
    }
    // What is prescribed is met by the solvers: to their tolerance, which no ± tells.
    const double least = (is_exact ? error.tolerance : rounding) * std::abs(*value);
    const bool held = off <= *width + more + least;
    std::vector<Count*> counts{&of_quantity_[key], &of_model_[place.model + ' ' + key]};
    if (!is_exact) counts.insert(counts.end(), {&all_, &of_kind_[place.kind()]});
    for (Count* count : counts) {
        ++count->n_told;
        count->n_held += held;
    }
    if (held) return;
    fmt::print("{} {}: {:.6g} ± {:.2g} (other {:.2g}), {:.6g} by the reference; changed:{}\n",
               place.text(), key, *value, *width, more, *truth, changes(error, q, *value));
}

bool BarTally::Count::is_enough() const {
    return n_held >= meant * n_told - 2 * std::sqrt(meant * (1 - meant) * n_told);
}

void BarTally::print() const {
    const auto row = [](const std::string& name, const Count& count) {
        fmt::print("{:<40} {:4} of {:4}{}\n", name, count.n_held, count.n_told,
                   count.is_enough() ? "" : "  too few");
    };
    row("all", all_);
    for (const auto* counts : {&of_quantity_, &of_model_, &of_kind_})
        for (const auto& [name, count] : *counts) row(name, count);
    if (n_zero_ > 0) fmt::print("{} are 0 and not exact\n", n_zero_);
}

bool BarTally::passed() const {
    return n_zero_ == 0 && all_.is_enough() &&
           std::ranges::all_of(of_quantity_, [](const auto& q) { return q.second.is_enough(); });
}

}  // namespace tricontact::random_cases

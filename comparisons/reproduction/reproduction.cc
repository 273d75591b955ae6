#include "comparisons/reproduction/reproduction.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

namespace tricontact::comparisons {

namespace {

constexpr double rounding = 1e-10;     // of sums of numbers of one unit
constexpr std::size_t most_told = 20;  // of what people are told

/// One value beside the kept one.
void compare(const std::string& file, const KeptNumber& kept, const KeptNumber& now,
             Reproduction& result) {
    if (kept.text == now.text) return;
    if (!kept.value || !now.value) {
        result.otherwise.push_back(fmt::format(
            "{}: {}: {} was kept, now it is {}", file, kept.place,
            kept.text.empty() ? "nothing" : kept.text, now.text.empty() ? "nothing" : now.text));
        return;
    }
    const double difference = std::abs(*now.value - *kept.value);
    if (difference == 0) return;
    const double relative = kept.scale > 0 ? difference / kept.scale : INFINITY;
    const bool agrees = relative <= result.tolerance ||
                        difference <= kept.stated_error.value_or(0) ||
                        difference <= rounding * kept.noise_scale;
    auto& list = result.changed;
    auto found = std::ranges::find_if(list, [&](const ChangedQuantity& one) {
        return one.file == file && one.quantity == kept.quantity;
    });
    if (found == list.end()) found = list.insert(found, {.file = file, .quantity = kept.quantity});
    ++found->n;
    // What does not agree is told before what does.
    if (found->n == 1 || (found->agrees && !agrees) ||
        (found->agrees == agrees && relative > found->difference)) {
        found->place = kept.place;
        found->kept = *kept.value;
        found->now = *now.value;
        found->difference = relative;
        found->stated_error = kept.stated_error;
    }
    found->agrees = found->agrees && agrees;
}

void compare(const std::string& file, const std::string& kept, const std::string& now,
             Reproduction& result) {
    const std::vector<KeptNumber> before = numbers_in(file, kept), after = numbers_in(file, now);
    result.n_numbers += static_cast<std::size_t>(std::ranges::count_if(
        before, [](const KeptNumber& number) { return number.value.has_value(); }));
    if (kept == now) return;
    const auto [a, b] =
        std::ranges::mismatch(before, after, {}, &KeptNumber::place, &KeptNumber::place);
    if (a != before.end() || b != after.end()) {
        result.otherwise.push_back(
            a == before.end() ? fmt::format("{}: {}: was not kept", file, b->place)
                              : fmt::format("{}: {}: was kept, now there is {}", file, a->place,
                                            b == after.end() ? "nothing" : b->place));
        return;
    }
    for (std::size_t i = 0; i < before.size(); ++i) compare(file, before[i], after[i], result);
}

std::string line_of(const ChangedQuantity& one) {
    std::string line = fmt::format(
        "{} {}: {}: {:.2e} relative ({:.10g} was kept, now {:.10g}; {} value{} differ{})",
        one.agrees ? "agrees" : "differs", one.file, one.place, one.difference, one.kept, one.now,
        one.n, one.n == 1 ? "" : "s", one.n == 1 ? "s" : "");
    if (one.stated_error && *one.stated_error > 0)
        line += fmt::format(", {:.2g} of its stated error",
                            std::abs(one.now - one.kept) / *one.stated_error);
    return line + '\n';
}

}  // namespace

bool Reproduction::reproduces() const {
    return otherwise.empty() &&
           std::ranges::all_of(changed, [](const ChangedQuantity& one) { return one.agrees; });
}

Reproduction compare_with_kept(const NumberFiles& kept, const NumberFiles& now, double tolerance) {
    Reproduction result{.tolerance = tolerance, .n_files = kept.size()};
    for (const auto& [file, text] : kept) {
        const auto found = now.find(file);
        if (found == now.end())
            result.otherwise.push_back(file + ": was kept, now there is none");
        else
            compare(file, text, found->second, result);
    }
    for (const auto& [file, text] : now)
        if (!kept.contains(file)) result.otherwise.push_back(file + ": was not kept");
    return result;
}

std::string reproduction_text(const Reproduction& r) {
    if (r.same_bytes())
        return fmt::format("same bytes: {} numbers in {} files\n", r.n_numbers, r.n_files);
    std::string text;
    std::vector<ChangedQuantity> changed = r.changed;
    std::ranges::stable_sort(changed, [](const ChangedQuantity& a, const ChangedQuantity& b) {
        return a.agrees != b.agrees ? b.agrees : a.difference > b.difference;
    });
    for (std::size_t i = 0; i < std::min(changed.size(), most_told); ++i)
        text += line_of(changed[i]);
    for (std::size_t i = 0; i < std::min(r.otherwise.size(), most_told); ++i)
        text += "differs " + r.otherwise[i] + '\n';
    for (const std::size_t n : {r.otherwise.size(), changed.size()})
        if (n > most_told) text += fmt::format("and {} more\n", n - most_told);
    return text + fmt::format("{} numbers in {} files: {}, tolerance {:g} relative\n", r.n_numbers,
                              r.n_files, r.reproduces() ? "reproduced" : "not reproduced",
                              r.tolerance);
}

nlohmann::ordered_json reproduction_json(const Reproduction& r) {
    using json = nlohmann::ordered_json;
    json changed = json::array();
    for (const ChangedQuantity& one : r.changed)
        changed.push_back(
            {{"file", one.file},
             {"quantity", one.quantity},
             {"place", one.place},
             {"kept", one.kept},
             {"now", one.now},
             {"relative_difference", std::isfinite(one.difference) ? json(one.difference) : json()},
             {"stated_error", one.stated_error ? json(*one.stated_error) : json()},
             {"values", one.n},
             {"agrees", one.agrees}});
    return {{"reproduces", r.reproduces()}, {"same_bytes", r.same_bytes()},
            {"tolerance", r.tolerance},     {"files", r.n_files},
            {"numbers", r.n_numbers},       {"changed", changed},
            {"otherwise", r.otherwise}};
}

}  // namespace tricontact::comparisons

#include "comparisons/resolution/verification.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "report/json_number.h"

namespace tricontact::comparisons {

namespace {

using json = nlohmann::ordered_json;

constexpr double rounding = 1e-9;

std::string order_text(const VerificationRow& row) {
    const std::string found = row.order() ? fmt::format("{:.1f}", *row.order()) : "–";
    return row.least_order > 0 ? fmt::format("{} (≥ {:.1f})", found, row.least_order) : found;
}

json row_json(const VerificationRow& row) {
    return {{"problem", row.problem},
            {"quantity", row.quantity},
            {"model", row.model},
            {"source", row.source},
            {"reference", row.reference},
            {"sizes_over_contact_radius", row.sizes},
            {"values", row.values},
            {"relative_error", report::number(row.error(row.values.size() - 1))},
            {"tolerance", row.tolerance},
            {"observed_order", report::number(row.order())},
            {"least_order", row.least_order > 0 ? json(row.least_order) : json()},
            {"passed", row.passed()}};
}

}  // namespace

std::optional<double> VerificationRow::order() const {
    if (sizes.size() < 2) return {};
    const double coarse = error(0), fine = error(values.size() - 1);
    if (std::min(coarse, fine) <= rounding) return {};
    return std::log(coarse / fine) / std::log(sizes.front() / sizes.back());
}

std::string verification_markdown(const Verification& verification) {
    std::string text = R"(# Verification

Written by `tricontact verify`: each quantity on three levels of resolution, the size of a
cell or the distance of springs halved twice (of creep the step in time, too; of the walking
machine the step in time alone), beside what it should be. Error: of the finest level,
relative. Order: slope of the errors from the coarsest level to the finest, where one is asked
for with the least that passes; the edge of the contact between two cells makes it scatter,
and so do events between two steps. Beside other programs, boundary elements have one level,
with the cells of theirs. A program without finite elements has no rows of `fem`. Sources
stand below.

| Problem | Quantity | Model | h/a, dt/tau | Reference | Error | Tolerance | Order | |
|---|---|---|---|---|---|---|---|---|
)";
    std::vector<std::string> sources;
    for (const VerificationRow& row : verification.rows) {
        auto known = std::ranges::find(sources, row.source);
        if (known == sources.end()) known = sources.insert(sources.end(), row.source);
        text +=
            fmt::format("| {} [{}] | {} | `{}` | {:.2g} | {:.6g} | {:.1e} | {:.1e} | {} | {} |\n",
                        row.problem, known - sources.begin() + 1, row.quantity, row.model,
                        row.sizes.back(), row.reference, row.error(row.values.size() - 1),
                        row.tolerance, order_text(row), row.passed() ? "pass" : "**FAIL**");
    }
    text += '\n';
    for (std::size_t i = 0; i < sources.size(); ++i)
        text += fmt::format("{}. {}\n", i + 1, sources[i]);
    return text;
}

json verification_json(const std::string& version, const Verification& verification) {
    return {{"version", version},
            {"passed", verification.passed()},
            {"rows", report::list_of(verification.rows, row_json)}};
}

}  // namespace tricontact::comparisons

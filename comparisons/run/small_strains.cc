#include "comparisons/run/small_strains.h"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "comparisons/quantities/quantities.h"
#include "contact/base/special_values.h"
#include "report/format.h"
#include "report/json_number.h"

namespace tricontact::comparisons {

namespace {

using json = nlohmann::ordered_json;

/// A quantity of both runs, SI.
struct Row {
    std::string key, label;
    const char *unit, *over;
    double linear, finite;
    /// Of small strains.
    double error() const { return linear / finite - 1; }
};

/// What rolling adds to the static shift.
std::optional<double> creep_of(const Results& r, const Quantity& rolled) {
    const auto end = r.number(rolled), start = r.number(quantities::static_shift);
    return end && start ? std::optional(*end - *start) : std::nullopt;
}

std::vector<Row> rows_of(const SmallStrains& study) {
    using namespace quantities;
    std::vector<Row> rows;
    const Results &linear = *study.linear, &finite = study.finite;
    const auto add = [&](const std::string& key, const std::string& label, const Quantity& like,
                         std::optional<double> l, std::optional<double> f) {
        if (l && f && *f != 0) rows.push_back({key, label, like.unit, like.over, *l, *f});
    };
    const auto add_quantity = [&](const Quantity& q) {
        add(ratio_key(q), label_of(q), q, linear.number(q), finite.number(q));
    };
    for (const Quantity* q : {&indentation, &contact_radius, &peak_pressure, &static_shift})
        add_quantity(*q);
    const bool settled = linear.number(settled_shift) && finite.number(settled_shift);
    const bool ratchet = linear.state() == contact::State::ratcheting &&
                         finite.state() == contact::State::ratcheting;
    if (ratchet) {
        add_quantity(shift_increment);
    } else if (linear.state() && finite.state()) {
        const Quantity& rolled = settled ? settled_shift : final_shift;
        add_quantity(rolled);
        add("creep", fmt::format("creep {} - U_stat", rolled.symbol), rolled,
            creep_of(linear, rolled), creep_of(finite, rolled));
    }
    add_quantity(limit_tangential_ratio);
    return rows;
}

/// "static shift U_stat 1.7 % too high".
std::string told(const Row& row) {
    return fmt::format("{} {}", row.label, report::apart(1 + row.error(), "too high", "too low"));
}

std::string sentence_of(const SmallStrains& study) {
    const std::string name = report::display_name(study.model);
    if (!study.linear)
        return fmt::format("What small strains would change in {} is not known: {}.", name,
                           study.why_none);
    constexpr double negligible = 5e-4;
    std::vector<std::string> wrong;
    double rest = 0;
    for (const Row& row : rows_of(study))
        if (std::abs(row.error()) >= negligible)
            wrong.push_back(told(row));
        else
            rest = std::max(rest, std::abs(row.error()));
    std::string text =
        wrong.empty()
            ? fmt::format("Small strains change nothing in {} by more than {}.", name,
                          report::percent(negligible))
            : fmt::format("Small strains ({} once more with a linear material) put the {}.", name,
                          fmt::join(wrong, ", the "));
    const auto stretch = study.finite.number(quantities::largest_stretch);
    const auto shear = study.finite.number(quantities::largest_shear);
    if (stretch && shear)
        text += fmt::format(" Inside, the largest stretch is {} and the largest shear {}.",
                            report::significant(stretch, 3), report::significant(shear, 2));
    if (study.linear->state() && study.linear->state() != study.finite.state())
        text += fmt::format(" The verdicts differ: {} at finite strains, {} at small ones{}.",
                            contact::name_of(*study.finite.state()),
                            contact::name_of(*study.linear->state()),
                            study.long_steps && study.finite.state() == contact::State::cyclic_slip
                                ? "; points that touch between two turning points slip more than "
                                  "in shorter steps, which may find that nothing slips"
                                : "");
    return text;
}

json study_json(const SmallStrains& study) {
    json rows = json::object();
    if (study.linear)
        for (const Row& row : rows_of(study))
            rows[row.key] = {
                {"linear", row.linear}, {"finite", row.finite}, {"error", row.error()}};
    return {{"model", study.model},
            {"quantities", study.linear ? rows : json()},
            {"why_none", study.linear ? json() : json(study.why_none)}};
}

}  // namespace

std::vector<std::string> small_strain_sentences(const std::vector<SmallStrains>& studies) {
    std::vector<std::string> sentences;
    for (const SmallStrains& study : studies) sentences.push_back(sentence_of(study));
    return sentences;
}

report::DocumentTable small_strain_table(const SmallStrains& study) {
    report::DocumentTable table{
        .id = "small_strains",
        .title = "Finite strains beside small ones",
        .note = fmt::format("{} twice, with the material of the case and with a linear one of the "
                            "same moduli, everything else being the same.",
                            report::display_name(study.model)),
        .columns = report::columns("quantity", "unit", "finite strains", "small strains")};
    table.columns.push_back({.heading = "error of small strains [%]", .change = true});
    for (const Row& row : rows_of(study)) {
        const report::Unit unit =
            *row.unit ? report::fitting_unit(row.finite, row.unit) : report::Unit{1, row.over};
        table.rows.push_back({row.label, unit.symbol, row.finite / unit.factor,
                              row.linear / unit.factor, 100 * row.error()});
    }
    return table;
}

json small_strains_json(const std::vector<SmallStrains>& studies) {
    return report::list_of(studies, study_json);
}

}  // namespace tricontact::comparisons

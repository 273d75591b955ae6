#include <fmt/format.h>

#include <algorithm>
#include <functional>

#include "comparisons/format.h"
#include "comparisons/layer.h"
#include "comparisons/model_assumptions.h"
#include "comparisons/reference.h"
#include "comparisons/report_tables.h"
#include "theory/oscillating_rolling.h"

namespace tricontact::comparisons {

namespace {

using contact::State;
using Value = std::optional<double>;
using Getter = std::function<Value(const ModelSummary&)>;

/// Builds rows over the same models, with the same columns of theory and differences.
class RowMaker {
  public:
    /// `theory`: name of the column of theory.
    RowMaker(const std::vector<ModelSummary>& summaries, std::string theory)
        : summaries_(summaries), theory_(std::move(theory)) {}

    std::vector<std::string> columns() const {
        std::vector<std::string> result;
        for (const ModelSummary& s : summaries_) result.push_back(display_name(s.model));
        result.push_back(theory_);
        for (std::size_t i = 0; i + 1 < summaries_.size(); ++i)
            result.push_back(display_name(summaries_[i].model) + " vs " +
                             display_name(summaries_.back().model));
        if (compares_with_theory()) result.push_back("vs " + theory_);
        return result;
    }

    /// A quantity with unit (base unit "" for ratios) and its differences in percent.
    Table::Row quantity_row(const std::string& label, const std::string& base, const Getter& get,
                            Value theory = {}) const {
        double largest = theory.value_or(0);
        for (const ModelSummary& s : summaries_)
            largest = std::max(largest, std::abs(get(s).value_or(0)));
        const Unit unit = base.empty() ? Unit{} : fitting_unit(largest, base);
        Table::Row row = plain_row(label, [&](const ModelSummary& s) {
            return significant(divided(get(s), unit.factor));
        });
        row.unit = unit.symbol;
        row.cells.push_back(significant(divided(theory, unit.factor)));
        const Value base_value = compares_with_theory() ? theory : get(summaries_.back());
        const std::size_t compared = compares_with_theory() ? 1 : summaries_.size() - 1;
        for (std::size_t i = 0; i < compared; ++i)
            row.cells.push_back(difference(get(summaries_[i]), base_value));
        return row;
    }

    /// A row that is not compared: text per model, theory's text.
    Table::Row text_row(const std::string& label, const std::string& unit,
                        const std::function<std::string(const ModelSummary&)>& text,
                        const std::string& theory = "") const {
        Table::Row row = plain_row(label, text);
        row.unit = unit;
        row.cells.push_back(theory);
        row.cells.resize(columns().size());
        return row;
    }

  private:
    bool compares_with_theory() const { return summaries_.size() == 1; }

    static Value divided(Value value, double factor) {
        return value ? Value(*value / factor) : Value();
    }

    static std::string difference(Value value, Value base) {
        return value && base && *base != 0 ? percent(*value / *base) : percent({});
    }

    Table::Row plain_row(const std::string& label,
                         const std::function<std::string(const ModelSummary&)>& text) const {
        Table::Row row{label, "", {}};
        for (const ModelSummary& s : summaries_) row.cells.push_back(text(s));
        return row;
    }

    const std::vector<ModelSummary>& summaries_;
    std::string theory_;
};

/// On a layer: which models know of it.
Table::Row body_row(const RowMaker& make) {
    return make.text_row(
        "elastic body", "",
        [](const auto& s) { return std::string(is_half_space(s.model) ? "half-space" : "layer"); },
        "half-space");
}

Table::Group pressed_group(const contact::Case& c, const RowMaker& make, const Reference& r) {
    // Scales of a nominally flat contact are no solution; a rough body has no static shift in
    // theory, nor has a substrate that still relaxes.
    const auto exact = [&](double value) { return r.is_nominal ? Value() : Value(value); };
    const auto shift = [&](double value) {
        return r.static_shift_ratio > 0 && static_shift_is_relaxed(c) ? Value(value) : Value();
    };
    return {"Pressed and loaded",
            {make.quantity_row(
                 size_name(c) + " <i>a</i>", "m", [](const auto& s) { return s.contact_radius; },
                 exact(r.hertz.contact_radius)),
             make.quantity_row(
                 "indentation <i>d</i>", "m", [](const auto& s) { return s.indentation; },
                 exact(r.hertz.indentation)),
             make.quantity_row(
                 "peak pressure <i>p</i><sub>0</sub>", "Pa",
                 [](const auto& s) { return s.peak_pressure; }, r.peak_pressure),
             make.quantity_row(
                 "unit of shift <i>U</i><sub>max</sub>", "m",
                 [](const auto& s) { return s.unit_shift; }, exact(r.hertz.unit_shift)),
             make.quantity_row(
                 "tangential force <i>f</i><sub>T</sub>", "",
                 [](const auto& s) { return s.tangential_ratio; }, r.tangential_ratio),
             make.quantity_row(
                 "static shift <i>u</i><sub>stat</sub>", "",
                 [](const auto& s) { return s.static_shift_ratio; }, shift(r.static_shift_ratio)),
             make.quantity_row(
                 "static shift <i>U</i><sub>stat</sub>", "m",
                 [](const auto& s) { return s.static_shift; },
                 shift(r.static_shift_ratio * r.hertz.unit_shift))}};
}

std::string expected_state(const Reference& r) {
    if (!r.limit_tangential_ratio) return "–";
    return contact::name_of(r.tangential_ratio <= *r.limit_tangential_ratio ? State::shakedown
                                                                            : State::ratcheting);
}

Table::Group rolling_group(const RowMaker& make, const Reference& r) {
    const Value u = r.shakedown_shift_ratio;
    return {
        "After rolling, indenter upright",
        {make.text_row(
             "verdict", "",
             [](const auto& s) { return std::string(s.state ? contact::name_of(*s.state) : "–"); },
             expected_state(r)),
         make.text_row("periods", "", [](const auto& s) { return std::to_string(s.periods); }),
         make.quantity_row(
             "amplitude <i>w</i> = <i>W</i>/<i>a</i>", "",
             [](const auto& s) { return s.amplitude_ratio; }, r.amplitude_ratio),
         make.quantity_row(
             "limit <i>f</i><sub>T,lim</sub>", "",
             [](const auto& s) { return s.limit_tangential_ratio; }, r.limit_tangential_ratio),
         make.quantity_row(
             "final shift <i>u</i>", "", [](const auto& s) { return s.final_shift_ratio; }, u),
         make.quantity_row(
             "final shift <i>U</i>", "m", [](const auto& s) { return s.final_shift; },
             u ? Value(*u * r.hertz.unit_shift) : Value()),
         make.text_row("last period's Δ<i>u</i>", "",
                       [](const auto& s) { return significant(s.shift_increment_ratio); }),
         make.quantity_row(
             "mapping parameter <i>κ</i>", "", [](const auto& s) { return s.kappa; },
             u && r.has_mapping ? Value(theory::mdr_mapping) : Value()),
         make.quantity_row("ratcheting slope <i>η</i>", "", [](const auto& s) { return s.eta; })}};
}

/// What the insides that were written tell; none without them.
std::optional<Table::Group> inside_group(const RowMaker& make,
                                         const std::vector<ModelSummary>& summaries) {
    const auto known = [](const ModelSummary& s) { return s.subsurface.has_value(); };
    if (std::none_of(summaries.begin(), summaries.end(), known)) return {};
    const auto place = [](std::size_t d) {
        return [d](const ModelSummary& s) {
            return s.subsurface ? Value(s.subsurface->peak_position[d] / s.contact_radius)
                                : Value();
        };
    };
    return Table::Group{
        "Inside the substrate",
        {make.quantity_row("largest von Mises stress", "Pa",
                           [](const auto& s) {
                               return s.subsurface ? Value(s.subsurface->peak_von_mises) : Value();
                           }),
         make.quantity_row("the same over <i>p</i><sub>0</sub>", "",
                           [](const auto& s) {
                               return s.subsurface
                                          ? Value(s.subsurface->peak_von_mises / s.peak_pressure)
                                          : Value();
                           }),
         make.quantity_row("its place <i>x</i>/<i>a</i>", "", place(0)),
         make.quantity_row("its place <i>z</i>/<i>a</i>", "", place(2))}};
}

/// What the ends of a roller do to the contact's outline; none of other bodies.
std::optional<Table::Group> ends_group(const RowMaker& make,
                                       const std::vector<ModelSummary>& summaries) {
    const auto known = [](const ModelSummary& s) { return s.ends.has_value(); };
    if (std::none_of(summaries.begin(), summaries.end(), known)) return {};
    const auto of_ends = [](double RollerEnds::*member) {
        return
            [member](const ModelSummary& s) { return s.ends ? Value((*s.ends).*member) : Value(); };
    };
    return Table::Group{
        "Ends of the roller",
        {make.quantity_row("half width at half length", "m",
                           of_ends(&RollerEnds::middle_half_width)),
         make.quantity_row("largest half width over it", "", of_ends(&RollerEnds::widest_ratio)),
         make.quantity_row("wider than at half length up to, from the end", "m",
                           of_ends(&RollerEnds::knuckle)),
         make.quantity_row("of another width up to", "m", of_ends(&RollerEnds::reach))}};
}

Table::Group cost_group(const RowMaker& make, bool rolling) {
    Table::Group group{"Work and cost", {}};
    const auto work = [](bool last) {
        return [last](const ModelSummary& s) {
            const auto& values = s.dissipation_ratio_per_period;
            if (values.empty()) return significant({});
            return significant(last ? values.back() : values.front(), 3);
        };
    };
    if (rolling) {
        group.rows.push_back(
            make.text_row("frictional work, first period", "<i>W</i><sub>0</sub>", work(false)));
        group.rows.push_back(
            make.text_row("frictional work, last period", "<i>W</i><sub>0</sub>", work(true)));
    }
    group.rows.push_back(
        make.text_row("steps", "", [](const auto& s) { return std::to_string(s.steps); }));
    group.rows.push_back(
        make.text_row("CPU time", "s", [](const auto& s) { return significant(s.cpu_s, 3); }));
    group.rows.push_back(make.text_row("CPU time per step", "ms", [](const auto& s) {
        return s.steps > 0 ? significant(1e3 * s.cpu_s / s.steps, 3) : significant({});
    }));
    group.rows.push_back(make.text_row("worst force balance", "", [](const auto& s) {
        return significant(s.max_force_residual_ratio, 2);
    }));
    return group;
}

}  // namespace

Table results_table(const contact::Case& c, const std::vector<ModelSummary>& summaries) {
    const Reference r = reference(c);
    const RowMaker make(summaries, c.layer.thickness ? "half-space theory" : "theory");
    Table table{"Results of the models and of theory", make.columns(), {pressed_group(c, make, r)}};
    if (c.layer.thickness) {
        auto& rows = table.groups.front().rows;
        rows.insert(rows.begin(), body_row(make));
    }
    if (c.rolling) table.groups.push_back(rolling_group(make, r));
    if (const auto ends = ends_group(make, summaries)) table.groups.push_back(*ends);
    if (const auto inside = inside_group(make, summaries)) table.groups.push_back(*inside);
    table.groups.push_back(cost_group(make, c.rolling.has_value()));
    return table;
}

}  // namespace tricontact::comparisons

#include <algorithm>

#include "comparisons/half_space/layer.h"
#include "comparisons/quantities/model_assumptions.h"
#include "comparisons/run/report_tables.h"
#include "report/format.h"

namespace tricontact::comparisons {

namespace {

using Value = std::optional<double>;

/// Rows over the same models, with the same columns of theory and differences.
class RowMaker {
  public:
    RowMaker(const contact::Case& c, const std::vector<Results>& results)
        : case_(c),
          results_(results),
          reference_(reference(c)),
          theory_(c.layer.thickness ? "half-space theory" : "theory") {}

    std::vector<std::string> columns() const {
        std::vector<std::string> result;
        for (const Results& r : results_) result.push_back(report::display_name(r.model));
        result.push_back(theory_);
        for (std::size_t i = 0; i + 1 < results_.size(); ++i)
            result.push_back(result[i] + " vs " + report::display_name(results_.back().model));
        if (compares_with_theory()) result.push_back("vs " + theory_);
        return result;
    }

    /// The quantities of a part; a part that is none of this case's has no rows.
    Table::Group group(const std::string& title, Part part) const {
        Table::Group group{title, {}};
        const bool always = part != Part::ends && part != Part::inside;
        for (const Quantity* q : all_quantities())
            if (q->part == part && (always || is_known(*q))) group.rows.push_back(row(*q));
        return group;
    }

    /// On a layer: which models know of it.
    Table::Row body_row() const {
        Table::Row row{"elastic body", "", {}};
        for (const Results& r : results_)
            row.cells.emplace_back(is_half_space(r.model) ? "half-space" : "layer");
        row.cells.emplace_back("half-space");
        row.cells.resize(columns().size());
        return row;
    }

  private:
    bool compares_with_theory() const { return results_.size() == 1; }

    bool is_known(const Quantity& q) const {
        return std::ranges::any_of(results_,
                                   [&](const Results& r) { return r.number(q).has_value(); });
    }

    std::string label(const Quantity& q) const {
        const bool is_size = &q == &quantities::contact_radius;
        const std::string symbol = q.symbol;
        return report::typeset(is_size ? size_name(case_) : q.name) + (symbol.empty() ? "" : " ") +
               (symbol.size() == 1 ? "<i>" + symbol + "</i>" : report::typeset(symbol));
    }

    /// Numbers of one model beside another in a fitting unit, with differences in percent; words
    /// and counts as they are.
    Table::Row row(const Quantity& q) const {
        const QuantityValue exact = q.exact ? q.exact(case_, reference_) : QuantityValue();
        const Value theory = number_of(exact);
        double largest = theory.value_or(0);
        for (const Results& r : results_)
            largest = std::max(largest, std::abs(r.number(q).value_or(0)));
        const std::string base = q.unit;
        const report::Unit unit = base.empty() ? report::Unit{.symbol = report::typeset(q.over)}
                                               : report::fitting_unit(largest, base);
        Table::Row row{label(q), unit.symbol, {}};
        for (const Results& r : results_) row.cells.push_back(text(r[q], unit.factor, q.digits));
        row.cells.push_back(q.exact ? text(exact, unit.factor, q.digits) : "");
        const bool has_numbers = std::ranges::any_of(
            results_, [&](const Results& r) { return number_of(r[q]).has_value(); });
        const Value other = compares_with_theory() ? theory : results_.back().told(q);
        const std::size_t compared = compares_with_theory() ? 1 : results_.size() - 1;
        for (std::size_t i = 0; has_numbers && q.part != Part::cost && i < compared; ++i)
            row.cells.push_back(difference(results_[i].told(q), other));
        row.cells.resize(columns().size());
        return row;
    }

    static std::string text(const QuantityValue& value, double factor, int digits) {
        if (const auto* number = std::get_if<double>(&value))
            return report::significant(*number / factor, digits);
        if (const auto* count = std::get_if<int>(&value)) return std::to_string(*count);
        if (const auto* state = std::get_if<contact::State>(&value))
            return contact::name_of(*state);
        return report::significant({});
    }

    static std::string difference(Value value, Value base) {
        return value && base && *base != 0 ? report::percent(*value / *base) : report::percent({});
    }

    const contact::Case& case_;
    const std::vector<Results>& results_;
    Reference reference_;
    std::string theory_;
};

}  // namespace

Table results_table(const contact::Case& c, const std::vector<Results>& results) {
    const RowMaker make(c, results);
    Table table{"Results of the models and of theory", make.columns(), {}};
    table.groups.push_back(make.group("Pressed and loaded", Part::pressed));
    if (c.layer.thickness) {
        auto& rows = table.groups.front().rows;
        rows.insert(rows.begin(), make.body_row());
    }
    if (c.rolling)
        table.groups.push_back(make.group("After rolling, indenter upright", Part::rolled));
    table.groups.push_back(make.group("Ends of the roller", Part::ends));
    table.groups.push_back(make.group("Inside the substrate", Part::inside));
    table.groups.push_back(make.group("Work and cost", Part::cost));
    std::erase_if(table.groups, [](const Table::Group& group) { return group.rows.empty(); });
    return table;
}

}  // namespace tricontact::comparisons

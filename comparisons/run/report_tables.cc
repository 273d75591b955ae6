#include "comparisons/run/report_tables.h"

#include <algorithm>

#include "comparisons/quantities/change_table.h"
#include "comparisons/quantities/reference.h"
#include "contact/section_scales.h"
#include "report/format.h"

namespace tricontact::comparisons {

namespace {

using report::Cell;
using report::DocumentTable;
using Value = std::optional<double>;

constexpr int most_open_periods = 12;  // longer tables start folded

std::string results_note(const contact::Case& c, bool several_models,
                         const std::optional<NumericalError>& error) {
    std::string text = "Ratios u are over each model's own U_max. ";
    if (contact::is_section_alone(c))
        text += "The theory column is empty: half-spaces do not know this contact.";
    else if (c.adhesion)
        text +=
            "The theory column is the contact of surfaces that attract each other on the "
            "half-space (Johnson, Kendall and Roberts, or Maugis), where there is a solution, and "
            "under a shear strength what springs carry over its radius.";
    else if (c.interface.is_elastic())
        text +=
            "The theory column is frictionless contact on the half-space without the springs of "
            "the interface (pressed); under friction no closed form has them.";
    else if (c.has_bulk_stress())
        text +=
            "The theory column is frictionless contact on the half-space (pressed); closed forms "
            "of the shift have no bulk stress.";
    else if (!c.friction.is_coulomb())
        text +=
            "The theory column is frictionless contact on the half-space (pressed) and, where the "
            "body is one of revolution, what springs carry under this law of friction (static "
            "shift, after rolling); the limit f_T,lim is what the least bounds over the path "
            "carry, exact for uncoupled contact.";
    else if (contact::is_hertz_round(c))
        text +=
            "The theory column is Hertz (pressed), Cattaneo and Mindlin (static shift) and, after "
            "rolling, the closed form of the method of dimensionality reduction (MDR); its limit "
            "f_T,lim = 1 − 3/2 w + 1/2 w^3 is exact for every uncoupled contact under Hertz' "
            "pressure.";
    else if (c.is_cylindrical())
        text +=
            "The theory column is the line contact of the half-space, without coupling: Hertz "
            "(pressed), Cattaneo (static shift) and, after rolling, the exact solution of "
            "docs/explanation/cylinder.md with the limit f_T,lim = (2/π) [arccos w − w (1 − "
            "w^2)^(1/2)].";
    else
        text +=
            "The theory column is frictionless contact on the half-space (pressed), the "
            "superposition of two normal contacts (static shift) and, after rolling, the method "
            "of dimensionality reduction (MDR) where it holds; the limit f_T,lim is what the "
            "least pressures over the path carry, exact for uncoupled contact.";
    if (error && error->why_none.empty())
        text += " ±: what mesh and steps leave in the numbers of " +
                report::display_name(error->model) +
                "; without it a number is prescribed, or its "
                "error is not known.";
    if (several_models) text += " Last columns: by how much a model differs from the last model.";
    return text;
}

std::string rolling_note(const contact::Case& c) {
    const bool round = contact::is_coulomb_round(c);
    std::string text;
    if (round)
        text +=
            "Mapping parameter κ: from f_T = 1 − κ w u − (1 − u)^(3/2) with the settled shift u; "
            "3/2 for MDR, about 1 along and 1.1 across the load for three-dimensional contact "
            "(Wetter); only after shakedown. ";
    text += "Ratcheting slope η: Δu/(w − w_lim) with the last period's Δu and ";
    text += round ? "1 − 3/2 w_lim + 1/2 w_lim^3 = f_T" : "the half-space's limit w_lim at f_T";
    text += "; only while ratcheting.";
    if (c.is_cylindrical() && c.friction.is_coulomb() && !c.interface.is_elastic())
        text +=
            " W_0: frictional work of one cycle of a tangential force oscillating between ±f_T "
            "μF_N in line contact, μ^2 2 F_N^2/(πE*L) [f (2 − f) + 2 (1 − f) ln(1 − f)].";
    if (round)
        text +=
            " W_0: frictional work of one cycle of a tangential force oscillating between ±f_T "
            "μF_N, after Mindlin and Deresiewicz, with each model's own F_N and a.";
    return text;
}

/// Columns in which no row has anything to say.
void drop_empty_columns(DocumentTable& table) {
    const auto is_empty = [](const Cell& cell) {
        const auto* words = std::get_if<std::string>(&cell);
        return words && words->empty();
    };
    for (std::size_t i = table.columns.size(); i-- > 0;) {
        if (!std::ranges::all_of(table.rows, [&](const auto& row) { return is_empty(row[i]); }))
            continue;
        table.columns.erase(table.columns.begin() + static_cast<std::ptrdiff_t>(i));
        for (auto& row : table.rows) row.erase(row.begin() + static_cast<std::ptrdiff_t>(i));
    }
}

/// Rows over the same models, with the same columns of theory and differences.
class RowMaker {
  public:
    RowMaker(const contact::Case& c, const std::vector<Results>& results,
             const std::optional<NumericalError>& error)
        : case_(c),
          results_(results),
          error_(error),
          reference_(reference(c)),
          theory_(c.layer.thickness ? "half-space theory" : "theory") {}

    /// The quantities of a part.
    DocumentTable table(const std::string& id, const std::string& title, Part part,
                        const std::string& note = "") const {
        DocumentTable table{.id = id, .title = title, .note = note, .columns = columns()};
        // Counts and times are not known to four digits.
        if (part == Part::cost)
            for (auto& column : table.columns) column.digits = 3;
        if (part == Part::pressed && case_.layer.thickness) table.rows.push_back(body_row());
        const bool always = !case_.prescribed_path && part != Part::ends && part != Part::inside;
        for (const Quantity* q : all_quantities())
            if (q->part == part && (always || is_known(*q)) && !is_rounding(*q))
                table.rows.push_back(row(*q));
        drop_empty_columns(table);
        return table;
    }

  private:
    bool compares_with_theory() const { return results_.size() == 1; }
    std::size_t n_compared() const { return compares_with_theory() ? 1 : results_.size() - 1; }

    std::vector<DocumentTable::Column> columns() const {
        std::vector<DocumentTable::Column> result = quantity_columns();
        for (const Results& r : results_) result.push_back({report::display_name(r.model)});
        result.push_back({theory_});
        for (std::size_t i = 0; i < n_compared(); ++i)
            result.push_back(change_column(
                report::display_name(results_[i].model),
                compares_with_theory() ? theory_ : report::display_name(results_.back().model)));
        return result;
    }

    bool is_known(const Quantity& q) const {
        return std::ranges::any_of(results_, [&](const Results& r) {
            return r.number(q) || std::holds_alternative<SlipRegime>(r[q]);
        });
    }

    /// What no tangential load leaves of it.
    bool is_rounding(const Quantity& q) const {
        const auto of_pull = {&quantities::tangential_ratio, &quantities::static_shift,
                              &quantities::static_shift_ratio};
        return std::ranges::find(of_pull, &q) != of_pull.end() &&
               std::ranges::all_of(results_, is_pressed_alone);
    }

    /// On a layer: which models know of it.
    std::vector<Cell> body_row() const {
        std::vector<Cell> row{"elastic body", ""};
        for (const Results& r : results_)
            row.emplace_back(is_half_space(r.model) ? "half-space" : "layer");
        row.emplace_back("half-space");
        row.resize(row.size() + n_compared(), "");
        return row;
    }

    /// What a ratio is over.
    std::string over_text(const Quantity& q) const {
        const std::string over = q.over;
        return over == "mu F_N" && !case_.friction.is_coulomb() ? "F_lim" : over;
    }

    /// Numbers of one model beside another in a fitting unit, with differences in percent; words
    /// and counts as they are.
    std::vector<Cell> row(const Quantity& q) const {
        const QuantityValue exact = q.exact ? q.exact(reference_) : QuantityValue();
        const Value theory = number_of(exact);
        double largest = theory.value_or(0);
        for (const Results& r : results_)
            largest = std::max(largest, std::abs(r.number(q).value_or(0)));
        const std::string base = q.unit, symbol = q.symbol;
        const report::Unit unit = base.empty() ? report::Unit{.symbol = over_text(q)}
                                               : report::fitting_unit(largest, base);
        const bool is_size = &q == &quantities::contact_radius;
        std::vector<Cell> row{
            (is_size ? size_name(case_) : q.name) + (symbol.empty() ? "" : " ") + symbol,
            unit.symbol};
        for (const Results& r : results_) row.push_back(cell(r[q], unit.factor));
        if (const auto width = half_width(q)) {
            Cell& last = row.back();
            last = report::WithError{std::get<double>(last), *width / unit.factor};
        }
        row.push_back(q.exact ? cell(exact, unit.factor) : "");
        const bool has_numbers = std::ranges::any_of(
            results_, [&](const Results& r) { return number_of(r[q]).has_value(); });
        const Value other = compares_with_theory() ? theory : results_.back().told(q);
        for (std::size_t i = 0; i < n_compared(); ++i)
            row.push_back(has_numbers && q.part != Part::cost && !q.is_place
                              ? change_cell(results_[i].told(q), other)
                              : Cell(""));
        return row;
    }

    /// Of the last model, whose error is told; none of what the case prescribes.
    Value half_width(const Quantity& q) const {
        const auto& known = quantities_with_error();
        const bool is_told = error_ && error_->model == results_.back().model &&
                             std::ranges::find(known, &q) != known.end() &&
                             number_of(results_.back()[q]).has_value();
        const Value width = is_told ? error_->of(q) : Value();
        return width && *width > 0 ? width : Value();
    }

    static Cell cell(const QuantityValue& value, double factor) {
        if (const auto* number = std::get_if<double>(&value)) return *number / factor;
        if (const auto* count = std::get_if<int>(&value)) return *count;
        if (const auto* state = std::get_if<contact::State>(&value))
            return contact::name_of(*state);
        if (const auto* regime = std::get_if<SlipRegime>(&value)) return name_of(*regime);
        return report::number_cell({});
    }

    const contact::Case& case_;
    const std::vector<Results>& results_;
    const std::optional<NumericalError>& error_;
    Reference reference_;
    std::string theory_;
};

}  // namespace

std::vector<DocumentTable> results_tables(const contact::Case& c,
                                          const std::vector<Results>& results,
                                          const std::optional<NumericalError>& error) {
    const RowMaker make(c, results, error);
    std::vector<DocumentTable> tables{make.table("pressed", "Pressed and loaded", Part::pressed,
                                                 results_note(c, results.size() > 1, error))};
    if (c.rolling)
        tables.push_back(
            make.table("rolled", "After rolling, indenter upright", Part::rolled, rolling_note(c)));
    tables.push_back(make.table("ends", "Ends of the roller", Part::ends));
    tables.push_back(make.table("inside", "Inside the substrate", Part::inside));
    tables.push_back(make.table("end_of_run", "At the end of the run", Part::end_of_run));
    tables.push_back(make.table("cost", "Work and cost", Part::cost));
    std::erase_if(tables, [](const DocumentTable& table) { return table.rows.empty(); });
    return tables;
}

DocumentTable period_table(const std::vector<Results>& results) {
    DocumentTable table{.id = "periods",
                        .title = "Shift and frictional work after each period",
                        .columns = {{"period n"}}};
    std::size_t periods = 0;
    for (const Results& s : results) {
        const std::string name = report::display_name(s.model);
        table.columns.push_back({name + " u"});
        table.columns.push_back({name + " Δu", 3});
        table.columns.push_back({name + " W/W₀", 3});
        periods = std::max(periods, s.list(quantities::shift_ratio_per_period).size());
    }
    table.folded = periods > most_open_periods;
    for (std::size_t n = 0; n <= periods; ++n) {
        std::vector<Cell> row{static_cast<int>(n)};
        for (const Results& s : results) {
            const Numbers& u = s.list(quantities::shift_ratio_per_period);
            const Numbers& work = s.list(quantities::dissipation_ratio_per_period);
            const Value u_stat = s.number(quantities::static_shift_ratio);
            const bool ran = n > 0 && n <= u.size();
            const Value before = n > 1 && ran ? u[n - 2] : u_stat;
            row.push_back(report::number_cell(ran ? u[n - 1] : n == 0 ? u_stat : Value()));
            row.push_back(report::number_cell(ran ? Value(u[n - 1].value_or(0) - before.value_or(0))
                                                  : Value()));
            row.push_back(report::number_cell(ran && n <= work.size() ? work[n - 1] : Value()));
        }
        table.rows.push_back(row);
    }
    return table;
}

DocumentTable audit_table(const std::vector<Results>& results) {
    DocumentTable table{
        .id = "audit",
        .title = "Checks of all solutions",
        .columns = {{"model"}, {"check"}, {"worst", 2}, {"allowed", 2}, {"verdict"}}};
    for (const Results& s : results)
        for (const auto& check : s.audit) {
            std::string name = check.name;
            std::ranges::replace(name, '_', ' ');
            table.rows.push_back({report::display_name(s.model), name, check.worst, check.allowed,
                                  check.passed() ? "pass" : "fail"});
        }
    return table;
}

}  // namespace tricontact::comparisons

#include "comparisons/resolution/error_note.h"

#include <fmt/format.h>

#include "report/format.h"

namespace tricontact::comparisons {

std::string value_text(double value, const char* base, std::optional<double> error) {
    if (!error || *error == 0) return report::quantity(value, base);
    const report::Unit unit = report::fitting_unit(value, base);
    return report::with_error(value / unit.factor, *error / unit.factor) + ' ' + unit.symbol;
}

std::optional<double> refined_width(const std::optional<Refinement>& refinement,
                                    const Quantity& q) {
    if (refinement)
        for (const RefinedQuantity& refined : refinement->quantities)
            if (refined.quantity == &q) return refined.limit.error;
    return {};
}

std::string refinement_note(const Refinement& refinement, const Quantity& q) {
    return refined_width(refinement, q)
               ? " ± is the error of the finest mesh, estimated from all levels."
               : " Its error of the mesh stands in the section on the refinement.";
}

std::string error_note(const std::optional<NumericalError>& error, const Quantity& q) {
    if (!error) return " Its numerical error was not asked for (--no-studies).";
    if (error->is_exact(q)) return fmt::format(" The {} is exact: the case prescribes it.", q.name);
    if (error->of(q) && !error->why_no_steps.empty())
        return " ± is the error of the mesh, estimated with coarser ones; that of the steps is not "
               "known: " +
               error->why_no_steps + ".";
    if (error->of(q))
        return fmt::format(" ± is the error of mesh{} and steps, estimated with coarser ones.",
                           error->wide_block ? ", width of the block" : "");
    return error->why_none.empty()
               ? " The error of mesh and steps is not known: coarser ones give no such number."
               : " The error of mesh and steps is not known: " + error->why_none + ".";
}

std::string field_note(const std::optional<NumericalError>& error, const std::string& model,
                       const std::string& field, double unit, const std::string& unit_name) {
    if (!error || error->model != model || !(unit > 0)) return {};
    for (const FieldBar& bar : error->fields)
        if (bar.field == field)
            return fmt::format(
                " What mesh and steps leave in {}: ± {} of the field's root mean square, ± {} {} "
                "at "
                "the worst point, mostly on the edge of a zone.",
                report::display_name(model), report::share(bar.l2),
                report::significant(bar.largest / unit, 2), unit_name);
    return {};
}

}  // namespace tricontact::comparisons

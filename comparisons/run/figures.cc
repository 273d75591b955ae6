#include "comparisons/run/figures.h"

#include "comparisons/adhesion/force_curve.h"
#include "comparisons/quantities/resample.h"
#include "comparisons/quantities/surface_fields.h"
#include "comparisons/resolution/error_note.h"
#include "report/format.h"
#include "report/plot_style.h"

namespace tricontact::comparisons {

std::vector<report::Kind> zone_kinds() {
    return {{"stick", 0.83, report::stick_colour},
            {"slip", 0.4, report::slip_colour},
            {"zero", 0.14},
            {"released", 0.14}};
}

report::Curve curve_of(const contact::History& history) {
    return {.name = report::display_name(history.model),
            .colour = report::model_style(history.model)};
}

namespace {

/// Half widths belong to the last state: figures of the last upright one have them where that is
/// the last.
void add_field_notes(const contact::Case& c, const Histories& histories,
                     const std::optional<NumericalError>& error, Figures& figures) {
    for (const contact::History& history : histories) {
        const contact::Snapshot* drawn = last_upright(history);
        if (!drawn || drawn->phase != history.snapshots.back().phase) continue;
        const double bound = c.friction.law()->bound(drawn_pressure(c, history.scales));
        const std::string traction = field_note(error, history.model, "tangential_traction", bound,
                                                drawn_bound_symbol(c)),
                          displacement = field_note(error, history.model, "displacement",
                                                    history.scales.unit_shift, "U_max");
        for (report::Figure& figure : figures) {
            const auto is = [&](const std::string& id) { return figure.id == id; };
            if (is("traction_x") || is("traction_y") || is("traction_surface_" + history.model))
                figure.caption += traction;
            if (is("displacement_surface_" + history.model)) figure.caption += displacement;
        }
    }
}

}  // namespace

Figures make_figures(const contact::Case& c, const Histories& histories,
                     const std::optional<NumericalError>& error) {
    Figures figures;
    const auto add = [&](const auto& maker, const Histories& of) {
        for (report::Figure& figure : maker(c, of)) figures.push_back(std::move(figure));
    };
    add(force_curve_figures, histories);
    if (!c.adhesion || !c.is_pressed_only())
        for (report::Figure& figure : shift_figures(c, histories, error))
            figures.push_back(std::move(figure));
    add(dissipation_figures, histories);
    const Histories on_grid = on_grids(histories);
    if (!c.adhesion) add(traction_figures, on_grid);  // over mu p, which tension has not
    if (c.is_line_contact()) {                        // nothing varies along y
        add(line_contact_figures, on_grid);
    } else {
        add(zone_figures, on_grid);
        add(surface_figures, on_grid);
    }
    add(end_figures, histories);
    add(rough_figures, histories);
    add(subsurface_figures, histories);
    add_field_notes(c, histories, error, figures);
    return figures;
}

}  // namespace tricontact::comparisons

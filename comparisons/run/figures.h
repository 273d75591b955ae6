#pragma once

#include <optional>
#include <vector>

#include "comparisons/resolution/numerical_error.h"
#include "contact/case.h"
#include "contact/history.h"
#include "report/figure.h"

namespace tricontact::comparisons {

using Histories = std::vector<contact::History>;
using Figures = std::vector<report::Figure>;

/// U(n) of all models in metres and over U_max, with the closed forms where they hold; in metres
/// with the band that mesh and steps leave.
Figures shift_figures(const contact::Case& c, const Histories& histories,
                      const std::optional<NumericalError>& error = {});
/// Frictional work per period over W0, logarithmic; none when no period dissipates.
Figures dissipation_figures(const contact::Case& c, const Histories& histories);
/// Traction on the centre lines along x and y with its bound and zones; none without tractions.
Figures traction_figures(const contact::Case& c, const Histories& histories);
/// Pressure at the turning points and displacement of the surface of a line contact.
Figures line_contact_figures(const contact::Case& c, const Histories& histories);
/// Pressure and half width of the contact towards the ends of a roller, on the model's own points;
/// none for other bodies.
Figures end_figures(const contact::Case& c, const Histories& histories);
/// Stick, slip and open points at chosen instants, a row of maps per model on a grid (see
/// resample.h for others).
Figures zone_figures(const contact::Case& c, const Histories& histories);
/// tau_x and u_x over the contact plane, per model on a grid.
Figures surface_figures(const contact::Case& c, const Histories& histories);
/// Von Mises' stress in the section below the contact, a map per model, and down the axis for all;
/// none where no inside was written.
Figures subsurface_figures(const contact::Case& c, const Histories& histories);
/// Of a rough case: power spectral density, measured beside prescribed; of a nominally flat one
/// contact area over load, with what theories say.
Figures rough_figures(const contact::Case& c, const Histories& histories);

/// All of the above, in the report's order; what needs grids is resampled (see resample.h).
/// Captions of tractions and displacements tell the half widths of their fields, where `error` has
/// them of the state that is drawn.
Figures make_figures(const contact::Case& c, const Histories& histories,
                     const std::optional<NumericalError>& error = {});

/// What surface points are called and how they are drawn, dark to light as in the thesis' figures:
/// stick, slip, zero, released.
std::vector<report::Kind> zone_kinds();
/// An empty curve with the name and colour of the model.
report::Curve curve_of(const contact::History& history);

}  // namespace tricontact::comparisons

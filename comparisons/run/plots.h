#pragma once

#include <string>
#include <vector>

#include "contact/case.h"
#include "contact/history.h"
#include "report/gnuplot.h"

namespace tricontact::comparisons {

/// A figure of the report.
struct Plot {
    std::string name;     ///< of its files, without extension
    std::string title;    ///< plain text
    std::string caption;  ///< plain text: what is drawn and how to read it
    report::Picture picture;
    report::ImageFormat embedded =
        report::ImageFormat::svg;  ///< what the report shows; both are files
};

using Histories = std::vector<contact::History>;

/// u(n) of all models, with the closed forms where they hold.
std::vector<Plot> shift_plots(const contact::Case& c, const Histories& histories);
/// Frictional work per period over W0, logarithmic; none when no period dissipates.
std::vector<Plot> dissipation_plots(const contact::Case& c, const Histories& histories);
/// Traction on the centre lines along x and y with its bound and zones; none without tractions.
std::vector<Plot> traction_plots(const contact::Case& c, const Histories& histories);
/// Pressure at the turning points and displacement of the surface of a line contact.
std::vector<Plot> line_contact_plots(const contact::Case& c, const Histories& histories);
/// Pressure and half width of the contact towards the ends of a roller, on the model's own points;
/// none for other bodies.
std::vector<Plot> end_plots(const contact::Case& c, const Histories& histories);
/// Stick, slip and open points at chosen instants, a row of maps per model on a grid (see
/// resample.h for others).
std::vector<Plot> zone_maps(const contact::Case& c, const Histories& histories);
/// tau_x and u_x over the contact plane, per model on a grid.
std::vector<Plot> surface_plots(const contact::Case& c, const Histories& histories);

/// Von Mises' stress in the section below the contact, a map per model, and down the axis for all;
/// none where no inside was written.
std::vector<Plot> subsurface_plots(const contact::Case& c, const Histories& histories);

/// Of a rough case: power spectral density, measured beside prescribed; of a nominally flat one
/// contact area over load, with what theories say.
std::vector<Plot> rough_plots(const contact::Case& c, const Histories& histories);

/// All of the above, in the report's order; what needs grids is resampled (see resample.h).
std::vector<Plot> make_plots(const contact::Case& c, const Histories& histories);

/// The files of one plot.
struct Drawing {
    std::string svg, png;
};
/// Draws all plots, several at a time; results in the order given. Throws GnuplotError.
std::vector<Drawing> draw_all(const std::vector<Plot>& plots);

}  // namespace tricontact::comparisons

#include "bem/case_grid.h"

#include <fmt/format.h>

#include <cmath>

#include "contact/base/error.h"
#include "contact/cells.h"

// A cell's centre lies at the origin, unless the case shifts it: the indenter's lowest point is
// then seen by one cell, and rolling by whole cells brings back the same heights. Along a line
// contact the grid is one row of strips; a body that ends along y has its rows end there, too, at
// its ends exactly.

namespace tricontact::bem {

namespace {

constexpr double max_cells = 4096. * 4096.;
constexpr double whole_cells = 1e-6;  // how far a period may be from them, in cells

/// The cells along an axis: how many, and the centre of the first one.
struct CellRow {
    double n, first;

    /// That cover `half` on either side of the origin.
    CellRow(const Cells& cells, std::size_t axis, double half) {
        const double h = cells.spacing[axis], centre = cells.centre[axis];
        const double before = std::ceil((half + centre) / h),
                     behind = std::ceil((half - centre) / h);
        n = before + 1 + behind;
        first = centre - before * h;
    }
};

void check_size(double n_x, double n_y) {
    if (n_x * n_y > max_cells)
        throw contact::InputError(
            fmt::format("bem: the grid would have {:.0f} x {:.0f} cells, more than {:.0f}; enlarge "
                        "bem.spacing or shorten the rolling path",
                        n_x, n_y, max_cells));
}

}  // namespace

Cells cells_of(const contact::Case& c, double spacing) {
    const auto& cells = c.of<contact::Cells>();
    const double along_y = c.is_cylindrical() ? spacing : spacing * cells.ratio.value_or(1);
    return {{spacing, along_y},
            {cells.shift_x.value_or(0) * spacing, cells.shift_y.value_or(0) * along_y}};
}

contact::ContactPoints make_grid(double half_x, double half_y, const Cells& cells, bool mirrored) {
    const CellRow x(cells, 0, half_x), y(cells, 1, half_y);
    check_size(x.n, y.n);
    const int n_x = static_cast<int>(x.n), n_y = static_cast<int>(y.n);
    return mirrored
               ? contact::ContactPoints::mirrored_grid(n_x, n_y / 2 + 1, x.first, cells.spacing)
               : contact::ContactPoints::grid(n_x, n_y, {x.first, y.first}, cells.spacing);
}

contact::ContactPoints make_long_grid(double half_x, const Cells& cells, double length,
                                      bool strips) {
    const CellRow x(cells, 0, half_x);
    const double n_y = strips ? 1 : std::ceil(length / cells.spacing[1] * (1 - whole_cells));
    check_size(x.n, n_y);
    const double width = length / n_y;
    auto grid =
        contact::ContactPoints::grid(static_cast<int>(x.n), static_cast<int>(n_y),
                                     {x.first, -(n_y - 1) / 2 * width}, {cells.spacing[0], width});
    grid.line_length = length;
    return grid;
}

contact::ContactPoints period_grid(double period, double spacing, bool adjustable) {
    const double n = adjustable ? std::ceil(period / spacing) : std::round(period / spacing);
    if (!adjustable && std::abs(period / spacing - n) > whole_cells)
        throw contact::InputError(
            fmt::format("bem: a period of {:.6g} m is no whole number of cells of {:.6g} m; take a "
                        "spacing of {:.6g} m",
                        period, spacing, period / std::max(1., n)));
    check_size(n, n);
    const double h = period / n, first = -std::floor(n / 2) * h;
    return contact::ContactPoints::grid(static_cast<int>(n), static_cast<int>(n), {first, first},
                                        {h, h});
}

}  // namespace tricontact::bem

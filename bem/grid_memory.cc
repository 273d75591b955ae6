#include "bem/grid_memory.h"

#include <fmt/format.h>

#include "bem/grid_compliance.h"
#include "bem/grid_convolution.h"
#include "bem/influence.h"
#include "contact/memory.h"

namespace tricontact::bem {

namespace {

constexpr double number = sizeof(double);

// Numbers of all that a GridCompliance makes, at the making of its last symbol: rows and spectra of
// two fields each on the padded and on the plain grid, symbols over half of the wave numbers,
// influence coefficients at a quarter of the padded positions, the kernel transformed and its
// spectrum. On a period the padded grid is the plain one.
double compliance_numbers(const contact::ContactPoints& grid, bool padded, bool coupled) {
    constexpr double two_fields = 4, tangential = 3, both_ways = 2, quadrants = 5, kernel = 2;
    const double cells = static_cast<double>(grid.n_x) * grid.n_y;
    const double p_x = padded ? good_fft_size(2 * grid.n_x - 1) : grid.n_x;
    const double p_y = padded ? good_fft_size(2 * grid.n_y - 1) : grid.n_y;
    const double symbols = 1 + tangential + (coupled ? both_ways : 0);
    return two_fields * (p_x * grid.n_y + cells) + symbols * p_x * p_y / 2 +
           tangential * cells / 2 + (quadrants / 4 + kernel) * p_x * p_y;
}

}  // namespace

double predicted_bytes(const contact::Case& c, Body body, Surroundings surroundings,
                       const contact::ContactPoints& grid) {
    // Fields beside, counted by what runs take of 100 to 650 cells along a side. Steady rolling
    // keeps a direction of search per iteration.
    constexpr double elastic = 72, coupling = 18, relaxing = 9, branch = 6, steady = 400;
    const bool coupled = c.contact.coupling && (body == Body::layer || is_coupled(c.materials()));
    double fields = elastic + (coupled ? coupling : 0);
    if (c.tractive_rolling) fields += steady;
    if (c.relaxation)
        fields += relaxing + branch * static_cast<double>(c.relaxation->branches.size());
    return number * (compliance_numbers(grid, surroundings == Surroundings::free, coupled) +
                     fields * static_cast<double>(grid.size()));
}

double influence_bytes(const contact::ContactPoints& whole) {
    constexpr double growing = 2, fields = 14;  // a vector that doubles; displacements and loads
    return growing * sizeof(InfluenceCoefficients) * static_cast<double>(whole.size()) +
           number * (compliance_numbers(whole, false, true) +
                     fields * static_cast<double>(whole.size()));
}

void require_memory(const contact::ContactPoints& grid, double bytes) {
    contact::require_memory(fmt::format("bem: a grid of {} x {} cells", grid.n_x, grid.n_y), bytes,
                            "enlarge bem.spacing or shorten the rolling path");
}

}  // namespace tricontact::bem

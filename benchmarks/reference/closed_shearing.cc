#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "benchmarks/reference/exact_parts.h"
#include "comparisons/quantities/reference.h"
#include "contact/half_space_scales.h"
#include "theory/cattaneo_mindlin.h"

namespace tricontact::benchmarks {

namespace {

using contact::Case;
namespace keys = quantity_keys;
using std::numbers::pi;

/// Values of Cattaneo and Mindlin's contact under a load applied once; none where they have none.
std::map<std::string, double> closed_scalars(const Case& c) {
    const comparisons::Reference closed = comparisons::reference(c);
    const double f = closed.tangential_ratio, a = closed.hertz.contact_radius;
    std::map<std::string, double> values;
    if (!(f > 0 && f < 1)) return values;
    const double length = c.is_line_contact() ? c.indenter.length : 1;
    values[keys::tangential_force] =
        f * c.friction_coefficient() * closed.hertz.normal_force / length;
    if (c.is_line_contact()) {
        if (closed.stick_ratio) values[keys::stick_area] = 2 * a * *closed.stick_ratio;
        return values;
    }
    if (!contact::is_hertz_round(c)) return {};
    const double stick = a * theory::stick_radius_ratio(f);
    values[keys::shift] = closed.static_shift_ratio * closed.hertz.unit_shift;
    values[keys::stick_area] = pi * stick * stick;
    return values;
}

}  // namespace

// Exact in plane strain, and of bodies of revolution where Poisson's ratio is zero.
void take_closed_shearing(Reference& reference) {
    const Case& c = reference.c;
    if (c.layer.thickness || c.rolling || c.prescribed_path || !is_uncoupled(c)) return;
    if (c.interface.is_elastic()) return;
    const auto closed = closed_scalars(c);
    if (closed.empty()) return;
    if (c.is_line_contact() || c.materials().nu_over_g() == 0) {
        replace_by_exact(reference, closed,
                         c.is_line_contact() ? "Cattaneo (1938)" : "Cattaneo and Mindlin (1949)");
        return;
    }
    const ReferenceValue* shift = reference.find(keys::shift);
    if (!shift) return;
    reference.remarks.push_back(fmt::format(
        "Cattaneo and Mindlin's closed form leaves out tractions across the force: its shift "
        "differs by {:+.2g} %",
        100 * (closed.at(keys::shift) / shift->value - 1)));
}

}  // namespace tricontact::benchmarks

#include "atlas/line_maps.h"

#include <array>

#include "atlas/map_coordinates.h"
#include "atlas/shipped_maps.h"
#include "comparisons/quantities/quantities.h"
#include "contact/base/special_values.h"
#include "theory/oscillating_cylinder.h"

namespace tricontact::atlas {

namespace {

namespace quantities = comparisons::quantities;

/// Undefined out of range, where the atlas refuses w.
double half_space_line_limit(double w) {
    return w >= 0 && w <= 1 ? theory::line_shakedown_limit(w) : contact::undefined;
}

/// Coordinates of an atlas of the layer; the load is the second of them.
std::vector<double> on_layer_at(const Atlas& atlas, double w, double load, const BondedLayer& l) {
    return coordinates_in(atlas, {w, load},
                          {{"substrate.thickness_ratio", l.thickness_ratio},
                           {"substrate.poisson", l.poisson},
                           {"friction.coefficient", l.friction_coefficient}});
}

}  // namespace

Value line_shift_increment_ratio(double w, double f, double lambda) {
    ShippedMaps& maps = maps_of<"cylinder_half_space_ratcheting">();
    const Value there = maps.read_at(quantities::shift_increment_ratio,
                                     std::array{w, excess_of(f, half_space_line_limit(w))});
    const double scale = contact::line_shift_factor(maps.atlas().kept) / lambda;
    return {there.value * scale, there.error * scale};
}

Value line_layer_shift_factor(double thickness_ratio, double poisson) {
    ShippedMaps& maps = maps_of<"cylinder_layer_pressed">();
    const Value there = maps.read_at(quantities::unit_shift,
                                     std::array{maps.least_amplitude(), thickness_ratio, poisson});
    const double lambda = contact::line_shift_factor(case_of_runs(maps.atlas(), poisson));
    return {there.value * lambda, there.error * lambda};
}

Value line_layer_shakedown_limit(double w, double thickness_ratio, double poisson) {
    return maps_of<"cylinder_layer_pressed">().read_at(quantities::limit_tangential_ratio,
                                                       std::array{w, thickness_ratio, poisson});
}

Value line_static_shift_ratio(double f, const BondedLayer& l) {
    return maps_of<"cylinder_layer_static">().read_at(
        quantities::static_shift_ratio,
        std::array{f, l.thickness_ratio, l.poisson, l.friction_coefficient});
}

Value line_settled_shift_ratio(double w, double f, const BondedLayer& l) {
    const Value limit = line_layer_shakedown_limit(w, l.thickness_ratio, l.poisson);
    const double fraction = f / limit.value;
    ShippedMaps& maps = maps_of<"cylinder_layer">();
    return maps.read_at_load(quantities::settled_shift_ratio,
                             on_layer_at(maps.atlas(), w, fraction, l),
                             fraction * limit.error / limit.value);
}

Value line_shift_increment_ratio(double w, double f, const BondedLayer& l) {
    const Value limit = line_layer_shakedown_limit(w, l.thickness_ratio, l.poisson);
    ShippedMaps& maps = maps_of<"cylinder_layer_ratcheting">();
    return maps.read_at_load(quantities::shift_increment_ratio,
                             on_layer_at(maps.atlas(), w, excess_of(f, limit.value), l),
                             limit.error / (1 - limit.value));
}

}  // namespace tricontact::atlas

#include "atlas/contact_maps.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <utility>
#include <vector>

#include "atlas/map_coordinates.h"
#include "atlas/shipped_maps.h"
#include "comparisons/quantities/quantities.h"
#include "contact/base/root.h"
#include "contact/base/special_values.h"
#include "theory/rolling/oscillating_rolling.h"
#include "theory/rolling/rolled_law.h"

namespace tricontact::atlas {

namespace {

using comparisons::Quantity;
namespace quantities = comparisons::quantities;

/// Undefined out of range, where the atlas refuses w.
double half_space_limit(double w) {
    return w >= 0 && w <= 1 ? theory::shakedown_limit(w) : contact::undefined;
}

Value on_half_space(const Quantity& q, double w, double f, double angle, double poisson) {
    return maps_of<"sphere_half_space">().read_at(
        q, std::array{w, f / half_space_limit(w), folded_angle(angle), poisson});
}

Value under_strength(const Quantity& q, double w, double f, double angle, double poisson) {
    const double limit =
        w >= 0 && w <= 1 ? theory::strength_rolling.exact_limit(w) : contact::undefined;
    return maps_of<"sphere_half_space_strength">().read_at(
        q, std::array{w, f / limit, folded_angle(angle), poisson});
}

/// The same beyond the limit, of which `f` has the share of the way to 1. The atlas of ratcheting
/// is about one Poisson's ratio.
Value increment_on_layer(double w, double f, double angle, const BondedLayer& l) {
    const Value limit = layer_shakedown_limit(w, l.thickness_ratio, l.poisson);
    ShippedMaps& maps = maps_of<"sphere_layer_ratcheting">();
    return maps.read_at_load(quantities::shift_increment_ratio,
                             coordinates_in(maps.atlas(), {w, excess_of(f, limit.value)},
                                            {{"rolling.angle", folded_angle(angle)},
                                             {"substrate.thickness_ratio", l.thickness_ratio},
                                             {"substrate.poisson", l.poisson},
                                             {"friction.coefficient", l.friction_coefficient}}),
                             limit.error / (1 - limit.value));
}

/// MDR's load at its settled shift.
double mdr_load(double w, double u) {
    if (!(u > 0 && u < (1 - w) * (1 + w)))
        throw std::domain_error("settled_shift_of_mdr: the shift must lie in (0, 1 - w^2)");
    return 1 - theory::mdr_mapping * w * u - std::pow(1 - u, 1.5);
}

Value on_layer(const Quantity& q, double w, double f, double angle, const BondedLayer& l) {
    const Value limit = layer_shakedown_limit(w, l.thickness_ratio, l.poisson);
    const double fraction = f / limit.value;
    return maps_of<"sphere_layer">().read_at_load(
        q, {w, fraction, folded_angle(angle), l.thickness_ratio, l.poisson, l.friction_coefficient},
        fraction * limit.error / limit.value);
}

}  // namespace

Value static_shift_ratio(double f, double poisson) {
    return maps_of<"sphere_half_space_static">().read_at(quantities::static_shift_ratio,
                                                         std::array{f, poisson});
}

Value settled_shift_ratio(double w, double f, double angle, double poisson) {
    return on_half_space(quantities::settled_shift_ratio, w, f, angle, poisson);
}

Value mapping_parameter(double w, double f, double angle, double poisson) {
    return on_half_space(quantities::kappa, w, f, angle, poisson);
}

Value strength_static_shift_ratio(double f, double poisson) {
    return maps_of<"sphere_half_space_strength_static">().read_at(quantities::static_shift_ratio,
                                                                  std::array{f, poisson});
}

Value strength_settled_shift_ratio(double w, double f, double angle, double poisson) {
    return under_strength(quantities::settled_shift_ratio, w, f, angle, poisson);
}

Value strength_mapping_parameter(double w, double f, double angle, double poisson) {
    return under_strength(quantities::kappa, w, f, angle, poisson);
}

Value shift_increment_ratio(double w, double f, double angle, double poisson) {
    return maps_of<"sphere_half_space_ratcheting">().read_at(
        quantities::shift_increment_ratio,
        std::array{w, excess_of(f, half_space_limit(w)), folded_angle(angle), poisson});
}

Value mdr_shift_increment_ratio(double w, double f) {
    return maps_of<"sphere_springs_ratcheting">().read_at(
        quantities::shift_increment_ratio, std::array{w, excess_of(f, half_space_limit(w))});
}

Value settled_shift_of_mdr(double mdr_shift, double w, double angle, double poisson) {
    return settled_shift_ratio(w, mdr_load(w, mdr_shift), angle, poisson);
}

Value shift_increment_of_mdr(double mdr_increment, double w, double angle, double poisson) {
    const double limit = half_space_limit(w);
    const auto load = [&](double excess) { return limit + excess * (1 - limit); };
    const auto [least, most] = maps_of<"sphere_half_space_ratcheting">().loads();
    const auto difference = [&](double excess) {
        return mdr_shift_increment_ratio(w, load(excess)).value - mdr_increment;
    };
    if (!(difference(least) <= 0 && difference(most) >= 0))
        throw OutsideDomain(fmt::format(
            "MDR's increment {:.6g}: at w = {:.6g} the atlases have none of it", mdr_increment, w));
    const double excess = contact::bracketed_root(difference, least, most);
    return shift_increment_ratio(w, load(excess), angle, poisson);
}

Value static_shift_ratio(double f, const BondedLayer& l) {
    return maps_of<"sphere_layer_static">().read_at(
        quantities::static_shift_ratio,
        std::array{f, l.thickness_ratio, l.poisson, l.friction_coefficient});
}

Value settled_shift_ratio(double w, double f, double angle, const BondedLayer& l) {
    return on_layer(quantities::settled_shift_ratio, w, f, angle, l);
}

Value mapping_parameter(double w, double f, double angle, const BondedLayer& l) {
    return on_layer(quantities::kappa, w, f, angle, l);
}

Value shift_increment_ratio(double w, double f, double angle, const BondedLayer& l) {
    return increment_on_layer(w, f, angle, l);
}

Value settled_shift_of_mdr(double mdr_shift, double w, double angle, const BondedLayer& l) {
    return settled_shift_ratio(w, mdr_load(w, mdr_shift), angle, l);
}

Value layer_shakedown_limit(double w, double thickness_ratio, double poisson) {
    return maps_of<"sphere_layer_pressed">().read_at(quantities::limit_tangential_ratio,
                                                     std::array{w, thickness_ratio, poisson});
}

PressedRatios pressed_layer_ratios(double thickness_ratio, double poisson) {
    ShippedMaps& maps = maps_of<"sphere_layer_pressed">();
    maps.go_to(std::array{maps.least_amplitude(), thickness_ratio, poisson});
    return {.contact_radius = maps.read(quantities::contact_radius),
            .indentation = maps.read(quantities::indentation),
            .peak_pressure = maps.read(quantities::peak_pressure),
            .unit_shift = maps.read(quantities::unit_shift)};
}

}  // namespace tricontact::atlas

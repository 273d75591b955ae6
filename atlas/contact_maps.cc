#include "atlas/contact_maps.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <utility>
#include <vector>

#include "atlas/map_coordinates.h"
#include "atlas/shipped.h"
#include "comparisons/quantities/quantities.h"
#include "contact/root.h"
#include "contact/special_values.h"
#include "theory/rolling/oscillating_rolling.h"

namespace tricontact::atlas {

namespace {

using comparisons::Quantity;
namespace quantities = comparisons::quantities;

/// A shipped atlas with a reader, for one thread.
class ShippedMaps {
  public:
    explicit ShippedMaps(const char* name) : atlas_(shipped(name)), reader_(atlas_) {}

    double least_amplitude() const { return atlas_.axes.front().from; }
    /// From the least to the largest.
    std::pair<double, double> loads() const { return {atlas_.axes[1].from, atlas_.axes[1].to}; }
    void go_to(std::span<const double> coordinates) { reader_.go_to(coordinates); }
    Value read(const Quantity& q) const {
        const Map& map = *atlas_.find(q);
        return said(atlas_, map, reader_.read(map));
    }
    Value read_at(const Quantity& q, std::span<const double> coordinates) {
        go_to(coordinates);
        return read(q);
    }
    /// The second coordinate, the load, has an error.
    Value read_at_load(const Quantity& q, std::vector<double> coordinates, double load_error) {
        const Map& map = *atlas_.find(q);
        const std::array errors{0., load_error};
        return said(atlas_, map, reader_.read_with_errors(map, std::move(coordinates), errors));
    }

  private:
    const Atlas& atlas_;
    Reader reader_;
};

/// A shipped atlas' name as a template argument.
struct Name {
    template <std::size_t n>
    constexpr Name(const char (&letters)[n]) {
        std::ranges::copy(letters, text);
    }
    char text[40] = {};
};

/// One reader of each atlas and thread.
template <Name name>
ShippedMaps& maps_of() {
    thread_local ShippedMaps maps(name.text);
    return maps;
}

/// Undefined out of range, where the atlas refuses w.
double half_space_limit(double w) {
    return w >= 0 && w <= 1 ? theory::shakedown_limit(w) : contact::undefined;
}

Value on_half_space(const Quantity& q, double w, double f, double angle, double poisson) {
    return maps_of<"sphere_half_space">().read_at(
        q, std::array{w, f / half_space_limit(w), folded_angle(angle), poisson});
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

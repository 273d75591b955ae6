#include "atlas/contact_maps.h"

#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "atlas/prediction.h"
#include "atlas/shipped.h"
#include "comparisons/quantities/quantities.h"
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

    double least_amplitude() const { return atlas_.axes.front().range.from; }
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

ShippedMaps& half_space_maps() {
    thread_local ShippedMaps maps("sphere_half_space");
    return maps;
}

ShippedMaps& pressed_layer_maps() {
    thread_local ShippedMaps maps("sphere_layer_pressed");
    return maps;
}

ShippedMaps& layer_maps() {
    thread_local ShippedMaps maps("sphere_layer");
    return maps;
}

/// Undefined out of range, where the atlas refuses w.
double half_space_limit(double w) {
    return w >= 0 && w <= 1 ? theory::shakedown_limit(w) : contact::undefined;
}

Value on_half_space(const Quantity& q, double w, double f, double angle, double poisson) {
    return half_space_maps().read_at(
        q, std::array{w, f / half_space_limit(w), folded_angle(angle), poisson});
}

Value on_layer(const Quantity& q, double w, double f, double angle, const BondedLayer& l) {
    const Value limit = layer_shakedown_limit(w, l.thickness_ratio, l.poisson);
    const double fraction = f / limit.value;
    return layer_maps().read_at_load(
        q, {w, fraction, folded_angle(angle), l.thickness_ratio, l.poisson, l.friction_coefficient},
        fraction * limit.error / limit.value);
}

}  // namespace

// Before it rolls the amplitude changes nothing; at the least one the load reaches farthest.
Value static_shift_ratio(double f, double poisson) {
    return on_half_space(quantities::static_shift_ratio, half_space_maps().least_amplitude(), f, 0,
                         poisson);
}

Value settled_shift_ratio(double w, double f, double angle, double poisson) {
    return on_half_space(quantities::settled_shift_ratio, w, f, angle, poisson);
}

Value mapping_parameter(double w, double f, double angle, double poisson) {
    return on_half_space(quantities::kappa, w, f, angle, poisson);
}

Value static_shift_ratio(double f, const BondedLayer& l) {
    return on_layer(quantities::static_shift_ratio, layer_maps().least_amplitude(), f, 0, l);
}

Value settled_shift_ratio(double w, double f, double angle, const BondedLayer& l) {
    return on_layer(quantities::settled_shift_ratio, w, f, angle, l);
}

Value mapping_parameter(double w, double f, double angle, const BondedLayer& l) {
    return on_layer(quantities::kappa, w, f, angle, l);
}

Value layer_shakedown_limit(double w, double thickness_ratio, double poisson) {
    return pressed_layer_maps().read_at(quantities::limit_tangential_ratio,
                                        std::array{w, thickness_ratio, poisson});
}

PressedRatios pressed_layer_ratios(double thickness_ratio, double poisson) {
    ShippedMaps& maps = pressed_layer_maps();
    maps.go_to(std::array{maps.least_amplitude(), thickness_ratio, poisson});
    return {.contact_radius = maps.read(quantities::contact_radius),
            .indentation = maps.read(quantities::indentation),
            .peak_pressure = maps.read(quantities::peak_pressure),
            .unit_shift = maps.read(quantities::unit_shift)};
}

}  // namespace tricontact::atlas

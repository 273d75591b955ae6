#include "atlas/pressed_layer.h"

#include <array>
#include <cmath>

#include "atlas/map_coordinates.h"
#include "comparisons/quantities/quantities.h"
#include "contact/base/root.h"

namespace tricontact::atlas {

namespace quantities = comparisons::quantities;

namespace {

double length_ratio(const contact::Case& c) {
    return c.indenter.length / half_space_scales(c).contact_radius;
}

/// Of the same load per length on another length.
contact::HalfSpaceScales scales_of_length(contact::Case c, double ratio) {
    const contact::HalfSpaceScales own = half_space_scales(c);
    const double length = ratio * own.contact_radius;
    c.load.indentation.reset();
    c.load.normal_force = own.normal_force * length / c.indenter.length;
    c.indenter.length = length;
    contact::HalfSpaceScales scales = half_space_scales(c);
    scales.normal_force = own.normal_force;
    return scales;
}

}  // namespace

PressedLayer::PressedLayer(const contact::Case& c, const Atlas& atlas)
    : atlas_(atlas), poisson_(c.substrate.poisson) {
    place(c);
    if (c.load.indentation) find_force(c);
}

const Axis& PressedLayer::thickness_axis() const {
    return *atlas_.axis("substrate.thickness_ratio");
}

void PressedLayer::place(const contact::Case& c) {
    hertz_ = c.is_line_contact() ? scales_of_length(c, length_ratio(case_of_runs(atlas_, poisson_)))
                                 : half_space_scales(c);
    thickness_ratio_ = *c.layer.thickness / (2 * hertz_.contact_radius);
}

// The indentation grows with the force.
void PressedLayer::find_force(const contact::Case& c) {
    // Force of the thinnest layer over that of its half-space at the same depth is less than that,
    // and so is its inverse on the thickest one under a line.
    constexpr double stiffest = 40;
    contact::Case forced = c;
    forced.load.indentation.reset();
    const auto excess = [&](double log_force) {
        forced.load.normal_force = std::exp(log_force);
        place(forced);
        // Beyond the maps on the side of small or large forces.
        if (!thickness_axis().is_inside(thickness_ratio_))
            return thickness_ratio_ > thickness_axis().to ? -std::log(stiffest)
                                                          : std::log(stiffest);
        const double depth = scale(quantities::indentation).value * hertz_.indentation;
        return std::log(depth / *c.load.indentation);
    };
    const double middle = std::log(half_space_scales(c).normal_force), reach = std::log(stiffest);
    excess(contact::bracketed_root(excess, middle - reach, middle + reach));
    scale(quantities::indentation);  // throws if that is beyond the maps
}

Value PressedLayer::scale(const comparisons::Quantity& q) const {
    return read_with_errors(atlas_, *atlas_.find(q),
                            {least_amplitude(), thickness_ratio_, poisson_}, {});
}

Value PressedLayer::limit(const Value& w) const {
    const double least = least_amplitude();
    // From 1 at rest the limit falls with the amplitude in proportion.
    if (w.value < least) {
        const Value there = limit({least, 0});
        return {1 + w.value / least * (there.value - 1), w.value / least * there.error};
    }
    return read_with_errors(atlas_, *atlas_.find(quantities::limit_tangential_ratio),
                            {w.value, thickness_ratio_, poisson_}, std::array{w.error});
}

}  // namespace tricontact::atlas

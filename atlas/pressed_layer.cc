#include "atlas/pressed_layer.h"

#include <array>
#include <cmath>

#include "comparisons/quantities/quantities.h"
#include "contact/root.h"

namespace tricontact::atlas {

namespace quantities = comparisons::quantities;

PressedLayer::PressedLayer(const contact::Case& c, const Atlas& atlas)
    : atlas_(atlas), hertz_(half_space_scales(c)), poisson_(c.substrate.poisson) {
    place(c);
    if (c.load.indentation) find_force(c);
}

void PressedLayer::place(const contact::Case& c) {
    thickness_ratio_ = *c.layer.thickness / (2 * hertz_.contact_radius);
}

// The indentation grows with the force.
void PressedLayer::find_force(const contact::Case& c) {
    // The thinnest layer is stiffer than its half-space by less than that.
    constexpr double stiffest = 40;
    contact::Case forced = c;
    forced.load.indentation.reset();
    const auto excess = [&](double log_force) {
        forced.load.normal_force = std::exp(log_force);
        hertz_ = half_space_scales(forced);
        place(forced);
        const double depth = scale(quantities::indentation).value * hertz_.indentation;
        return std::log(depth / *c.load.indentation);
    };
    const double softest = std::log(hertz_.normal_force);
    excess(contact::bracketed_root(excess, softest, softest + std::log(stiffest)));
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

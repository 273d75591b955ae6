#include "comparisons/half_space/exact_deviation.h"

#include <utility>

#include "contact/load_path.h"
#include "theory/layer/sticking_contact.h"

namespace tricontact::comparisons {

namespace {

using theory::LayerBase;
using theory::StickTractions;

/// Diameters of Hertz' contact from which on a layer is a half-space: deviations fall as 1/b.
constexpr double half_space_thickness = 1e9;

}  // namespace

theory::ElasticLayer DeviationContact::layer(double thickness_ratio, double poisson,
                                             LayerBase base) const {
    return {{effective_modulus * (1 - poisson * poisson), poisson},
            thickness_ratio * hertz_diameter,
            base};
}

ExactDeviation::ExactDeviation(DeviationContact contact, double poisson, LayerBase base)
    : contact_(std::move(contact)), poisson_(poisson), base_(base) {
    const theory::LayerContact thick = contact_at(half_space_thickness);
    for (const Quantity* q : exact_quantities)
        if (const auto known = value(q, half_space_thickness, thick)) half_space_[q] = *known;
}

theory::LayerContact ExactDeviation::contact_at(double thickness_ratio) const {
    return solve_layer_contact(contact_.layer(thickness_ratio, poisson_, base_), *contact_.indenter,
                               {contact::NormalControl::Kind::force, contact_.normal_force});
}

std::optional<double> ExactDeviation::value(const Quantity* q, double thickness_ratio,
                                            const theory::LayerContact& c) const {
    using namespace quantities;
    const auto sticking = [&](StickTractions tractions) -> std::optional<double> {
        if (base_ == LayerBase::frictionless) return {};
        return sticking_stiffness(contact_.layer(thickness_ratio, poisson_, base_),
                                  c.contact_radius, tractions);
    };
    const double w = contact_.amplitude_ratio, f = contact_.tangential_ratio;
    if (q == &contact_radius) return c.contact_radius;
    if (q == &indentation) return c.indentation;
    if (q == &peak_pressure) return c.centre_pressure;
    if (q == &unit_shift) return c.unit_shift;
    if (q == &normal_stiffness) return c.normal_stiffness;
    if (q == &tangential_stiffness) return sticking(StickTractions::in_plane);
    if (q == &coupled_tangential_stiffness) return sticking(StickTractions::all);
    if (q == &limit_tangential_ratio && w > 0 && w < 1) return theory::shakedown_limit(c, w);
    if (q == &limit_amplitude_ratio && w > 0 && f > 0) return theory::amplitude_limit(c, f);
    return {};
}

std::optional<double> ExactDeviation::ratio(const Quantity* q, double thickness_ratio) const {
    const double* half_space = found(half_space_, q);
    if (!half_space) return {};
    return *value(q, thickness_ratio, contact_at(thickness_ratio)) / *half_space;
}

ExactRatios ExactDeviation::ratios(double thickness_ratio, bool coupled) const {
    const theory::LayerContact c = contact_at(thickness_ratio);
    ExactRatios result;
    for (const auto& [q, half_space] : half_space_)
        if (q != &quantities::coupled_tangential_stiffness || coupled)
            result[q] = *value(q, thickness_ratio, c) / half_space;
    return result;
}

}  // namespace tricontact::comparisons

#include "comparisons/half_space/exact_deviation.h"

#include <utility>

#include "comparisons/quantities/quantities.h"
#include "contact/load_path.h"
#include "theory/layer/elastic_layer.h"
#include "theory/sticking_contact.h"

namespace tricontact::comparisons {

namespace {

using theory::LayerBase;
using theory::StickTractions;

/// Diameters of Hertz' contact from which on a layer is a half-space: deviations fall as 1/b.
constexpr double half_space_thickness = 1e9;

const std::array<const Quantity*, n_exact_quantities> descriptions{
    &quantities::contact_radius,
    &quantities::indentation,
    &quantities::peak_pressure,
    &quantities::unit_shift,
    &quantities::normal_stiffness,
    &quantities::tangential_stiffness,
    &quantities::coupled_tangential_stiffness,
    &quantities::limit_tangential_ratio,
    &quantities::limit_amplitude_ratio};

}  // namespace

const Quantity& describe(ExactQuantity q) {
    return *descriptions.at(static_cast<std::size_t>(q));
}

const std::array<ExactQuantity, n_exact_quantities>& exact_quantities() {
    static const auto all = [] {
        std::array<ExactQuantity, n_exact_quantities> result{};
        for (std::size_t i = 0; i < result.size(); ++i) result[i] = static_cast<ExactQuantity>(i);
        return result;
    }();
    return all;
}

theory::ElasticLayer DeviationContact::layer(double thickness_ratio, double poisson,
                                             LayerBase base) const {
    return {{effective_modulus * (1 - poisson * poisson), poisson},
            thickness_ratio * hertz_diameter,
            base};
}

ExactDeviation::ExactDeviation(DeviationContact contact, double poisson, LayerBase base)
    : contact_(std::move(contact)), poisson_(poisson), base_(base) {
    const theory::LayerContact thick = half_space();
    for (const ExactQuantity q : exact_quantities())
        half_space_[static_cast<std::size_t>(q)] = value(q, half_space_thickness, thick);
}

theory::LayerContact ExactDeviation::contact_at(double thickness_ratio) const {
    return solve_layer_contact(contact_.layer(thickness_ratio, poisson_, base_), *contact_.indenter,
                               {contact::NormalControl::Kind::force, contact_.normal_force});
}

theory::LayerContact ExactDeviation::half_space() const {
    return contact_at(half_space_thickness);
}

std::optional<double> ExactDeviation::value(ExactQuantity q, double thickness_ratio,
                                            const theory::LayerContact& c) const {
    const auto sticking = [&](StickTractions tractions) -> std::optional<double> {
        if (base_ == LayerBase::frictionless) return {};
        return sticking_stiffness(contact_.layer(thickness_ratio, poisson_, base_),
                                  c.contact_radius, tractions);
    };
    switch (q) {
        case ExactQuantity::contact_radius:
            return c.contact_radius;
        case ExactQuantity::indentation:
            return c.indentation;
        case ExactQuantity::peak_pressure:
            return c.centre_pressure;
        case ExactQuantity::unit_shift:
            return c.unit_shift;
        case ExactQuantity::normal_stiffness:
            return c.normal_stiffness;
        case ExactQuantity::tangential_stiffness:
            return sticking(StickTractions::in_plane);
        case ExactQuantity::coupled_tangential_stiffness:
            return sticking(StickTractions::all);
        case ExactQuantity::limit_tangential_ratio:
            if (!(contact_.amplitude_ratio > 0 && contact_.amplitude_ratio < 1)) return {};
            return theory::shakedown_limit(c, contact_.amplitude_ratio);
        case ExactQuantity::limit_amplitude_ratio:
            if (!(contact_.amplitude_ratio > 0 && contact_.tangential_ratio > 0)) return {};
            return theory::amplitude_limit(c, contact_.tangential_ratio);
    }
    return {};
}

std::optional<double> ExactDeviation::ratio(ExactQuantity q, double thickness_ratio) const {
    const auto half_space = half_space_[static_cast<std::size_t>(q)];
    if (!half_space) return {};
    return *value(q, thickness_ratio, contact_at(thickness_ratio)) / *half_space;
}

ExactRatios ExactDeviation::ratios(double thickness_ratio, bool coupled) const {
    const theory::LayerContact c = contact_at(thickness_ratio);
    ExactRatios result;
    for (const ExactQuantity q : exact_quantities()) {
        const auto i = static_cast<std::size_t>(q);
        if (!half_space_[i]) continue;
        if (q == ExactQuantity::coupled_tangential_stiffness && !coupled) continue;
        result[i] = *value(q, thickness_ratio, c) / *half_space_[i];
    }
    return result;
}

}  // namespace tricontact::comparisons

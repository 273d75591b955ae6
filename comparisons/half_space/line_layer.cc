#include "comparisons/half_space/line_layer.h"

#include <cmath>
#include <numbers>

#include "comparisons/quantities/reference.h"
#include "contact/error.h"
#include "contact/root.h"

namespace tricontact::comparisons {

using contact::Case;

std::optional<theory::LineContact> exact_line_contact(const Case& c) {
    if (!c.layer.thickness || !why_no_exact_theory(c).empty()) return {};
    using Kind = theory::LineControl::Kind;
    const theory::LineControl control =
        c.load.normal_force
            ? theory::LineControl{Kind::load, *c.load.normal_force / c.indenter.length}
            : theory::LineControl{Kind::indentation, *c.load.indentation};
    return theory::solve_line_contact(elastic_layer(c), c.indenter.radius, control);
}

PressedValues line_pressed_values(const Case& c, const theory::LineContact& line) {
    const double length = c.indenter.length;
    return {line.half_width,        line.indentation, line.load * length, line.centre_pressure, {},
            line.stiffness * length};
}

std::optional<double> line_layer_limit(const Case& c, LimitVariable variable) {
    std::optional<theory::LineContact> line;
    try {
        line = exact_line_contact(c);
    } catch (const contact::InputError&) {  // out of the theory's range
    }
    if (!line) return {};
    const double a = line->half_width;
    const double reference_width = c.rolling->amplitude_reference == Case::AmplitudeReference::model
                                       ? a
                                       : contact::half_space_scales(c).contact_radius;
    const auto limit = [&](double w) { return line->load_beyond(w * a) / line->load; };
    if (variable == LimitVariable::load) {
        const double w = contact::rolling_amplitude(*c.rolling, reference_width) / a;
        return in_unit_range(w) ? std::optional(limit(w)) : std::nullopt;
    }
    const double force = line->load * c.indenter.length;
    const double f = c.load.tangential_ratio
                         ? *c.load.tangential_ratio
                         : c.load.tangential_force.value_or(0) / (c.friction_coefficient * force);
    if (!in_unit_range(f)) return {};
    return contact::bracketed_root([&](double w) { return limit(w) - f; }, 0., 1.) * a /
           reference_width;
}

double line_stiffness(const Case& c, double half_width) {
    const double length = c.indenter.length;
    return std::numbers::pi * c.materials().effective_modulus() * length /
           (2 * std::log(2 * length / half_width));
}

}  // namespace tricontact::comparisons

#include "contact/case.h"

namespace tricontact::contact {

double Case::Layer::total_thickness() const {
    double sum = *thickness;
    for (const Lower& one : lower) sum += one.thickness;
    return sum;
}

bool is_hertz_round(const Case& c) {
    const bool round =
        c.indenter.shape == Case::Shape::paraboloid || c.indenter.shape == Case::Shape::sphere;
    return round && !c.indenter.roughness;
}

bool has_conical_tip(const Case& c) {
    const Case::IndenterData& body = c.indenter;
    return body.shape == Case::Shape::cone ||
           (body.shape == Case::Shape::power_law && body.exponent == 1) ||
           (body.shape == Case::Shape::profile && body.profile.front().kink);
}

double rolling_amplitude(const Case::Rolling& rolling, double reference_radius) {
    return rolling.amplitude ? *rolling.amplitude : *rolling.amplitude_ratio * reference_radius;
}

}  // namespace tricontact::contact

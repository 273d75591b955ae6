#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "mdr/back_transform.h"
#include "mdr/line_surface.h"
#include "mdr/spring_bed.h"

namespace tricontact::mdr {

using contact::ContactState;
using contact::Surface;

namespace {

/// Even line loads on 0 = x_0 < x_1 < ... < a, for the back-transformation.
struct EvenLoads {
    std::vector<double> positions, normal, tangential;
};

EvenLoads even_loads(const NormalBed& bed, const std::vector<double>& deflections,
                     double effective_modulus, double effective_shear_modulus) {
    const double a = bed.profile().half_width(bed.depth());
    const int n = std::clamp(static_cast<int>(a / bed.spacing()), 2, most_surface_pieces);
    const PointRow row{bed.spring_position(0), bed.spacing()};
    EvenLoads loads;
    for (int k = 0; k < n; ++k) {
        const double x = a * k / n;
        loads.positions.push_back(x);
        loads.normal.push_back(effective_modulus * (bed.depth() - bed.profile().value(x)));
        loads.tangential.push_back(effective_shear_modulus *
                                   row.even(deflections, bed.position(), x));
    }
    loads.positions.push_back(a);
    loads.normal.push_back(0);
    loads.tangential.push_back(0);
    return loads;
}

}  // namespace

contact::Scales SpringBed::scales() const {
    const double a = normal_.profile().half_width(normal_.depth());
    return {.normal_force = normal_force_,
            .contact_radius = a,
            .indentation = normal_.depth(),
            .peak_pressure =
                effective_modulus_ / std::numbers::pi * normal_.profile().centre_integral(a),
            .unit_shift = bound_ratio_ * normal_.depth()};
}

Surface SpringBed::surface() const {
    const int stride = (normal_.size() + most_surface_points - 1) / most_surface_points;
    Surface s;
    s.layout = Surface::Layout::line;
    s.n_x = (normal_.size() - 1) / stride + 1;
    s.n_y = 1;
    s.first = {normal_.spring_position(0), 0};
    s.spacing = {stride * normal_.spacing(), 0};
    s.offset = {normal_.position(), 0};
    resize_fields(s);
    const EvenLoads loads =
        even_loads(normal_, deflections_, effective_modulus_, effective_shear_modulus_);
    for (int k = 0; k < s.n_x; ++k) {
        const double r = std::abs(s.x(k) - normal_.position());
        const std::vector<double> weights = abel_weights(loads.positions, r);
        s.normal_traction[k] = back_transform(loads.positions, loads.normal, weights);
        s.tangential_traction_x[k] = back_transform(loads.positions, loads.tangential, weights);
        s.friction_bound[k] = friction_coefficient_ * s.normal_traction[k];
        set_spring_fields(k * stride, k, s);
    }
    return s;
}

void SpringBed::set_spring_fields(int spring, int point, Surface& s) const {
    const PlaneProfile& profile = normal_.profile();
    const double x = s.x(point) - normal_.position();
    const double gap = profile.value(std::min(std::abs(x), profile.range())) - normal_.depth();
    s.contact_state[point] = contact_state(spring);
    if (s.contact_state[point] == ContactState::open) {
        s.gap[point] = std::max(gap, 0.);
        return;
    }
    s.displacement_x[point] = deflections_[spring];
    s.displacement_z[point] = std::max(-gap, 0.);
    s.normal_line_load[point] = effective_modulus_ * s.displacement_z[point];
    s.tangential_line_load[point] = effective_shear_modulus_ * s.displacement_x[point];
    s.slip_x[point] = s.contact_state[point] == ContactState::slip ? slip(spring) : 0;
    s.dissipation[point] = std::abs(s.tangential_traction_x[point] * s.slip_x[point]);
}

double SpringBed::slip(int spring) const {
    return shift_increment_ - (deflections_[spring] - deflections_before_[spring]);
}

ContactState SpringBed::contact_state(int spring) const {
    if (spring < normal_.contact().first || spring >= normal_.contact().last)
        return ContactState::open;
    return std::abs(slip(spring)) > negligible_slip() ? ContactState::slip : ContactState::stick;
}

std::vector<ContactState> SpringBed::contact_states() const {
    std::vector<ContactState> states;
    states.reserve(normal_.size());
    for (int i = 0; i < normal_.size(); ++i) states.push_back(contact_state(i));
    return states;
}

}  // namespace tricontact::mdr

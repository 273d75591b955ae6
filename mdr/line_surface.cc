#include "mdr/line_surface.h"

#include <cmath>

#include "mdr/back_transform.h"

namespace tricontact::mdr {

using contact::Surface;

void resize_fields(Surface& s) {
    for (auto* field :
         {&s.normal_traction, &s.tangential_traction_x, &s.tangential_traction_y, &s.friction_bound,
          &s.displacement_x, &s.displacement_y, &s.displacement_z, &s.gap, &s.slip_x, &s.slip_y,
          &s.dissipation, &s.normal_line_load, &s.tangential_line_load})
        field->assign(s.size(), 0);
    s.contact_state.assign(s.size(), contact::ContactState::open);
}

Surface make_line_surface(const LineFields& fields) {
    const int n = static_cast<int>(fields.normal_load.size());
    const int stride = (n + most_surface_points - 1) / most_surface_points;
    Surface s;
    s.layout = Surface::Layout::line;
    s.n_x = (n - 1) / stride + 1;
    s.n_y = 1;
    s.first = {fields.row.first, 0};
    s.spacing = {stride * fields.row.spacing, 0};
    s.offset = {fields.position, 0};
    resize_fields(s);
    const EvenLoad normal =
        even_load(fields.row, fields.normal_load, fields.position, most_surface_pieces);
    std::vector<double> tangential;
    for (const double x : normal.positions)
        tangential.push_back(fields.row.even(fields.tangential_load, fields.position, x));
    tangential.back() = 0;
    for (int k = 0; k < s.n_x; ++k) {
        const int i = k * stride;
        const double r = std::abs(s.x(k) - fields.position);
        const std::vector<double> weights = abel_weights(normal.positions, r);
        s.normal_traction[k] = back_transform(normal.positions, normal.values, weights);
        s.tangential_traction_x[k] = back_transform(normal.positions, tangential, weights);
        s.friction_bound[k] = fields.friction_coefficient * s.normal_traction[k];
        s.displacement_x[k] = fields.displacement_x[i];
        s.displacement_z[k] = fields.displacement_z[i];
        s.gap[k] = fields.gap[i];
        s.slip_x[k] = fields.slip_x[i];
        s.normal_line_load[k] = fields.normal_load[i];
        s.tangential_line_load[k] = fields.tangential_load[i];
        s.dissipation[k] = std::abs(s.tangential_traction_x[k] * s.slip_x[k]);
        s.contact_state[k] = fields.contact_state[i];
    }
    return s;
}

}  // namespace tricontact::mdr

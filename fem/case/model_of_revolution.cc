#include "fem/case/model_of_revolution.h"

#include <algorithm>
#include <cmath>

#include "contact/base/error.h"

// Radii h, 2h, ... nh, the axis added by the parabola a + b r^2 through the first two points of
// even fields; radial ones are zero there. A point of the grid has the values at its radius,
// linearly between those of the nodes, and the directions of its position.

namespace tricontact::fem {

namespace {

using contact::Surface;

constexpr int most_points = 61;  // of the grid, from the axis to its side

/// A square grid about the axis and where its points lie among the radii.
class TurnedGrid {
  public:
    /// `n` radii `spacing` [m] apart.
    TurnedGrid(int n, double spacing) {
        const int fits = static_cast<int>(n / std::sqrt(2.));
        const int stride = (fits + most_points - 1) / most_points;
        half_ = std::max(1, fits / stride);
        step_ = stride;
        spacing_ = stride * spacing;
    }

    int side() const { return 2 * half_ + 1; }
    double first() const { return -half_ * spacing_; }
    double spacing() const { return spacing_; }

    std::vector<double> even(const std::vector<double>& radial) const {
        if (radial.empty()) return {};
        const double axis = radial.size() > 1 ? (4 * radial[0] - radial[1]) / 3 : radial.front();
        return turned([&](double r, double, double) { return at(radial, axis, r); });
    }
    /// x components of a radial field; `y`: the others.
    std::vector<double> component(const std::vector<double>& radial, bool y) const {
        return turned([&](double r, double i, double k) {
            return r > 0 ? at(radial, 0, r) * (y ? k : i) / r : 0;
        });
    }
    std::vector<contact::ContactState> states(
        const std::vector<contact::ContactState>& radial) const {
        std::vector<contact::ContactState> all;
        for (const double r : turned([](double r, double, double) { return r; }))
            all.push_back(radial[std::max(0L, std::lround(r) - 1)]);
        return all;
    }

  private:
    /// Values of value(r, x, y) at all points, lengths in radial spacings.
    template <class Value>
    std::vector<double> turned(Value value) const {
        std::vector<double> field;
        for (int k = -half_; k <= half_; ++k)
            for (int i = -half_; i <= half_; ++i)
                field.push_back(value(step_ * std::hypot(i, k), step_ * i, step_ * k));
        return field;
    }
    static double at(const std::vector<double>& radial, double axis, double r) {
        const auto below = std::min(static_cast<std::size_t>(r), radial.size() - 1);
        const double inner = below == 0 ? axis : radial[below - 1];
        return inner + (r - static_cast<double>(below)) * (radial[below] - inner);
    }

    int half_;
    double step_, spacing_;
};

void refuse_tangential(const contact::LoadStep& step) {
    for (const contact::TangentialControl& control : step.tangential)
        if (control.value != 0)
            throw contact::InputError(
                "load: a section of a body of revolution has no load along the surface; take fem");
    if (contact::norm(step.offset) != 0 || step.rotation != 0)
        throw contact::InputError(
            "rolling: a section of a body of revolution is pressed where it is; take fem");
}

}  // namespace

contact::StepRecord ModelOfRevolution::advance(const contact::LoadStep& step) {
    refuse_tangential(step);
    contact::LoadStep held = step;
    for (auto& control : held.tangential) control = {contact::TangentialControl::Kind::shift, 0};
    contact::StepRecord record = radial_->advance(held);
    record.tangential_force = {0, 0};  // radial tractions balance each other around the axis
    return record;
}

contact::Scales ModelOfRevolution::scales() const {
    contact::Scales scales = radial_->scales();
    // Of Hertz' contact of this force and radius: d = 3 F/(4 E* a), and E*/G* times that.
    scales.unit_shift = .75 * scales.sliding_force / (shear_modulus_ * scales.contact_radius);
    return scales;
}

Surface ModelOfRevolution::surface() const {
    const Surface radial = radial_->surface();
    const TurnedGrid grid(radial.n_x, radial.spacing[0]);
    Surface s;
    s.n_x = s.n_y = grid.side();
    s.first = {grid.first(), grid.first()};
    s.spacing = {grid.spacing(), grid.spacing()};
    s.offset = radial.offset;
    for (const auto field :
         {&Surface::normal_traction, &Surface::friction_bound, &Surface::displacement_z,
          &Surface::gap, &Surface::dissipation, &Surface::slip_path, &Surface::friction_work,
          &Surface::tension, &Surface::separation_work})
        s.*field = grid.even(radial.*field);
    const auto turn = [&](auto x, auto y) {
        s.*x = grid.component(radial.*x, false);
        s.*y = grid.component(radial.*x, true);
    };
    turn(&Surface::tangential_traction_x, &Surface::tangential_traction_y);
    turn(&Surface::displacement_x, &Surface::displacement_y);
    turn(&Surface::slip_x, &Surface::slip_y);
    s.contact_state = grid.states(radial.contact_state);
    return s;
}

std::unique_ptr<contact::Model> ModelOfRevolution::sibling(
    const contact::Case::Contact& options) const {
    auto other = radial_->sibling(options);
    return other ? std::make_unique<ModelOfRevolution>(std::move(other), shear_modulus_) : nullptr;
}

}  // namespace tricontact::fem

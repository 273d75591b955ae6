#include "experiments/identification/identification_tables.h"

#include <algorithm>
#include <boost/math/interpolators/barycentric_rational.hpp>
#include <cmath>
#include <numbers>

#include "atlas/atlas.h"
#include "atlas/shipped.h"
#include "contact/models/model_kind.h"

namespace tricontact::experiments {

namespace {

using contact::Case;
using report::LazyTable;

// Of Poisson's ratio, where a table has rows of it, from 0 to 1/2.
constexpr double poisson_step = 0.025;
constexpr int last_poisson_row = 20;
// Steps of tables, for 1e-5 of the values: they are nearly powers of E, and coupling with friction
// changes them by a few percent at most.
constexpr double log_step = 0.2;
constexpr int last_row = 3;
constexpr double most_over_least = 3, most_at_least = 1;
// Places on a curve of shifts over the force, in s = (1 - f_T)^(1/3), Cattaneo's stick radius, in
// which it is smooth up to sliding. The last grid cells that stick make it rough.
constexpr int n_sampled_points = 9;
constexpr double least_stick_radius = 0.25;
constexpr int curve_order = 5;

std::vector<double> curve_points() {
    std::vector<double> s;  // Chebyshev's, increasing
    for (int j = n_sampled_points - 1; j >= 0; --j) {
        const double t = std::cos((2 * j + 1) * std::numbers::pi / (2 * n_sampled_points));
        s.push_back((1 + least_stick_radius) / 2 + (1 - least_stick_radius) / 2 * t);
    }
    return s;
}

std::vector<double> logarithms(std::vector<double> values) {
    for (double& value : values) value = std::log(value);
    return values;
}

double largest_ratio(const Case& rig, const std::vector<double>& forces) {
    return forces.empty() ? rig.friction_coefficient()
                          : std::ranges::max(forces) / *rig.load.normal_force;
}

/// The maps' is bounded; what is found beyond it is refused when it is run itself.
LoadAndFriction::Reach reach_of(const std::string& model) {
    if (!contact::model_kind(model).is_read()) return {};
    const auto* friction = atlas::shipped("sphere_layer_static").axis("friction.coefficient");
    return {friction->from, friction->to};
}

double unit_of(const Case& c, contact::NormalControl::Kind kind) {
    const double b = *c.layer.thickness, depth = b * b / c.indenter.radius;
    return kind == contact::NormalControl::Kind::indentation ? depth
                                                             : c.substrate.young * b * depth;
}

}  // namespace

LoadAndFriction::LoadAndFriction(const Case& rig, double least_friction, bool has_friction_rows,
                                 Reach reach)
    : radius_(rig.indenter.radius),
      thickness_(*rig.layer.thickness),
      least_(std::max(least_friction, reach.least)),
      most_(std::min(std::max(most_over_least * least_, most_at_least), reach.most)),
      has_rows_(has_friction_rows && least_ < most_) {}

LazyTable::Rows LoadAndFriction::rows() const {
    return {0, has_rows_ ? last_row : 0};
}

double LoadAndFriction::row_of(const Case& c) const {
    if (!has_rows_) return 0;
    const double friction = std::clamp(c.friction_coefficient(), least_, most_);
    return last_row * (1 / (1 + least_) - 1 / (1 + friction)) / z_range();
}

double LoadAndFriction::z_range() const {
    return 1 / (1 + least_) - 1 / (1 + most_);
}

double LoadAndFriction::friction_at(double row) const {
    return 1 / (1 / (1 + least_) - row / last_row * z_range()) - 1;
}

double LoadAndFriction::logarithm_of_load(const Case& c) const {
    return std::log(c.substrate.young * std::pow(lengths(c), 3) * radius_ / c.indenter.radius);
}

double LoadAndFriction::lengths(const Case& c) const {
    return *c.layer.thickness / thickness_;
}

double LoadAndFriction::heights(const Case& c) const {
    return lengths(c) * lengths(c) * radius_ / c.indenter.radius;
}

// Without coupling all shifts go with mu, so that one value of it does.
ShiftTable::ShiftTable(std::string model, const Case& rig, std::vector<double> forces,
                       bool by_theory, const contact::ModelRunner& runner)
    : model_(std::move(model)),
      rig_(rig),
      forces_(std::move(forces)),
      by_theory_(by_theory),
      runner_(runner),
      places_(curve_points()),
      axes_(rig_, largest_ratio(rig_, forces_), !by_theory && is_coupled(model_, rig_, runner_),
            reach_of(model_)),
      table_([this](double x, double row) { return node(std::exp(x), axes_.friction_at(row)); },
             log_step, 1, axes_.rows()) {}

std::vector<double> ShiftTable::at(const Case& c) {
    const double mu = c.friction_coefficient();
    const auto logs = table_.at(axes_.logarithm_of_load(c), axes_.row_of(c));
    const boost::math::barycentric_rational<double> curve(places_.data(), logs.data(),
                                                          places_.size(), curve_order);
    std::vector<double> shifts;
    for (const double force : forces_) {
        const double f = std::min(1., force / (mu * *rig_.load.normal_force));
        shifts.push_back(axes_.heights(c) * mu * f * std::exp(curve(std::cbrt(1 - f))));
    }
    return shifts;
}

std::vector<double> ShiftTable::node(double young, double friction) const {
    Case c = rig_;
    c.substrate.young = young;
    c.friction.coefficient = friction;
    std::vector<double> forces;
    for (const double s : places_)
        forces.push_back((1 - s * s * s) * friction * *c.load.normal_force);
    auto shifts =
        by_theory_ ? theory_shifts(true, c, forces) : static_shifts(model_, c, forces, runner_);
    for (std::size_t j = 0; j < shifts.size(); ++j) shifts[j] *= *c.load.normal_force / forces[j];
    return logarithms(std::move(shifts));
}

WobbleTable::WobbleTable(std::string model, const Case& rig, double amplitude,
                         const std::vector<double>& forces, const contact::ModelRunner& runner)
    : rig_(rig),
      axes_(rig_, largest_ratio(rig_, forces), !forces.empty(), {}),
      table_(
          [this, model = std::move(model), amplitude, runner, is_known = forces.empty()](
              double x, double row) {
              Case c = rig_;
              c.substrate.young = std::exp(x);
              if (!is_known) c.friction.coefficient = axes_.friction_at(row);
              return std::vector<double>{own_wobble(model, c, amplitude, runner)};
          },
          log_step, 1, axes_.rows()) {}

double WobbleTable::at(const Case& c) {
    // Heights over lengths. W/b is that of the table's rig: of twice the amplitude dU/dW is 0.5 %
    // smaller.
    return axes_.heights(c) / axes_.lengths(c) *
           table_.at(axes_.logarithm_of_load(c), axes_.row_of(c)).front();
}

PressTable::PressTable(std::string model, const Case& rig, bool has_poisson,
                       const contact::ModelRunner& runner)
    : model_(std::move(model)),
      rig_(rig),
      runner_(runner),
      has_poisson_(has_poisson),
      by_depth_(node(contact::NormalControl::Kind::indentation), log_step, 1, rows()),
      by_force_(node(contact::NormalControl::Kind::force), log_step, 1, rows()) {}

Pressed PressTable::at(const Case& c, const contact::NormalControl& control) {
    const bool is_depth = control.kind == contact::NormalControl::Kind::indentation;
    const double row = has_poisson_ ? c.substrate.poisson / poisson_step : 0;
    const auto logs = (is_depth ? by_depth_ : by_force_)
                          .at(std::log(control.value / unit_of(c, control.kind)), row);
    return {std::exp(logs[0]) * unit_of(c, contact::NormalControl::Kind::force),
            std::exp(logs[1]) * *c.layer.thickness,
            std::exp(logs[2]) * unit_of(c, contact::NormalControl::Kind::indentation)};
}

LazyTable::Rows PressTable::rows() const {
    return {0, has_poisson_ ? last_poisson_row : 0};
}

report::TableNode PressTable::node(contact::NormalControl::Kind kind) {
    return [this, kind](double x, double row) {
        Case c = rig_;
        if (has_poisson_) c.substrate.poisson = std::min(.5, row * poisson_step);
        const auto press =
            presses(model_, c, {{kind, std::exp(x) * unit_of(c, kind)}}, runner_).front();
        return logarithms(
            {press.normal_force / unit_of(c, contact::NormalControl::Kind::force),
             press.contact_radius / *c.layer.thickness,
             press.indentation / unit_of(c, contact::NormalControl::Kind::indentation)});
    };
}

}  // namespace tricontact::experiments

#include "mdr/layer_model.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "contact/error.h"
#include "contact/substrates/relaxing_substrate.h"
#include "mdr/line_surface.h"
#include "mdr/rolling_line.h"

namespace tricontact::mdr {

namespace {

// Of the contact solvers; each step solves dense systems to rounding.
constexpr double tolerance = 1e-9;

/// The plane profile as a body over a line of points.
class PlaneIndenter final : public contact::Indenter {
  public:
    explicit PlaneIndenter(std::shared_ptr<const PlaneProfile> profile)
        : profile_(std::move(profile)) {}
    double height(double x, double) const override { return profile_->value(x); }
    contact::Vector2 slope(double, double) const override {
        throw std::logic_error("mdr-layer: kinematics on a line are linear");
    }

  private:
    std::shared_ptr<const PlaneProfile> profile_;
};

std::unique_ptr<const contact::Substrate> substrate_of(
    std::shared_ptr<const LayerSprings> springs,
    const std::optional<contact::Relaxation>& relaxation) {
    if (!relaxation) return std::make_unique<contact::ElasticSubstrate>(std::move(springs));
    return std::make_unique<contact::RelaxingSubstrate>(std::move(springs), *relaxation);
}

}  // namespace

LayerModel::LayerModel(LayerData data)
    : springs_(std::move(data.springs)),
      profile_(std::move(data.profile)),
      friction_coefficient_(data.friction_coefficient),
      direction_{std::cos(data.rolling_angle), std::sin(data.rolling_angle)},
      model_(name(), *substrate_of(springs_, data.relaxation),
             std::make_shared<PlaneIndenter>(profile_), friction_coefficient_, tolerance) {}

contact::StepRecord LayerModel::advance(const contact::LoadStep& step) {
    check_on_line(name(), step);
    contact::LoadStep on_line = step;
    on_line.offset = {line_coordinate(name(), step.offset, direction_, springs_->row().spacing), 0};
    contact::StepRecord r = model_.advance(on_line);
    check_ends(on_line);
    r.offset = step.offset;
    auto disc = [](double area) {
        const double length = area / LayerSprings::width;
        return std::numbers::pi / 4 * length * length;
    };
    const double all = r.contact_area + r.open_area;
    r.contact_area = disc(r.contact_area);
    r.stick_area = disc(r.stick_area);
    r.slip_area = r.contact_area - r.stick_area;
    r.open_area = disc(all) - r.contact_area;
    return r;
}

void LayerModel::check_ends(const contact::LoadStep& step) const {
    const std::vector<double> pressure = model_.surface().normal_traction;
    if (pressure.front() > 0 || pressure.back() > 0)
        throw contact::ContactAtEdge(fmt::format(
            "mdr-layer: the contact reaches the last element at phase {:.4g}", step.phase));
    const PointRow& row = springs_->row();
    for (std::size_t i = 0; i < pressure.size(); ++i)
        if (pressure[i] > 0 &&
            std::abs(row.position(static_cast<int>(i)) - step.offset[0]) + row.spacing >
                profile_->range())
            throw contact::InputError(fmt::format(
                "mdr-layer: the contact reaches the rim of the indenter's profile at {:.6g} m; "
                "reduce the load or enlarge the indenter",
                profile_->range()));
}

contact::Scales LayerModel::scales() const {
    contact::Scales scales = model_.scales();
    const contact::Surface s = model_.surface();
    std::vector<double> load = s.normal_traction;
    for (double& q : load) q *= LayerSprings::width;
    const EvenLoad even =
        even_load(springs_->row(), load, s.offset[0], static_cast<int>(load.size()));
    scales.contact_radius = even.half_width();
    scales.peak_pressure = even.centre_pressure();
    return scales;
}

contact::Surface LayerModel::surface() const {
    const contact::Surface s = model_.surface();
    LineFields fields{.row = springs_->row(),
                      .position = s.offset[0],
                      .friction_coefficient = friction_coefficient_,
                      .displacement_x = s.displacement_x,
                      .displacement_z = s.displacement_z,
                      .gap = s.gap,
                      .slip_x = s.slip_x,
                      .contact_state = s.contact_state};
    for (std::size_t i = 0; i < s.gap.size(); ++i) {
        fields.normal_load.push_back(LayerSprings::width * s.normal_traction[i]);
        fields.tangential_load.push_back(LayerSprings::width * s.tangential_traction_x[i]);
        if (!std::isfinite(fields.gap[i])) fields.gap[i] = profile_->value(profile_->range());
    }
    return make_line_surface(fields);
}

}  // namespace tricontact::mdr

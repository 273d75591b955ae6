#include "mdr/layer_model.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <stdexcept>
#include <utility>

#include "contact/base/error.h"
#include "contact/base/memory.h"
#include "contact/base/special_values.h"
#include "contact/base/state_bytes.h"
#include "contact/load_path.h"
#include "contact/models/model_kind.h"
#include "contact/relaxing_case.h"
#include "contact/solvers/normal_solver.h"
#include "mdr/adhesive_model.h"
#include "mdr/bed.h"
#include "mdr/layer_wearing.h"
#include "mdr/line_surface.h"
#include "mdr/load_bound.h"
#include "mdr/settings.h"
#include "theory/layer/layer_stack.h"

// How many elements an MDR of the layer needs for a case.

namespace tricontact::mdr {

namespace {

// Of the contact solvers; each step solves dense systems to rounding.
constexpr double tolerance = contact::layer_springs_accuracy;

/// The plane profile as a body over a line of points.
class PlaneIndenter final : public contact::Indenter {
  public:
    explicit PlaneIndenter(std::shared_ptr<const PlaneProfile> profile)
        : profile_(std::move(profile)) {}
    double height(double x, double) const override { return profile_->value(x); }
    contact::Vector2 slope(double, double) const override {
        throw std::logic_error("mdr-layer: contact on a line asks for no slope");
    }

  private:
    std::shared_ptr<const PlaneProfile> profile_;
};

/// Another law than Coulomb's, as the elements see it: its points are all of them, its pressures
/// their line loads over LayerSprings::width.
class LineLaw final : public contact::FrictionLaw {
  public:
    LineLaw(const PointRow& row, LoadBound bound) : row_(row), bound_(std::move(bound)) {}
    void bounds(const Points& points, std::span<double> bound) const override {
        static_assert(LayerSprings::width == 1);
        bound_.bounds(row_, points.pressure, bound);
    }

  private:
    PointRow row_;
    LoadBound bound_;
};

std::shared_ptr<const contact::FrictionLaw> on_line(std::shared_ptr<const contact::FrictionLaw> law,
                                                    const LayerSprings& springs,
                                                    const PlaneProfile& profile, bool relaxes) {
    if (law->coulomb()) return law;
    // Beside the tip q falls as on the half-space: what the layer takes away has no kink there.
    const double slope =
        relaxes ? 0 : springs.effective_modulus() * profile.tip_slope(springs.row().spacing);
    return std::make_shared<LineLaw>(springs.row(), LoadBound(std::move(law), relaxes, slope));
}

std::unique_ptr<const contact::Substrate> substrate_of(
    std::shared_ptr<const LayerSprings> springs,
    const std::optional<contact::Relaxation>& relaxation) {
    if (!relaxation) return std::make_unique<contact::ElasticSubstrate>(std::move(springs));
    return std::make_unique<contact::RelaxingSubstrate>(std::move(springs), *relaxation);
}

constexpr int probe_elements = 25;  // in Hertz' radius
constexpr double first_margin = 1.1, enlargement = 1.25;
constexpr double final_margin = 1.05;
// In all, on either side: the matrix of 3 x 3 components then has 0.3 GB.
constexpr int most_elements_beside = 1000;

theory::LayerStack held_layers_of(const contact::Case& c) {
    theory::LayerStack stack = theory::layers_of(contact::models::mdr_layer, c);
    if (stack.base == theory::LayerBase::frictionless)
        throw contact::InputError(
            "mdr-layer: nothing holds a layer on a frictionless base against a tangential force; "
            "take base = \"bonded\" or another model");
    return stack;
}

/// The springs of a model: of the layer, or of the half-space.
std::shared_ptr<const LayerSprings> springs_of(const std::string& model, const contact::Case& c,
                                               double half_length, double spacing) {
    const bool on_layer = contact::model_kind(model).is_layer();
    const double beside = std::ceil(half_length / spacing);
    const std::string instead = std::string("shorten the rolling path or take ") +
                                (on_layer ? contact::models::bem_layer : contact::models::bem);
    if (beside > most_elements_beside)
        throw contact::InputError(
            fmt::format("{}: the bed would have {:.0f} elements, more than {}; {}", model,
                        2 * beside + 1, 2 * most_elements_beside + 1, instead));
    // Matrices of 3 x 3 components: of all elements, and of those in contact.
    const double n = 2 * beside + 1;
    contact::require_memory(fmt::format("{}: a bed of {:.0f} elements", model, n),
                            2 * 9 * sizeof(double) * n * n, instead);
    if (!on_layer)
        return std::make_shared<LayerSprings>(c.materials(), static_cast<int>(beside), spacing,
                                              c.interface);
    return std::make_shared<LayerSprings>(held_layers_of(c), c.indenter.material,
                                          static_cast<int>(beside), spacing, c.interface);
}

/// Half width of the contact [m]; infinite if it reaches the last element.
double half_width(const LayerSprings& springs, const PlaneProfile& profile,
                  const contact::NormalControl& control) {
    const PointRow& row = springs.row();
    std::vector<double> height;
    for (const double x : springs.points().x) height.push_back(profile.value(x));
    const auto pressure = contact::NormalSolver(springs, 1e-6).solve(height, control).pressure;
    if (pressure.front() > 0) return contact::infinity;
    return even_load(row, pressure, 0, static_cast<int>(pressure.size())).half_width();
}

struct HalfWidths {
    double mean, largest;  // [m], under the case's normal control and under its crest
};

HalfWidths probe(const std::string& model, const contact::Case& c, const PlaneProfile& profile,
                 double longest) {
    const double radius = contact::half_space_scales(c).contact_radius;
    const double crest = contact::crest_factor(c);
    const double spacing = std::min(radius / probe_elements, longest);
    const contact::NormalControl mean = contact::press_step(c).normal;
    contact::NormalControl hardest = mean;
    hardest.value *= crest;
    for (double half = first_margin * radius * std::sqrt(crest);; half *= enlargement) {
        const auto springs = springs_of(model, c, half, spacing);
        const double largest = half_width(*springs, profile, hardest);
        if (std::isfinite(largest)) return {half_width(*springs, profile, mean), largest};
    }
}

/// Of tractions [Pa] on the elements [N/m].
std::vector<double> line_load(std::vector<double> traction) {
    for (double& q : traction) q *= LayerSprings::width;
    return traction;
}

}  // namespace

LayerModel::LayerModel(std::string name, std::shared_ptr<const LayerSprings> springs,
                       std::shared_ptr<const PlaneProfile> profile,
                       std::shared_ptr<const contact::FrictionLaw> friction, double rolling_angle,
                       const std::optional<contact::Relaxation>& relaxation)
    : springs_(std::move(springs)),
      profile_(std::move(profile)),
      friction_(std::move(friction)),
      line_law_(on_line(friction_, *springs_, *profile_, relaxation.has_value())),
      direction_{std::cos(rolling_angle), std::sin(rolling_angle)},
      model_(std::move(name), *substrate_of(springs_, relaxation),
             std::make_shared<PlaneIndenter>(profile_), line_law_, tolerance) {}

contact::StepRecord LayerModel::advance(const contact::LoadStep& step) {
    contact::LoadStep on_line = step;
    on_line.offset = {position_on_line(name(), step, direction_, springs_->row().spacing), 0};
    contact::StepRecord r = model_.advance(on_line);
    check_ends(on_line);
    if (!least_bounds_.empty()) {
        const std::vector<double> now = line_bounds();
        for (std::size_t i = 0; i < now.size(); ++i)
            least_bounds_[i] = std::min(least_bounds_[i], now[i]);
    }
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

std::vector<double> LayerModel::line_bounds() const {
    const std::vector<double> load = model_.surface().normal_traction;
    std::vector<double> bound(load.size());
    line_law_->bounds({load}, bound);
    return bound;
}

void LayerModel::start_limit() {
    model_.start_limit();
    if (friction_->coulomb()) return;
    least_bounds_ = line_bounds();
    bound_at_start_ = std::accumulate(least_bounds_.begin(), least_bounds_.end(), 0.);
}

double LayerModel::limit_tangential_ratio() const {
    if (least_bounds_.empty()) return model_.limit_tangential_ratio();
    return std::accumulate(least_bounds_.begin(), least_bounds_.end(), 0.) / bound_at_start_;
}

std::unique_ptr<contact::WearingContact> LayerModel::wearing(const contact::WearProblem& problem) {
    const auto friction = friction_->coulomb();
    if (!friction || !longer_)
        throw contact::InputError("[wear]: " + name() + " wears under Coulomb's law; take bem");
    model_.set_larger_grid([this](const contact::ContactAtEdge&) {
        constexpr double longer = 1.5;
        springs_ = longer_(-longer * springs_->row().first);
        return std::make_unique<contact::ElasticSubstrate>(springs_);
    });
    return std::make_unique<LayerWearing>(*this, model_.wearing(problem), problem, *friction);
}

double LayerModel::shear_energy() const {
    const contact::Surface s = model_.surface();
    double work = 0;
    for (std::size_t i = 0; i < s.gap.size(); ++i)
        work += s.tangential_traction_x[i] * s.displacement_x[i];
    return springs_->row().spacing * LayerSprings::width * work / 2;
}

std::string LayerModel::write_state() const {
    contact::StateWriter out;
    out(least_bounds_, bound_at_start_, model_.write_state());
    return out.take();
}

void LayerModel::read_state(std::string_view bytes) {
    std::string state;
    contact::StateReader in(bytes);
    in(least_bounds_, bound_at_start_, state);
    model_.read_state(state);
}

void LayerModel::check_ends(const contact::LoadStep& step) const {
    const std::vector<double> pressure = model_.surface().normal_traction;
    if (pressure.front() > 0 || pressure.back() > 0)
        throw contact::ContactAtEdge(fmt::format(
            "{}: the contact reaches the last element at phase {:.4g}", name(), step.phase));
    const PointRow& row = springs_->row();
    for (std::size_t i = 0; i < pressure.size(); ++i)
        if (pressure[i] > 0 &&
            std::abs(row.position(static_cast<int>(i)) - step.offset[0]) + row.spacing >
                profile_->range())
            throw contact::InputError(fmt::format(
                "{}: the contact reaches the rim of the indenter's profile at {:.6g} m; "
                "reduce the load or enlarge the indenter",
                name(), profile_->range()));
}

contact::Scales LayerModel::scales() const {
    contact::Scales scales = model_.scales();
    const contact::Surface s = model_.surface();
    const std::vector<double> load = line_load(s.normal_traction);
    const EvenLoad even =
        even_load(springs_->row(), load, s.offset[0], static_cast<int>(load.size()));
    scales.contact_radius = even.half_width();
    scales.peak_pressure = even.centre_pressure();
    return scales;
}

contact::Surface LayerModel::surface() const {
    const contact::Surface s = model_.surface();
    const PointRow& row = springs_->row();
    const auto normal = line_load(s.normal_traction), along = line_load(s.tangential_traction_x);
    return make_line_surface(
        row, static_cast<int>(s.gap.size()), s.offset[0], *friction_,
        even_loads(row, normal, along, s.offset[0]), [&](int i, int k, contact::Surface& shown) {
            shown.contact_state[k] = s.contact_state[i];
            shown.displacement_x[k] = s.displacement_x[i];
            shown.displacement_z[k] = s.displacement_z[i];
            shown.gap[k] = std::isfinite(s.gap[i]) ? s.gap[i] : profile_->value(profile_->range());
            shown.slip_x[k] = s.slip_x[i];
            shown.normal_line_load[k] = normal[i];
            shown.tangential_line_load[k] = along[i];
        });
}

std::unique_ptr<contact::Model> make_layer_model(const contact::Case& c) {
    return make_layer_model(c, c.of<Settings>().elements_per_radius);
}

namespace {

/// `longest`: of elements [m], infinite where nothing bounds them.
std::unique_ptr<contact::Model> make_line_model(const std::string& model, const contact::Case& c,
                                                int elements_per_radius, double longest) {
    // At the same depth the contact on a thin layer is at most some 2 (paraboloid) to 2.4 times
    // (cone) as wide as on the half-space: that of an incompressible layer, which keeps its volume.
    const bool wears = c.kept.find<contact::Wear>() != nullptr;
    const double table =
        (wears ? 6 : 3) * contact::crest_factor(c) * contact::half_space_scales(c).contact_radius;
    const std::shared_ptr<const PlaneProfile> profile =
        make_plane_profile(*c.make_axisymmetric_indenter(), table);
    const HalfWidths a = probe(model, c, *profile, longest);
    const double path = contact::norm(contact::path_reach(c, a.mean));
    constexpr double usual = Settings{}.elements_per_radius;
    const double spacing = usual / elements_per_radius * std::min(a.mean / usual, longest);
    if (spacing > (1 + 1e-12) * longest)  // rounding
        throw contact::InputError(fmt::format(
            "mdr-layer: {} elements in the contact radius would not resolve the layer's thickness; "
            "increase mdr.elements_per_radius",
            elements_per_radius));
    // Where all but a disc wears, contact ends where the new body was d high: sqrt(2) a of a
    // paraboloid on the half-space, at most.
    const double margin = wears ? std::numbers::sqrt2 * final_margin : final_margin;
    auto made = std::make_unique<LayerModel>(
        model, springs_of(model, c, margin * a.largest + path, spacing), profile, c.friction.law(),
        contact::path_direction(c), contact::common_relaxation(model, c));
    if (wears)
        made->set_longer_line([=](double half) { return springs_of(model, c, half, spacing); });
    return made;
}

}  // namespace

std::unique_ptr<contact::Model> make_layer_model(const contact::Case& c, int elements_per_radius) {
    held_layers_of(c);  // throws before anything else does
    if (c.adhesion) {
        contact::Case with = c;
        with.of<Settings>().elements_per_radius = elements_per_radius;
        return make_adhesive_model(
            contact::models::mdr_layer, with,
            [](const contact::Case& plain) { return make_layer_model(plain); });
    }
    return make_line_model(contact::models::mdr_layer, c, elements_per_radius,
                           LayerSprings::longest_element * *c.layer.thickness);
}

std::unique_ptr<contact::Model> make_model_on_interface(const contact::Case& c) {
    return make_line_model(contact::models::mdr, contact::without_layer(c),
                           c.of<Settings>().elements_per_radius, contact::infinity);
}

}  // namespace tricontact::mdr

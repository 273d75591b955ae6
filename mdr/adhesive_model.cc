#include "mdr/adhesive_model.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "contact/base/error.h"
#include "contact/base/state_bytes.h"
#include "contact/models/model_kind.h"
#include "mdr/settings.h"

namespace tricontact::mdr {

namespace {

using contact::Case;
using contact::LoadStep;
using contact::NormalControl;
using contact::Surface;
using std::numbers::pi;
using theory::AdhesiveCurve;

// Nodes of the curve are 1.5 % of the radius apart: by the trapezoidal rule the work is right to
// 1e-4 of what is stored.
constexpr double allowed_imbalance = 1e-3;

void check_presses(const LoadStep& step) {
    const bool moves =
        step.offset != contact::Vector2{} || step.rotation != 0 ||
        std::ranges::any_of(step.tangential, [](const auto& one) { return one.value != 0; });
    if (moves)
        throw contact::InputError(
            "mdr: surfaces that attract each other are pressed and pulled along the normal alone; "
            "set tangential loads, shifts and offsets to zero");
}

/// Radius [m] where the profile is as high as an edge would be stretched: of the order of that
/// which touches at d = 0.
double radius_of_touch(const PlaneProfile& profile, double modulus, double work) {
    double a = work / modulus;
    while (2 * a < profile.range() && profile.value(a) < std::sqrt(2 * pi * a * work / modulus))
        a *= 2;
    return a;
}

struct Parts {
    std::shared_ptr<const PlaneProfile> profile;
    std::unique_ptr<const DiscSprings> springs;
    std::optional<AdhesiveCurve> curve;
};

Parts parts_of(const std::string& model, const Case& c, double range) {
    Parts parts;
    parts.profile = make_plane_profile(*c.make_axisymmetric_indenter(), range);
    const auto& settings = c.of<Settings>();
    if (contact::model_kind(model).is_layer())
        parts.springs =
            std::make_unique<LayerDiscSprings>(parts.profile, theory::layers_of(model, c),
                                               c.indenter.material, settings.elements_per_radius);
    else
        parts.springs = std::make_unique<FreeDiscSprings>(
            parts.profile, c.materials().effective_modulus(), settings.springs);
    const double modulus = parts.springs->modulus(), work = c.adhesion->work;
    parts.curve.emplace([springs = parts.springs.get()](double a) { return springs->at(a); },
                        modulus, work, radius_of_touch(*parts.profile, modulus, work),
                        parts.profile->range());
    return parts;
}

}  // namespace

AdhesiveModel::AdhesiveModel(std::string name, std::unique_ptr<const DiscSprings> springs,
                             std::shared_ptr<const PlaneProfile> profile,
                             std::shared_ptr<const contact::FrictionLaw> friction,
                             double shear_modulus, AdhesiveCurve curve, int n_points,
                             double half_length)
    : name_(std::move(name)),
      springs_(std::move(springs)),
      profile_(std::move(profile)),
      friction_(std::move(friction)),
      shear_modulus_(shear_modulus),
      curve_(std::move(curve)),
      pull_off_(curve_.pull_off()),
      row_{half_length / n_points - half_length, 2 * half_length / n_points},
      n_points_(n_points) {}

contact::StepRecord AdhesiveModel::advance(const LoadStep& step) {
    check_presses(step);
    const auto before = state_;
    const AdhesiveCurve::Motion motion = curve_.follow(state_, step.normal);
    state_ = motion.state;
    audit_step(motion, before);
    contact::StepRecord r;
    r.phase = step.phase;
    r.normal_force = state_.force;
    r.indentation = state_.indentation;
    r.stored_energy = state_.energy;
    r.released_energy = motion.released;
    // Apart the bodies may stay as long as nothing presses them, in contact until it lets go.
    const double last = step.normal.kind == NormalControl::Kind::force ? -pull_off_.force
                                                                       : pull_off_.last_indentation;
    r.may_differ = step.normal.value < 0 && step.normal.value > last;
    r.contact_area = r.stick_area = pi * state_.radius * state_.radius;
    const double half_length = row_.spacing * n_points_ / 2;
    r.open_area = std::max(0., pi * half_length * half_length - r.contact_area);
    return r;
}

void AdhesiveModel::audit_step(const AdhesiveCurve::Motion& motion,
                               const AdhesiveCurve::State& before) {
    const auto size = [&](const AdhesiveCurve::State& s) {
        return s.energy + curve_.work_of_adhesion() * pi * s.radius * s.radius;
    };
    const double all = std::max(size(before), size(state_));
    if (all == 0) return;
    const double stored = curve_.stored(state_) - curve_.stored(before);
    audit_.record("energy_balance", std::abs(motion.work - stored - motion.released) / all,
                  allowed_imbalance);
}

contact::Scales AdhesiveModel::scales() const {
    const EvenLoads even = loads();
    return {.normal_force = state_.force,
            .contact_radius = state_.radius,
            .indentation = state_.indentation,
            .peak_pressure = EvenLoad{even.positions, even.normal}.centre_pressure(),
            .unit_shift = friction_->ratio_at(springs_->modulus()) * springs_->modulus() /
                          shear_modulus_ * std::abs(state_.indentation),
            .sliding_force = friction_->limit({state_.force, contact::infinity})};
}

/// From the middle to the edge, where the load ends within 1e-6 of the radius.
EvenLoads AdhesiveModel::loads() const {
    constexpr double beside_edge = 1 - 1e-6;
    if (!state_.touches()) return {{0, row_.spacing}, {0, 0}, {0, 0}};
    const std::vector<double> q = springs_->loads(state_.radius, state_.indentation);
    const double spacing = state_.radius / static_cast<double>(q.size());
    const std::size_t stride = (q.size() + most_surface_pieces - 1) / most_surface_pieces;
    EvenLoads even{{0}, {q.front()}, {}};
    for (std::size_t i = 0; i < q.size(); i += stride) {
        even.positions.push_back((static_cast<double>(i) + .5) * spacing);
        even.normal.push_back(q[i]);
    }
    even.positions.push_back(beside_edge * state_.radius);
    even.normal.push_back(-springs_->modulus() * springs_->at(state_.radius).edge *
                          state_.detached);
    even.positions.push_back(state_.radius);
    even.normal.push_back(0);
    even.tangential.assign(even.positions.size(), 0);
    return even;
}

Surface AdhesiveModel::surface() const {
    const EvenLoads even = loads();
    const auto load_at = [&](double x) {
        const auto above = std::ranges::upper_bound(even.positions, x);
        if (above == even.positions.begin() || above == even.positions.end()) return 0.;
        const auto k = static_cast<std::size_t>(above - even.positions.begin());
        const double share =
            (x - even.positions[k - 1]) / (even.positions[k] - even.positions[k - 1]);
        return std::lerp(even.normal[k - 1], even.normal[k], share);
    };
    return make_line_surface(row_, n_points_, 0, *friction_, even, [&](int, int k, Surface& s) {
        const double x = std::abs(s.x(k));
        const double height = profile_->value(std::min(x, profile_->range()));
        if (!(x < state_.radius)) {
            s.gap[k] = std::max(0., height - state_.indentation);
            return;
        }
        s.contact_state[k] = contact::ContactState::stick;
        s.displacement_z[k] = state_.indentation - height;
        s.normal_line_load[k] = load_at(x);
    });
}

std::string AdhesiveModel::write_state() const {
    contact::StateWriter out;
    out(state_.radius, state_.indentation, state_.force, state_.energy, state_.detached);
    audit_.write(out);
    return out.take();
}

void AdhesiveModel::read_state(std::string_view bytes) {
    contact::StateReader in(bytes);
    in(state_.radius, state_.indentation, state_.force, state_.energy, state_.detached);
    audit_.read(in);
}

std::unique_ptr<contact::Model> make_adhesive_model(const std::string& model, const Case& c) {
    const NormalControl hardest = contact::press_step(c).normal;
    const double outer = c.make_axisymmetric_indenter()->outer_radius();
    // A table of the profile as wide as is needed, up to the rim.
    double range = std::min(outer, 3 * contact::half_space_scales(c).contact_radius);
    Parts parts = parts_of(model, c, range);
    while (!parts.curve->reaches(hardest) && range < outer)
        parts = parts_of(model, c, range = std::min(outer, 2 * range));
    const AdhesiveCurve::State pressed = parts.curve->follow({}, hardest).state;
    constexpr double shown = 1.5;  // over the widest contact
    return std::make_unique<AdhesiveModel>(
        model, std::move(parts.springs), std::move(parts.profile), c.friction.law(),
        c.materials().effective_shear_modulus(), std::move(*parts.curve), most_surface_points,
        shown * pressed.radius);
}

}  // namespace tricontact::mdr

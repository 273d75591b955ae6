#include "mdr/adhesive_model.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "contact/base/between_rows.h"
#include "contact/base/error.h"
#include "contact/base/state_bytes.h"
#include "contact/models/model_kind.h"
#include "mdr/settings.h"
#include "theory/adhesive/dugdale_contacts.h"

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
            "set tangential loads, shifts and offsets to zero, or give friction.shear_strength "
            "alone");
}

/// Radius [m] where the profile is as high as an edge would be stretched: of the order of that
/// which touches at d = 0.
double radius_of_touch(const PlaneProfile& profile, double modulus, double work) {
    double a = work / modulus;
    while (2 * a < profile.range() && profile.value(a) < std::sqrt(2 * pi * a * work / modulus))
        a *= 2;
    return a;
}

using Parts = AdhesiveModel::Parts;

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
    if (!c.adhesion->is_short_ranged()) {
        const double guess = radius_of_touch(*parts.profile, modulus, work);
        parts.curve.emplace(theory::AdhesiveCurve(
            theory::dugdale_contacts(
                [springs = parts.springs.get()](double a) { return springs->at(a); },
                [profile = parts.profile](double x) { return profile->value(x); }, modulus,
                {c.adhesion->strength(), c.adhesion->distance()}),
            modulus, work, c.adhesion->distance(), guess, parts.profile->range()));
        return parts;
    }
    parts.curve.emplace([springs = parts.springs.get()](double a) { return springs->at(a); },
                        modulus, work, c.adhesion->approach_work.value_or(work),
                        radius_of_touch(*parts.profile, modulus, work), parts.profile->range());
    return parts;
}

/// The case of the tangential contact, whose normal contact has the radius that is prescribed by
/// its depth. `hardest` [m]: its largest depth, `amplitude` [m]: of the rolling.
Case without_attraction(const Case& c, double hardest, double amplitude) {
    Case plain = c;
    plain.adhesion.reset();
    plain.load.normal_force.reset();
    plain.load.indentation = hardest;
    plain.load.normal_amplitude_ratio = 0;
    if (plain.rolling) {
        plain.rolling->amplitude_ratio.reset();
        plain.rolling->amplitude = amplitude;
    }
    return plain;
}

}  // namespace

AdhesiveModel::AdhesiveModel(std::string name, Parts parts,
                             std::shared_ptr<const contact::FrictionLaw> friction,
                             double shear_modulus, std::optional<AdhesiveFriction> sliding,
                             int n_points, double half_length)
    : name_(std::move(name)),
      parts_(std::move(parts)),
      friction_(std::move(friction)),
      shear_modulus_(shear_modulus),
      sliding_(std::move(sliding)),
      row_{half_length / n_points - half_length, 2 * half_length / n_points},
      n_points_(n_points) {
    pull_off_ = parts_.curve->pull_off(half_length);
}

contact::StepRecord AdhesiveModel::advance(const LoadStep& step) {
    if (!sliding_) check_presses(step);
    const auto before = state_;
    const AdhesiveCurve::Motion motion = parts_.curve->follow(state_, step.normal);
    state_ = motion.state;
    audit_step(motion, before);
    if (!parts_.curve->is_reversible() && state_.radius > widest_) {
        widest_ = state_.radius;
        pull_off_ = parts_.curve->pull_off(widest_);
    }
    contact::StepRecord r;
    r.phase = step.phase;
    r.normal_force = state_.force;
    r.indentation = state_.indentation;
    r.stored_energy = state_.energy;
    r.released_energy = motion.released;
    // Apart the bodies may stay as long as nothing presses them, in contact until it lets go; where
    // the edge stays in its place, it may do so in another.
    const double last = step.normal.kind == NormalControl::Kind::force ? -pull_off_.force
                                                                       : pull_off_.last_indentation;
    const bool has_range = state_.reach > state_.radius;
    r.may_differ = has_range ? parts_.curve->stable_states(step.normal) > 1
                             : (step.normal.value < 0 && step.normal.value > last) ||
                                   (!parts_.curve->is_reversible() && state_.touches());
    r.contact_area = r.stick_area = pi * state_.radius * state_.radius;
    const double half_length = row_.spacing * n_points_ / 2;
    r.open_area = std::max(0., pi * half_length * half_length - r.contact_area);
    if (!sliding_) return r;
    if (state_.touches())
        sliding_->advance(step, parts_.springs->at(state_.radius).indentation, r, audit_);
    else
        sliding_->let_go(step, r);
    return r;
}

void AdhesiveModel::audit_step(const AdhesiveCurve::Motion& motion,
                               const AdhesiveCurve::State& before) {
    const auto size = [&](const AdhesiveCurve::State& s) { return s.energy - s.attraction; };
    const double all = std::max(size(before), size(state_));
    if (all == 0) return;
    const double stored = parts_.curve->stored(state_) - parts_.curve->stored(before);
    audit_.record("energy_balance", std::abs(motion.work - stored - motion.released) / all,
                  allowed_imbalance);
}

contact::Scales AdhesiveModel::scales() const {
    const EvenLoads even = loads();
    contact::Scales scales{
        .normal_force = state_.force,
        .contact_radius = state_.radius,
        .indentation = state_.indentation,
        .peak_pressure = EvenLoad{even.positions, even.normal}.centre_pressure()};
    if (sliding_ && state_.touches()) {
        const contact::Scales along = sliding_->model().scales();
        scales.unit_shift = along.unit_shift;
        scales.sliding_force = along.sliding_force;
        return scales;
    }
    const double modulus = parts_.springs->modulus();
    scales.unit_shift =
        friction_->ratio_at(modulus) * modulus / shear_modulus_ * std::abs(state_.indentation);
    scales.sliding_force = friction_->limit({state_.force, contact::infinity});
    return scales;
}

/// From the middle to the edge, where the load ends within 1e-6 of the radius.
EvenLoads AdhesiveModel::loads() const {
    constexpr double beside_edge = 1 - 1e-6;
    if (!(state_.reach > 0)) return {{0, row_.spacing}, {0, 0}, {0, 0}};
    if (!state_.touches()) return with_ring({{}, {}, {}});
    const std::vector<double> q = parts_.springs->loads(state_.radius, state_.indentation);
    const double spacing = state_.radius / static_cast<double>(q.size());
    const std::size_t stride = (q.size() + most_surface_pieces - 1) / most_surface_pieces;
    EvenLoads even{{0}, {q.front()}, {}};
    for (std::size_t i = 0; i < q.size(); i += stride) {
        even.positions.push_back((static_cast<double>(i) + .5) * spacing);
        even.normal.push_back(q[i]);
    }
    if (state_.reach > state_.radius) return with_ring(std::move(even));
    even.positions.push_back(beside_edge * state_.radius);
    even.normal.push_back(-parts_.springs->modulus() * parts_.springs->at(state_.radius).edge *
                          state_.detached);
    even.positions.push_back(state_.radius);
    even.normal.push_back(0);
    even.tangential.assign(even.positions.size(), 0);
    return even;
}

/// With what a tension that reaches beyond the contact stretches the springs by there.
EvenLoads AdhesiveModel::with_ring(EvenLoads even) const {
    constexpr int n = 200;
    const double a = state_.radius, c = state_.reach,
                 pull = state_.detached * parts_.springs->modulus() / std::sqrt((c - a) * (c + a));
    for (int i = 0; i <= n; ++i) {
        // Closer together where the root falls to 0.
        const double way = 1 - static_cast<double>(n - i) / n * (n - i) / n;
        const double x = i == n ? c : std::lerp(a, c, way);
        even.positions.push_back(x);
        even.normal.push_back(-pull * std::sqrt(std::max(0., c * c - x * x)));
    }
    even.tangential.assign(even.positions.size(), 0);
    return even;
}

void AdhesiveModel::show_normal(const EvenLoads& even, int point, Surface& s) const {
    const double x = std::abs(s.x(point) - s.offset[0]);
    const double height = parts_.profile->value(std::min(x, parts_.profile->range()));
    if (!(x < state_.radius)) {
        s.gap[point] = std::max(0., height - state_.indentation);
        if (x < state_.reach)
            s.normal_line_load[point] = contact::between_rows(even.positions, even.normal, x);
        return;
    }
    s.gap[point] = 0;
    s.displacement_z[point] = state_.indentation - height;
    if (x < even.positions.front() || !(x < even.positions.back())) return;
    s.normal_line_load[point] = contact::between_rows(even.positions, even.normal, x);
}

Surface AdhesiveModel::surface() const {
    const EvenLoads even = loads();
    if (!sliding_ || !state_.touches())
        return make_line_surface(row_, n_points_, 0, *friction_, even, [&](int, int k, Surface& s) {
            show_normal(even, k, s);
            if (std::abs(s.x(k)) < state_.radius) s.contact_state[k] = contact::ContactState::stick;
        });
    Surface s = sliding_->model().surface();
    for (auto* field : {&s.normal_line_load, &s.normal_traction, &s.displacement_z})
        std::ranges::fill(*field, 0);
    const std::vector<double> slopes = slopes_of(even.positions, even.normal);
    for (int k = 0; k < s.n_x; ++k) {
        show_normal(even, k, s);
        const double r = std::abs(s.x(k) - s.offset[0]);
        if (r < even.positions.back())
            s.normal_traction[k] = back_transform(slopes, abel_weights(even.positions, r));
    }
    return s;
}

template <class Archive, class Self>
void AdhesiveModel::transfer(Archive& archive, Self& model) {
    auto& s = model.state_;
    archive(s.place, s.radius, s.reach, s.indentation, s.force, s.energy, s.attraction, s.detached,
            model.widest_);
}

std::string AdhesiveModel::write_state() const {
    contact::StateWriter out;
    transfer(out, *this);
    audit_.write(out);
    out(sliding_ ? sliding_->model().write_state() : std::string());
    return out.take();
}

void AdhesiveModel::read_state(std::string_view bytes) {
    contact::StateReader in(bytes);
    transfer(in, *this);
    audit_.read(in);
    std::string along;
    in(along);
    if (widest_ > 0) pull_off_ = parts_.curve->pull_off(widest_);
    if (sliding_) sliding_->model().read_state(along);
}

std::unique_ptr<contact::Model> make_adhesive_model(
    const std::string& model, const Case& c,
    const std::function<std::unique_ptr<contact::Model>(const Case&)>& unattracted) {
    NormalControl mean = contact::press_step(c).normal, hardest = mean;
    hardest.value *= contact::crest_factor(c);
    const double outer = c.make_axisymmetric_indenter()->outer_radius();
    // A table of the profile as wide as is needed, up to the rim.
    double range = std::min(outer, 3 * contact::half_space_scales(c).contact_radius);
    Parts parts = parts_of(model, c, range);
    while (!parts.curve->reaches(hardest) && range < outer)
        parts = parts_of(model, c, range = std::min(outer, 2 * range));
    const AdhesiveCurve::State pressed = parts.curve->follow({}, hardest).state;
    std::optional<AdhesiveFriction> sliding;
    if (c.friction.is_strength_alone() && pressed.touches()) {
        const double radius = parts.curve->follow({}, mean).state.radius;
        sliding.emplace(unattracted(without_attraction(
            c, parts.springs->at(pressed.radius).indentation, contact::path_amplitude(c, radius))));
    }
    constexpr double shown = 1.5;  // over the widest contact
    return std::make_unique<AdhesiveModel>(
        model, std::move(parts), c.friction.law(), c.materials().effective_shear_modulus(),
        std::move(sliding), most_surface_points, shown * pressed.reach);
}

}  // namespace tricontact::mdr

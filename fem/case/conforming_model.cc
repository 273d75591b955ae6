#include "fem/case/conforming_model.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "contact/base/error.h"
#include "contact/base/state_bytes.h"
#include "fem/case/conforming_friction.h"

namespace tricontact::fem {

namespace {

using contact::Surface;

void refuse_motion(const contact::LoadStep& step) {
    const bool pulled = std::ranges::any_of(step.tangential,
                                            [](const auto& control) { return control.value != 0; });
    if (pulled || contact::norm(step.offset) != 0 || step.rotation != 0)
        throw contact::InputError(
            "load: a pin in a hole is pressed where it is, without a load along the surface");
}

/// The line a + b x by least squares: its zero. Needs two x at least, and b != 0.
double zero_of_line(const std::vector<std::array<double, 2>>& points) {
    double n = 0, x = 0, y = 0, xx = 0, xy = 0;
    for (const auto& [at, value] : points) {
        n += 1;
        x += at;
        y += value;
        xx += at * at;
        xy += at * value;
    }
    const double slope = (n * xy - x * y) / (n * xx - x * x);
    return (x - y / slope) / n;
}

/// Where a pressure whose square is smooth at the edge ends [m]. The square is taken over the
/// distance from the middle: p^2/(e + x) is about linear towards the edge e. `spacing` of points,
/// by whose half the last one that carries is off.
double edge_of(const Surface& s, double spacing) {
    double last = 0;
    for (std::size_t i = 0; i < s.size(); ++i)
        if (s.normal_traction[i] > 0) last = std::max(last, std::abs(s.x(static_cast<int>(i))));
    constexpr double outer = .75;  // of the contact, from which on points count
    constexpr int most_rounds = 20;
    double edge = last + spacing / 2;
    for (int round = 0; round < most_rounds; ++round) {
        std::vector<std::array<double, 2>> points;
        for (std::size_t i = 0; i < s.size(); ++i) {
            const double x = std::abs(s.x(static_cast<int>(i))), p = s.normal_traction[i];
            // The last point carries the mean of a pressure that ends beside it.
            if (p > 0 && x > outer * last && x < last - spacing / 2)
                points.push_back({x, p * p / (edge + x)});
        }
        if (points.size() < 4) return edge;
        const double next = zero_of_line(points);
        if (!(next > last - spacing) || !(next < last + 2 * spacing)) return edge;
        if (std::abs(next - edge) < 1e-12 * last) return next;
        edge = next;
    }
    return edge;
}

/// What jams a pin: points from `angle` on with mu tan(theta) >= 1, of contact to `edge` [rad].
struct Jam {
    double angle = 0, edge = 0;
    bool is_there() const { return angle < edge; }
};
/// Of the surface along the radius.
Jam jam_of(const Surface& s, double radius) {
    Jam jam{.angle = std::numbers::pi / 2};
    for (std::size_t i = 0; i < s.size(); ++i) {
        const double p = s.normal_traction[i], angle = std::abs(s.x(static_cast<int>(i))) / radius;
        if (!(p > 0)) continue;
        jam.edge = std::max(jam.edge, angle);
        const double bound = s.friction_bound.empty() ? 0 : s.friction_bound[i];
        if (bound > 0) jam.angle = std::min(jam.angle, std::atan(p / bound));
    }
    return jam;
}

}  // namespace

void ConformingModel::refuse_jam() const {
    const Jam jam = jam_of(surface(), radius_);
    if (!jam.is_there()) return;
    constexpr double degrees = 180 / std::numbers::pi;
    throw contact::InputError(fmt::format(
        "{}: the pin is taken back where it jams: mu tan(theta) is above 1 from {:.3g} degrees on, "
        "the contact reaches {:.3g}, and Coulomb's law does not say what it then carries; press it "
        "alone, or lower friction.coefficient below {:.3g}",
        name(), degrees * jam.angle, degrees * jam.edge, 1 / std::tan(jam.edge)));
}

// Unlike flat contacts, whose pressures and tractions hardly move one another, these do by
// tan(theta), and their iteration need not end.
contact::StepRecord ConformingModel::press(const contact::LoadStep& step) {
    try {
        return along_z_->advance(step);
    } catch (const contact::NotConverged& error) {
        throw contact::NotConverged(
            std::string(error.what()) +
            "; where a contact closes far around a pin, pressures and tractions move one another "
            "by tan(theta): press in more steps (load.press_steps), lower "
            "friction.coefficient or the load, or without friction (contact.coupling = false)");
    }
}

contact::StepRecord ConformingModel::advance(const contact::LoadStep& step) {
    refuse_motion(step);
    if (!is_coupled()) return along_z_->advance(step);
    // Where all slips no force along x tells where the pin is: it is in the middle.
    contact::LoadStep held = step;
    held.tangential[0] = {contact::TangentialControl::Kind::shift, 0};
    if (last_ && held.normal.value < last_->of(held.normal.kind)) refuse_jam();
    const contact::StepRecord record = press(held);
    last_ = {record.indentation, record.normal_force};
    return record;
}

contact::Scales ConformingModel::scales() const {
    contact::Scales scales = along_z_->scales();
    const Surface s = surface();
    scales.peak_pressure = *std::ranges::max_element(s.normal_traction);
    scales.contact_radius = edge_of(s, s.spacing[0]);
    return scales;
}

Surface ConformingModel::surface() const {
    Surface s = along_z_->surface();
    for (std::size_t i = 0; i < s.size(); ++i) {
        const double angle = s.x(static_cast<int>(i)) / radius_, cosine = std::cos(angle);
        if (is_coupled()) {
            // v = u_t + tan u_n, w = u_n/cos.
            if (s.normal_traction[i] > 0)
                s.normal_traction[i] = ConformingFriction::radial_pressure(
                    s.normal_traction[i],
                    s.tangential_traction_x.empty() ? 0 : s.tangential_traction_x[i], angle);
            if (!s.displacement_x.empty() && !s.displacement_z.empty())
                s.displacement_x[i] -= std::sin(angle) * s.displacement_z[i];
            for (auto* const length : {&s.displacement_z, &s.gap})
                if (!length->empty()) (*length)[i] *= cosine;
            continue;
        }
        for (auto* const traction : {&s.normal_traction, &s.friction_bound})
            if (!traction->empty()) (*traction)[i] /= cosine;
        for (auto* const length : {&s.displacement_x, &s.displacement_z, &s.gap})
            if (!length->empty()) (*length)[i] *= cosine;
    }
    if (is_coupled() && !s.friction_bound.empty()) {
        // Solvers bound what is pressed along z beside the traction: mu p is told here.
        std::vector<double> x(s.size());
        for (std::size_t i = 0; i < x.size(); ++i) x[i] = s.x(static_cast<int>(i));
        const std::vector<double> y(x.size(), 0.);
        friction_->law().bounds({s.normal_traction, x, y}, s.friction_bound);
    }
    return s;
}

std::string ConformingModel::write_state() const {
    contact::StateWriter out;
    out(last_.has_value(), last_.value_or(Pressed{}), along_z_->write_state());
    return out.take();
}

void ConformingModel::read_state(std::string_view bytes) {
    contact::StateReader in(bytes);
    bool was_pressed = false;
    Pressed last{};
    std::string along_z;
    in(was_pressed, last, along_z);
    last_.reset();
    if (was_pressed) last_ = last;
    along_z_->read_state(along_z);
}

std::unique_ptr<contact::Model> ConformingModel::sibling(
    const contact::Case::Contact& options) const {
    // The compliance of a press without friction knows of no force along the arc that carries.
    if (options.coupling && !friction_) return nullptr;
    auto other = along_z_->sibling(options);
    return other ? std::make_unique<ConformingModel>(std::move(other), radius_, friction_)
                 : nullptr;
}

}  // namespace tricontact::fem

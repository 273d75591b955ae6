#include "experiments/identification/adhesive_values.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

#include "comparisons/half_space/layer.h"
#include "contact/base/error.h"
#include "experiments/identification/adhesion/maugis_curve.h"

namespace tricontact::experiments {

namespace {

using contact::Case;
using theory::AdhesiveCurve;
using Kind = contact::NormalControl::Kind;
using Table = IdentificationInput::Table;

theory::DiscScale disc_scale(const Case& rig) {
    return {rig.substrate.young, rig.indenter.radius, *rig.layer.thickness};
}

bool is_in_contact(AdhesiveWay way) {
    return way == AdhesiveWay::joined || way == AdhesiveWay::held;
}

bool is_pulled(AdhesiveWay way) {
    return way == AdhesiveWay::held || way == AdhesiveWay::separation;
}

/// So that it differs from none: below it, lambda is above 1e3 and the contact that of Johnson,
/// Kendall and Roberts.
bool has_range(const Case& rig) {
    constexpr double largest_lambda = 1e3;
    const double range = rig.adhesion->distance();
    return range > MaugisCurve::range_of(largest_lambda, rig.indenter.radius,
                                         rig.materials().effective_modulus(), rig.adhesion->work);
}

/// w_a is found as a share of w, and stated by itself.
double approach_work(const contact::Adhesion& adhesion) {
    return std::min(adhesion.approach_work.value_or(adhesion.work), adhesion.work);
}

/// The branch that is stable under depth, and what lies below it.
class ForceCurve {
  public:
    explicit ForceCurve(AdhesiveCurve curve) : curve_(std::move(curve)) {
        touching_ = curve_.follow({}, {Kind::indentation, 0}).state;
        // The end of the branch is known to the square of the step that it is sought by.
        constexpr double above_end = 1e-8;
        least_ = (1 - above_end) * curve_.pull_off().last_indentation;
        last_force_ = curve_.follow(touching_, {Kind::indentation, least_}).state.force;
    }

    double force_at(double depth, AdhesiveWay way) {
        if (way == AdhesiveWay::approach && depth < 0) return 0;
        if (depth < least_) return is_in_contact(way) ? last_force_ : 0;
        return curve_.follow(touching_, {Kind::indentation, depth}).state.force;
    }

  private:
    AdhesiveCurve curve_;
    AdhesiveCurve::State touching_;
    double least_ = 0, last_force_ = 0;
};

/// Pulled from a depth, the edge being held until it opens.
class PulledCurve {
  public:
    PulledCurve(theory::AdhesiveHysteresis curve, double deepest) : curve_(std::move(curve)) {
        turned_ = curve_.follow({}, {Kind::indentation, deepest}).state;
        if (!turned_.touches()) return;
        constexpr double above_end = 1e-8;  // as in ForceCurve
        least_ = (1 - above_end) * curve_.pull_off(turned_.radius).last_indentation;
        last_force_ = curve_.follow(turned_, {Kind::indentation, least_}).state.force;
    }

    double force_at(double depth, AdhesiveWay way) {
        if (!turned_.touches()) return 0;
        if (depth < least_) return is_in_contact(way) ? last_force_ : 0;
        return curve_.follow(turned_, {Kind::indentation, depth}).state.force;
    }

  private:
    theory::AdhesiveHysteresis curve_;
    AdhesiveCurve::State turned_;
    double least_ = 0, last_force_ = 0;
};

std::vector<double> radii(AdhesiveCurve curve, const std::vector<double>& forces) {
    const contact::PullOff off = curve.pull_off();
    const AdhesiveCurve::State unloaded = curve.follow({}, {Kind::force, 0}).state;
    std::vector<double> all;
    for (const double force : forces)
        all.push_back(force > -off.force ? curve.follow(unloaded, {Kind::force, force}).state.radius
                                         : off.radius);
    return all;
}

}  // namespace

RigDiscs::RigDiscs(const Case& rig, bool on_layer, double step) {
    if (!on_layer) return;
    Case plain = rig;
    plain.adhesion.reset();
    const std::string why = comparisons::why_no_exact_theory(plain);
    if (!why.empty()) throw contact::InputError("adhesion on a layer: " + why);
    table_ = std::make_shared<theory::DiscTable>(
        comparisons::elastic_layer(rig), rig.make_axisymmetric_indenter(), disc_scale(rig), step);
}

namespace {

constexpr double beside_rim = 1 - 1e-6;

/// Of the half-space, without energies.
AdhesiveCurve::Family contacts_of(const std::shared_ptr<const contact::AxisymmetricIndenter>& body,
                                  double modulus) {
    return [body, modulus](double a) {
        return theory::DiscContact{.indentation = body->plane_profile(a),
                                   .force = modulus * body->pressed_area(a),
                                   .stiffness = 2 * modulus * a};
    };
}

}  // namespace

AdhesiveCurve RigDiscs::curve(const Case& rig, bool approaches) const {
    constexpr double least_share = 1e-14;  // as of AdhesiveHysteresis
    const double modulus = rig.materials().effective_modulus(), separation = rig.adhesion->work;
    const double work =
        approaches ? std::max(approach_work(*rig.adhesion), least_share * separation) : separation;
    if (table_) return table_->curve(disc_scale(rig), modulus, work);
    const std::shared_ptr<const contact::AxisymmetricIndenter> body =
        rig.make_axisymmetric_indenter();
    return {contacts_of(body, modulus), modulus, work, work / modulus,
            beside_rim * body->outer_radius()};
}

theory::AdhesiveHysteresis RigDiscs::hysteresis(const Case& rig) const {
    const double modulus = rig.materials().effective_modulus(), work = rig.adhesion->work,
                 approach = approach_work(*rig.adhesion);
    if (table_) return table_->hysteresis(disc_scale(rig), modulus, work, approach);
    const std::shared_ptr<const contact::AxisymmetricIndenter> body =
        rig.make_axisymmetric_indenter();
    return {contacts_of(body, modulus),       modulus, work, approach, work / modulus,
            beside_rim * body->outer_radius()};
}

namespace {

/// Of a range above 0, under which a paraboloid is Maugis' contact.
std::vector<double> values_with_range(const Table& table, const IdentifiedRig& rig,
                                      const std::vector<double>& given) {
    using enum IdentificationInput::Measurement;
    const Case& c = rig.as_case;
    MaugisCurve curve(c.indenter.radius, c.materials().effective_modulus(), c.adhesion->work,
                      c.adhesion->distance());
    std::vector<double> all;
    if (table.measurement != force_indentation) {
        const double strength =
            table.measurement == sliding_force ? c.friction.shear_strength.value() : 0;
        for (const double force : given) {
            const double a = curve.radius_under(force);
            all.push_back(strength > 0 ? strength * std::numbers::pi * a * a : a);
        }
        return all;
    }
    const double zero = table.has_free_zero ? rig.zero_depths.at(table.place) : 0;
    const bool are_rows = given.size() == table.ways.size();
    for (std::size_t i = 0; i < given.size(); ++i) {
        const AdhesiveWay way = are_rows ? table.ways[i] : AdhesiveWay::separation;
        const double depth = given[i] - zero;
        const bool is_apart = way == AdhesiveWay::approach
                                  ? depth < 0
                                  : !is_in_contact(way) && depth < curve.last_indentation();
        all.push_back(is_apart ? 0 : curve.force_at(depth));
    }
    return all;
}

}  // namespace

std::vector<double> adhesive_values(const Table& table, const IdentifiedRig& rig,
                                    const std::vector<double>& given, const RigDiscs& discs) {
    using enum IdentificationInput::Measurement;
    if (has_range(rig.as_case)) return values_with_range(table, rig, given);
    if (table.measurement == contact_radius) return radii(discs.curve(rig.as_case), given);
    if (table.measurement == sliding_force) {
        std::vector<double> forces = radii(discs.curve(rig.as_case), given);
        for (double& value : forces)
            value *= value * std::numbers::pi * rig.as_case.friction.shear_strength.value();
        return forces;
    }
    ForceCurve curve(discs.curve(rig.as_case, true));
    const double zero = table.has_free_zero ? rig.zero_depths.at(table.place) : 0;
    const bool are_rows = given.size() == table.ways.size();
    std::optional<PulledCurve> pulled;
    if (!rig.as_case.adhesion->is_reversible())
        pulled.emplace(discs.hysteresis(rig.as_case), std::ranges::max(given) - zero);
    std::vector<double> all;
    for (std::size_t i = 0; i < given.size(); ++i) {
        const AdhesiveWay way = are_rows ? table.ways[i] : AdhesiveWay::separation;
        const double depth = given[i] - zero;
        all.push_back(pulled && is_pulled(way) ? pulled->force_at(depth, way)
                                               : curve.force_at(depth, way));
    }
    return all;
}

std::vector<double> adhesive_slopes(const Table& table, const IdentifiedRig& rig,
                                    const RigDiscs& discs) {
    const auto [least, largest] = std::ranges::minmax(table.given);
    constexpr double part = 1e-4;
    const double step = part * (largest - least);
    const auto moved = [&](double by) {
        std::vector<double> depths = table.given;
        for (double& depth : depths) depth += by;
        return adhesive_values(table, rig, depths, discs);
    };
    const auto above = moved(step), below = moved(-step);
    std::vector<double> slopes;
    for (std::size_t i = 0; i < above.size(); ++i)
        slopes.push_back((above[i] - below[i]) / (2 * step));
    return slopes;
}

}  // namespace tricontact::experiments

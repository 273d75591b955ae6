#include "experiments/assumptions/measured_effect.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "contact/base/special_values.h"
#include "experiments/assumptions/check_rig.h"
#include "theory/cattaneo_mindlin.h"

namespace tricontact::experiments {

namespace {

/// Static shift with friction and force that many times as large over that of the rig, both at
/// coupling_tangential_ratio; infinite where the contact slides.
double shift_beside(double friction, double force) {
    const double ratio = coupling_tangential_ratio * force / friction;
    if (!(friction > 0 && ratio > 0 && ratio < 1)) return contact::infinity;
    return friction * theory::static_shift_ratio(ratio) /
           theory::static_shift_ratio(coupling_tangential_ratio);
}

/// Of a shift whose coefficient of friction, or force, is wrong by this part to either side;
/// infinite where the contact might slide.
double largest_error(double of_friction, double of_force) {
    double largest = 0;
    for (const double side : {1., -1.}) {
        const double beside = shift_beside(1 + side * of_friction, 1 + side * of_force);
        if (std::isinf(beside)) return contact::infinity;
        largest = std::max(largest, std::abs(1 / beside - 1));
    }
    return largest;
}

/// What is taken to be 1 over what is larger by a share.
Estimate over_larger(const Estimate& share) {
    const double larger = 1 + share.value;
    return {1 / larger - 1, share.standard_error / (larger * larger)};
}

/// What of a shift's relaxation is still to come: what is taken as relaxed over what has come.
Estimate over_relaxed(const Estimate& left) {
    return over_larger({-left.value, left.standard_error});
}

Estimate as_it_is(const Estimate& effect) {
    return effect;
}

/// Of a relative error of mu on the static shift.
Estimate of_friction(const Estimate& change) {
    const double to_friction = std::abs(1 - shift_sensitivity_to_force(coupling_tangential_ratio));
    return {largest_error(change.value, 0), to_friction * change.standard_error};
}

/// An effect that one number of an assumption gives.
struct DirectEffect {
    const char *assumption, *calculation;
    Measured measured;
    Estimate (*of)(const Estimate&);
    bool is_bound = false;
};
constexpr DirectEffect direct_effects[] = {
    {"small_strains", "strain_shift", Measured::static_shift, as_it_is},
    {"small_strains", "strain_indentation", Measured::indentation, as_it_is},
    {"no_adhesion", "adhesive_radius_change", Measured::contact_radius, over_larger},
    {"unsaturated_contact", "saturation", Measured::static_shift, of_friction, true},
    {"no_heating", "heating_change", Measured::static_shift, of_friction, true},
    {"elastic_substrate", "creep_left", Measured::static_shift, over_relaxed},
    {"far_edges", "side_effect", Measured::indentation, over_larger},
    {"no_wear", "wear_ratio", Measured::indentation, as_it_is, true}};

/// What the assumptions of one rig do to what it measures.
class MeasuredEffects {
  public:
    MeasuredEffects(const Rig& rig, const std::vector<Assumption>& assumptions)
        : rig_(rig), assumptions_(assumptions) {}

    std::vector<MeasuredEffect> all() {
        for (const Assumption& one : assumptions_) {
            assumption_ = &one;
            if (one.name == "half_space") add_half_space();
            if (one.name == "uncoupled") add_ratio("coupling_effect", Measured::static_shift);
            if (one.name == "growth_by_rolling")
                add_ratio("growth_difference", Measured::settled_shift);
            if (one.name == "level_surface") add_tilt();
            for (const DirectEffect& effect : direct_effects)
                if (const Calculation* found =
                        one.name == effect.assumption ? find(effect.calculation) : nullptr)
                    add(effect.measured, effect.of(found->result), effect.is_bound);
        }
        return std::move(effects_);
    }

  private:
    /// Of the assumption in turn.
    const Calculation* find(const std::string& name) const { return assumption_->find(name); }

    void add(Measured measured, const Estimate& relative, bool is_bound = false) {
        const bool wanted = rig_.measured.empty() ||
                            std::ranges::find(rig_.measured, measured) != rig_.measured.end();
        if (wanted) effects_.push_back({assumption_->name, measured, relative, is_bound});
    }

    /// The half-space's over the layer's; what both are given may err together, as the criterion
    /// knows.
    void add_half_space_quantity(const std::string& name, Measured measured) {
        const Calculation *half_space = find(name), *layer = find("layer_" + name),
                          *difference = find(name + "_difference");
        if (!half_space || !layer || !difference) return;
        const double ratio = half_space->result.value / layer->result.value;
        add(measured, {ratio - 1, ratio * ratio * difference->result.standard_error});
    }

    void add_half_space() {
        if (!add_static_shift()) add_half_space_quantity("unit_shift", Measured::static_shift);
        add_half_space_quantity("static_shift", Measured::static_shift);
        add_half_space_quantity("indentation", Measured::indentation);
        add_half_space_quantity("contact_radius", Measured::contact_radius);
        add_half_space_quantity("contact_width", Measured::contact_radius);
    }

    /// By the model's shift of the uncoupled layer; false where there is none.
    bool add_static_shift() {
        const auto uncoupled = std::ranges::find(assumptions_, "uncoupled", &Assumption::name);
        const Calculation *unit = find("unit_shift"), *difference = find("unit_shift_difference");
        if (!unit || !difference || uncoupled == assumptions_.end() || !rig_.mu.is_known())
            return false;
        const Calculation* effect = uncoupled->find("coupling_effect");
        if (!effect) return false;
        const double on_half_space =
            unit->result.value * rig_.mu * theory::static_shift_ratio(coupling_tangential_ratio);
        const double ratio = on_half_space / effect->given.back().value.value;
        add(Measured::static_shift, {ratio - 1, ratio * ratio * difference->result.standard_error});
        return true;
    }

    /// The last of two given values over the first: see relative_difference().
    void add_ratio(const std::string& name, Measured measured) {
        const Calculation* calculation = find(name);
        if (!calculation) return;
        const double without = calculation->given.front().value.value,
                     with = calculation->given.back().value.value;
        add(measured, {with / without - 1, calculation->result.standard_error});
    }

    /// The weight on a slope is an error of F_T, of which it may be any part.
    void add_tilt() {
        const Calculation* share = find("tilt_load");
        if (!share) return;
        const bool is_of_force = std::ranges::any_of(share->given, [](const Given& one) {
            return one.symbol == "F_T" || one.symbol == "f_T";
        });
        // Else it is of mu F_N.
        const double of_force = (share->result.value + share->result.standard_error) /
                                (is_of_force ? 1 : coupling_tangential_ratio);
        add(Measured::static_shift, {largest_error(0, of_force), 0}, true);
    }

    const Rig& rig_;
    const std::vector<Assumption>& assumptions_;
    const Assumption* assumption_ = nullptr;
    std::vector<MeasuredEffect> effects_;
};

}  // namespace

const char* name_of(Measured measured) {
    switch (measured) {
        case Measured::static_shift:
            return "static shift";
        case Measured::settled_shift:
            return "settled shift";
        case Measured::indentation:
            return "indentation";
        case Measured::contact_radius:
            return "contact radius";
    }
    return "";
}

std::vector<MeasuredEffect> effects_on_measured(const Rig& rig,
                                                const std::vector<Assumption>& assumptions) {
    if (rig.kind == Rig::Kind::micro_walking) return {};
    return MeasuredEffects(rig, assumptions).all();
}

double shift_sensitivity_to_force(double f) {
    return 2 * f / (3 * std::cbrt(1 - f) * theory::static_shift_ratio(f));
}

}  // namespace tricontact::experiments

#include "atlas/prediction.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <utility>

#include "atlas/adhesive_prediction.h"
#include "atlas/map_coordinates.h"
#include "atlas/predictable.h"
#include "atlas/pressed_layer.h"
#include "atlas/shipped.h"
#include "comparisons/quantities/left_out.h"
#include "comparisons/quantities/quantities.h"
#include "comparisons/quantities/reference.h"
#include "comparisons/run/reading.h"
#include "contact/base/error.h"
#include "contact/half_space_scales.h"
#include "contact/load_path.h"
#include "contact/models/model_kind.h"
#include "theory/rolling/rolled_law.h"

namespace tricontact::atlas {

namespace {

using comparisons::Quantity;
using contact::Case;
using contact::State;
namespace quantities = comparisons::quantities;

constexpr const char *angle_key = "rolling.angle", *poisson_key = "substrate.poisson",
                     *thickness_key = "substrate.thickness_ratio",
                     *friction_key = "friction.coefficient";

Value exact(double value) {
    return {value, 0};
}

/// Of independent factors.
Value operator*(const Value& a, const Value& b) {
    return {a.value * b.value, std::hypot(a.error * b.value, b.error * a.value)};
}

Value operator/(const Value& a, const Value& b) {
    const double ratio = a.value / b.value;
    return {ratio, std::hypot(a.error, ratio * b.error) / std::abs(b.value)};
}

/// Between the lines of load and rolling, in [0, pi/2].
double angle_of(const Case& c) {
    return c.rolling ? folded_angle(c.rolling->angle) : 0;
}

/// Where a contact lies in the maps of what rolling does.
struct Place {
    std::string atlas;  ///< of contacts that settle; "_ratcheting" is added for the others
    Value w, f;         ///< amplitude over the own radius, load over mu F_N
    std::function<Value(double w)> limit;  ///< f_T,lim
    std::map<std::string, double> rest;    ///< of the keys other than amplitude and load
};

/// A prediction as it grows.
class Predictor {
  public:
    Predictor(const Case& c, const std::string& model) : c_(c) {
        p_.model = model;
        p_.left_out = comparisons::left_out(c, model);
        p_.limitations = comparisons::body_limitations(c, {model});
    }

    Prediction of_springs() {
        const comparisons::Reference r = on_half_space("closed forms of MDR");
        if (r.static_shift_ratio > 0)
            set(quantities::static_shift_ratio, exact(r.static_shift_ratio));
        if (r.shakedown_shift_ratio && r.limit_tangential_ratio) {
            set(quantities::settled_shift_ratio, exact(*r.shakedown_shift_ratio));
            set(quantities::kappa, exact(law().mdr_mapping));
        }
        if (p_.state == State::ratcheting) {
            const double excess = excess_of(r.tangential_ratio, *r.limit_tangential_ratio);
            add_maps("sphere_springs" + suffix() + "_ratcheting", {{r.amplitude_ratio, excess}, {}},
                     {});
        }
        return finish();
    }

    Prediction of_half_space() {
        if (c_.is_line_contact()) return of_line();
        const comparisons::Reference r = on_half_space("Hertz' closed forms");
        add_maps({.atlas = "sphere_half_space" + suffix(),
                  .w = exact(c_.rolling ? r.amplitude_ratio : 0),
                  .f = exact(r.tangential_ratio),
                  .limit = [this](double w) { return exact(law().exact_limit(w)); },
                  .rest = {{angle_key, angle_of(c_)}, {poisson_key, common_poisson(c_)}}});
        return finish();
    }

    Prediction of_layer() {
        try {
            add_layer();
        } catch (const OutsideDomain& error) {
            p_.gaps.emplace_back(error.what());
        }
        return finish();
    }

  private:
    const theory::RolledLaw& law() const { return *theory::rolled_law(c_.friction); }
    /// Of names of atlases.
    std::string suffix() const { return law().is_coulomb() ? "" : "_strength"; }

    /// Its settled shift has a closed form; what ratcheting adds to it, divided by lambda, has a
    /// map.
    Prediction of_line() {
        const comparisons::Reference r = on_half_space("closed forms of the line contact");
        if (r.static_shift_ratio > 0)
            set(quantities::static_shift_ratio, exact(r.static_shift_ratio));
        if (r.shakedown_shift_ratio)
            set(quantities::settled_shift_ratio, exact(*r.shakedown_shift_ratio));
        if (r.stick_ratio) set(quantities::stick_ratio, exact(*r.stick_ratio));
        if (p_.state == State::ratcheting) {
            const std::string name = "cylinder_half_space_ratcheting";
            const double excess = excess_of(r.tangential_ratio, *r.limit_tangential_ratio);
            scale_ =
                contact::line_shift_factor(shipped(name).kept) / contact::line_shift_factor(c_);
            add_maps(name, {{r.amplitude_ratio, excess}, {}}, {});
        }
        return finish();
    }

    void add_layer() {
        const std::string name = c_.is_line_contact() ? "cylinder_layer" : "sphere_layer";
        const Atlas& pressed = shipped(name + "_pressed");
        p_.rests_on.push_back(pressed.name);
        const PressedLayer layer(c_, pressed);
        const auto scale = [&](const Quantity& q, double of_hertz) {
            return set(q, with_sphere(layer.scale(q) * exact(of_hertz)));
        };
        const contact::HalfSpaceScales& hertz = layer.hertz();
        set(quantities::normal_force, exact(hertz.normal_force));
        scale(quantities::indentation, hertz.indentation);
        const Value radius = scale(quantities::contact_radius, hertz.contact_radius);
        scale(quantities::peak_pressure, hertz.peak_pressure);
        unit_shift_ = scale(quantities::unit_shift, hertz.unit_shift);

        Place place{.atlas = name,
                    .w = exact(0),
                    .f = {},
                    .limit = [&](double w) { return layer.limit(exact(w)); },
                    .rest = {{angle_key, angle_of(c_)},
                             {thickness_key, layer.thickness_ratio()},
                             {poisson_key, c_.substrate.poisson},
                             {friction_key, c_.friction_coefficient()}}};
        Value limit = exact(1);
        if (c_.rolling) {
            place.w = set(quantities::amplitude_ratio, amplitude_over(radius));
            set(quantities::amplitude, place.w * radius);
            limit = set(quantities::limit_tangential_ratio, layer.limit(place.w));
        }
        place.f = set(quantities::tangential_ratio, load_of(hertz.normal_force, limit));
        add_maps(place);
    }

    Value set(const Quantity& q, const Value& value) {
        p_.entries.push_back({&q, value});
        return value;
    }

    Value with_sphere(Value v) const {
        v.error = std::hypot(v.error, shape_error(c_) * v.value);
        return v;
    }

    comparisons::Reference on_half_space(const char* name) {
        const comparisons::Reference r = comparisons::reference(c_);
        p_.rests_on.emplace_back(name);
        set(quantities::normal_force, exact(r.hertz.normal_force));
        set(quantities::indentation, exact(r.hertz.indentation));
        set(quantities::contact_radius, exact(r.hertz.contact_radius));
        set(quantities::peak_pressure, exact(r.hertz.peak_pressure));
        unit_shift_ = set(quantities::unit_shift, exact(r.hertz.unit_shift));
        set(quantities::tangential_ratio, exact(r.tangential_ratio));
        if (!c_.rolling) return r;
        set(quantities::amplitude_ratio, exact(r.amplitude_ratio));
        set(quantities::amplitude, exact(r.amplitude_ratio * r.hertz.contact_radius));
        if (r.limit_tangential_ratio) {
            set(quantities::limit_tangential_ratio, exact(*r.limit_tangential_ratio));
            p_.state = r.tangential_ratio < *r.limit_tangential_ratio ? State::shakedown
                                                                      : State::ratcheting;
        }
        if (r.limit_amplitude_ratio)
            set(quantities::limit_amplitude_ratio, exact(*r.limit_amplitude_ratio));
        return r;
    }

    /// W over the own radius.
    Value amplitude_over(const Value& radius) const {
        const Case::Rolling& rolling = *c_.rolling;
        const bool is_own = rolling.amplitude_ratio &&
                            rolling.amplitude_reference == Case::AmplitudeReference::model;
        if (is_own) return exact(*rolling.amplitude_ratio);
        return exact(contact::path_amplitude(c_, 0)) / radius;
    }

    Value load_of(double normal_force, const Value& limit) const {
        if (c_.load.is_by_limit()) {
            const double f = c_.load.ratio_by_limit(limit.value);
            return {f, std::abs(c_.load.ratio_by_limit(limit.value + limit.error) - f)};
        }
        return exact(comparisons::tangential_ratio(c_, {normal_force, contact::undefined}));
    }

    /// Whatever the maps do not reach is a gap.
    void add_maps(const Place& place) {
        add_maps(place.atlas + "_static", {{place.f.value}, {place.f.error}}, place);
        if (!c_.rolling) return;
        const Value limit = place.limit(place.w.value);
        const bool ratchets = place.f.value > limit.value;
        const Value load = ratchets
                               ? Value{excess_of(place.f.value, limit.value),
                                       std::hypot(place.f.error, limit.error) / (1 - limit.value)}
                               : place.f / limit;
        const bool is_inside =
            add_maps(place.atlas + (ratchets ? "_ratcheting" : ""),
                     {{place.w.value, load.value}, {place.w.error, load.error}}, place);
        // All runs of the atlas came to it.
        if (is_inside && load.value > load.error && load.value < 1 - load.error)
            p_.state = ratchets ? State::ratcheting : State::shakedown;
    }

    /// The first coordinates, with their errors.
    struct Ends {
        std::vector<double> values, errors;
    };

    /// Whether the atlas reaches it.
    bool add_maps(const std::string& name, const Ends& ends, const Place& place) {
        if (std::ranges::count(shipped_names(), name) == 0) {
            p_.gaps.push_back("no atlas " + name + ": tricontact run computes it");
            return false;
        }
        const Atlas& atlas = shipped(name);
        p_.rests_on.push_back(name);
        try {
            const auto coordinates = coordinates_in(atlas, ends.values, place.rest);
            Reader reader(atlas);
            for (const Map& map : atlas.maps)
                add(map, reader.read_with_errors(map, coordinates, ends.errors));
        } catch (const OutsideDomain& error) {
            p_.gaps.emplace_back(error.what());
            return false;
        }
        return true;
    }

    void add(const Map& map, const Value& value) {
        if (std::isfinite(value.value))
            set(*map.quantity, with_sphere(value * exact(scale_)));
        else
            p_.gaps.push_back(std::string(map.quantity->key) +
                              ": its error bar there is longer than the atlas allows");
    }

    /// Lengths of the ratios, and the order of the declarations.
    Prediction finish() {
        const std::pair<const Quantity*, const Quantity*> lengths[] = {
            {&quantities::static_shift_ratio, &quantities::static_shift},
            {&quantities::settled_shift_ratio, &quantities::settled_shift},
            {&quantities::shift_increment_ratio, &quantities::shift_increment}};
        for (const auto& [ratio, length] : lengths)
            if (const auto* entry = p_.find(*ratio)) set(*length, entry->value * unit_shift_);
        const auto all = comparisons::all_quantities();
        std::ranges::sort(p_.entries, {}, [&](const Prediction::Entry& entry) {
            return std::ranges::find(all, entry.quantity);
        });
        return std::move(p_);
    }

    const Case& c_;
    Prediction p_;
    Value unit_shift_{};
    double scale_ = 1;  // of what the maps say, on another length than theirs
};

}  // namespace

const Prediction::Entry* Prediction::find(const Quantity& q) const {
    const auto found = std::ranges::find(entries, &q, &Entry::quantity);
    return found == entries.end() ? nullptr : &*found;
}

Prediction predict(const Case& c, const std::string& model) {
    if (const std::string what = what_is_not_mapped(c, model); !what.empty())
        throw contact::InputError("no atlas is about " + what + "; tricontact run computes it");
    if (c.adhesion) return adhesive_prediction(c, model);
    Predictor predictor(c, model);
    const contact::ModelKind& kind = contact::model_kind(model);
    if (kind.is_on_line()) return predictor.of_springs();
    return kind.is_half_space() ? predictor.of_half_space() : predictor.of_layer();
}

comparisons::Results results_of(const Prediction& prediction) {
    comparisons::Results results;
    results.model = prediction.model;
    for (const auto& [quantity, value] : prediction.entries) {
        results.set(*quantity, value.value);
        if (quantity == &quantities::settled_shift_ratio)
            results.set(quantities::settled_shift_error_ratio, value.error);
    }
    if (prediction.state != State::undecided) results.set(quantities::state, prediction.state);
    return results;
}

}  // namespace tricontact::atlas

// Whether surfaces that attract each other change the contact of a sphere.
#include <fmt/format.h>

#include <cmath>
#include <memory>

#include "experiments/assumptions/rolling_parts.h"
#include "theory/adhesion.h"
#include "theory/adhesive/disc_table.h"

namespace tricontact::experiments {

namespace {

using theory::Adhesion;

constexpr double least_of_jkr = 1;  // Tabor's parameter: between the limits of both theories
constexpr Inputs pulled_inputs{&Rig::R, &Rig::F_N, &Rig::Dgamma};
constexpr Inputs adhesion_inputs = hertz_inputs + Inputs{&Rig::Dgamma};

template <Adhesion theory_of>
double pull_off_ratio(const RigData& r) {
    return theory::pull_off_force(theory_of, r.R, r.Dgamma) / r.F_N;
}

template <Adhesion theory_of>
double radius_change(const RigData& r) {
    return theory::adhesive_contact_radius(theory_of, r.F_N, r.R,
                                           materials_of(r).effective_modulus(), r.Dgamma) /
               hertz_of(r).contact_radius -
           1;
}

constexpr Formula tabor("tabor_parameter", "mu_T", "(R Dgamma^2/(E*^2 z_0^3))^(1/3)",
                        "Tabor (1977)", "1", adhesion_inputs + Inputs{&Rig::z_0},
                        [](const RigData& r) {
                            return theory::tabor_parameter(
                                r.R, r.Dgamma, materials_of(r).effective_modulus(), r.z_0);
                        });

struct Forms {
    Formula pull_off, radius;
    const char* name;
};

constexpr Forms jkr{
    {"pull_off_ratio", "F_off/F_N", "3/2 pi Dgamma R/F_N", "Johnson, Kendall and Roberts (1971)",
     "1", pulled_inputs, pull_off_ratio<Adhesion::jkr>},
    {"adhesive_radius_change", "a adhesive/a Hertz - 1",
     "a^3 = 3 R/(4 E*) (F_N + 3 pi Dgamma R + sqrt(6 pi Dgamma R F_N + (3 pi Dgamma R)^2))",
     "Johnson, Kendall and Roberts (1971)", "1", adhesion_inputs, radius_change<Adhesion::jkr>},
    "Johnson, Kendall and Roberts"};
constexpr Forms dmt{
    {"pull_off_ratio", "F_off/F_N", "2 pi Dgamma R/F_N", "Derjaguin, Muller and Toporov (1975)",
     "1", pulled_inputs, pull_off_ratio<Adhesion::dmt>},
    {"adhesive_radius_change", "a adhesive/a Hertz - 1", "a^3 = 3 R/(4 E*) (F_N + 2 pi Dgamma R)",
     "Derjaguin, Muller and Toporov (1975)", "1", adhesion_inputs, radius_change<Adhesion::dmt>},
    "Derjaguin, Muller and Toporov"};

/// What `value` says of the adhesive contact with the layer.
template <typename Value>
double on_layer(const RigData& r, const Value& value) {
    const theory::DiscScale scale{r.E_2, r.R, r.b};
    constexpr double step = .05;
    theory::DiscTable contacts(layer_with(r), std::make_shared<contact::Paraboloid>(r.R), scale,
                               step);
    return value(contacts.curve(scale, r.E_2 / (1 - r.nu_2 * r.nu_2), r.Dgamma));
}

constexpr Inputs adhesive_layer_inputs = layer_inputs + Inputs{&Rig::Dgamma};
constexpr const char* edge_on_layer = "the crack at the edge of the exact contact with the layer";

constexpr Formula layer_pull_off(
    "layer_pull_off_ratio", "F_off/F_N, layer", "least force of the layer's curve over F_N",
    edge_on_layer, "1", adhesive_layer_inputs, [](const RigData& r) {
        return on_layer(r, [](theory::AdhesiveCurve curve) { return curve.pull_off().force; }) /
               r.F_N;
    });
constexpr Formula layer_radius(
    "layer_adhesive_radius_change", "a adhesive/a - 1, layer", "both under F_N on the layer",
    edge_on_layer, "1", adhesive_layer_inputs, [](const RigData& r) {
        const contact::NormalControl pressed{contact::NormalControl::Kind::force, r.F_N};
        return on_layer(r,
                        [&](theory::AdhesiveCurve curve) {
                            return curve.follow({}, pressed).state.radius;
                        }) /
                   layer_of(r).contact_radius -
               1;
    });

/// Of a run of the rig's indenter, whose numbers are exact but for rounding.
void decide_by_run(Assumption& a, const Rig& rig, const AttractedContact& run, const char* runs,
                   const std::string& before, const std::string& where) {
    const auto criterion = [&](const char* name, const std::string& symbol, const char* formula,
                               std::vector<Given> given, statistics::Quantity function) {
        a.criteria.push_back({calculate(before + name, symbol + where, formula, runs, "1",
                                        std::move(given), std::move(function)),
                              Criterion::Relation::at_most, accepted_difference, accepted_reason});
    };
    criterion("pull_off_ratio", "F_off/F_N", "largest tension over F_N",
              {{"F_off", Estimate{run.pull_off}, "N"}, {"F_N", rig.F_N, "N"}},
              [](const Values& x) { return x[0] / x[1]; });
    criterion("adhesive_radius_change", "a adhesive/a - 1", "both under F_N",
              {{"a adhesive", Estimate{run.radius}, "m"}, {"a", Estimate{run.radius_without}, "m"}},
              [](const Values& x) { return x[0] / x[1] - 1; });
}

std::string widened_by_run(const AttractedContact& run) {
    return fmt::format("adhesion widens the contact by {}; pulling it off takes {}.",
                       percent_text(run.radius / run.radius_without - 1, 2),
                       quantity(run.pull_off, "N", 2));
}

constexpr const char* half_space_springs = "runs of mdr, springs that let go at the edge";
constexpr const char* layer_springs = "runs of mdr-layer, springs that let go at the edge";
constexpr const char* on_the_layer = ", layer";

/// Of a sphere that is not rigid beside its layer.
void add_soft_layer(Assumption& a, const Rig& rig) {
    if (!rig.attracted) {
        a.consequence += " On the layer it is not computed: a run of the rig's indenter.";
        return;
    }
    if (!rig.attracted->why_none.empty()) {
        a.consequence +=
            fmt::format(" On the layer it is not computed: {}.", rig.attracted->why_none);
        return;
    }
    decide_by_run(a, rig, rig.attracted->layer, layer_springs, "layer_", on_the_layer);
    a.consequence += " On the layer " + widened_by_run(rig.attracted->layer);
}

}  // namespace

/// Of any body, by runs: attraction has no range there.
Assumption no_adhesion_of_body(const Rig& rig) {
    Assumption a{.name = "no_adhesion",
                 .title = "No adhesion",
                 .claim = "The surfaces do not attract each other"};
    if (!has_all(a, rig, {&Rig::F_N, &Rig::Dgamma})) return a;
    if (!rig.attracted || !rig.attracted->why_none.empty()) {
        a.missing = {"not computed: " + (rig.attracted ? rig.attracted->why_none
                                                       : std::string("runs of mdr and mdr-layer"))};
        return a;
    }
    decide_by_run(a, rig, rig.attracted->half_space, half_space_springs, "", "");
    decide_by_run(a, rig, rig.attracted->layer, layer_springs, "layer_", on_the_layer);
    a.consequence = "On a half-space " + widened_by_run(rig.attracted->half_space) +
                    " On the layer " + widened_by_run(rig.attracted->layer) +
                    " Both without a range.";
    return a;
}

Assumption no_adhesion(const Rig& rig) {
    using enum Criterion::Relation;
    Assumption a{.name = "no_adhesion",
                 .title = "No adhesion",
                 .claim = "The surfaces do not attract each other",
                 .background = known(rig, {&tabor})};
    const bool is_short_ranged =
        a.background.empty() || a.background.front().result.value > least_of_jkr;
    const Forms& forms = is_short_ranged ? jkr : dmt;
    if (!decide(a, rig, forms.pull_off, at_most, accepted_difference, accepted_reason)) return a;
    decide(a, rig, forms.radius, at_most, accepted_difference, accepted_reason);
    a.consequence = fmt::format(
        "By {} (Tabor's parameter {}) on a half-space adhesion widens the contact by {}; pulling "
        "it off takes {}.",
        forms.name, significant(a.background.front().result.value, 2),
        percent_text(a.criteria.back().calculation.result.value, 2),
        quantity(a.deciding_value() * rig.F_N, "N", 2));
    if (!rig.b.is_known()) return a;
    if (!is_short_ranged) {
        a.consequence +=
            " On the layer it is not computed: its springs know attraction of no range.";
        return a;
    }
    if (!roller_is_rigid(rig)) {
        add_soft_layer(a, rig);
        return a;
    }
    for (const Formula* formula : {&layer_pull_off, &layer_radius})
        decide(a, rig, *formula, at_most, accepted_difference, accepted_reason);
    a.consequence +=
        fmt::format(" On the layer it widens the contact by {}; pulling it off takes {}.",
                    percent_text(a.find(layer_radius.name)->result.value, 2),
                    quantity(a.find(layer_pull_off.name)->result.value * rig.F_N, "N", 2));
    return a;
}

}  // namespace tricontact::experiments

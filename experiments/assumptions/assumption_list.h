#pragma once

#include <fmt/format.h>

#include <functional>

#include "experiments/assumptions/assumption.h"
#include "experiments/assumptions/check_rig.h"
#include "io/keys/messages.h"

// The assumptions of rigs, each defined in a file of its own (rolling_*.cc, walking_*.cc): whoever
// adds one declares it here and adds it to the list of its kind of rig; no other file knows it.
namespace tricontact::experiments {

Assumption quasi_static_drive(const Rig& rig);
Assumption ideal_rolling(const Rig& rig);
Assumption half_space(const Rig& rig);
Assumption half_space_of_line(const Rig& rig);
/// By the contacts of Rig::body.
Assumption half_space_of_body(const Rig& rig);
/// Of a sphere or cylinder that is not rigid beside the substrate.
Assumption half_space_indenter(const Rig& rig, const IndenterRun& run);
Assumption far_edges(const Rig& rig);
Assumption level_surface(const Rig& rig);
Assumption long_cylinder(const Rig& rig);
Assumption elastic_substrate(const Rig& rig);
Assumption uncoupled(const Rig& rig, const StaticShift& static_shift);
Assumption growth_by_rolling(const Rig& rig, const RolledGrowth& growth);
Assumption small_strains(const Rig& rig);
Assumption no_adhesion(const Rig& rig);
/// By Rig::attracted.
Assumption no_adhesion_of_body(const Rig& rig);
Assumption smooth_surfaces(const Rig& rig);
Assumption unsaturated_contact(const Rig& rig);
Assumption no_heating(const Rig& rig);
Assumption no_wear(const Rig& rig);
Assumption fitted_constants(const Rig& rig);

// Of rigs on a half-space, experiments/half_space_rig/.
Assumption large_specimens(const Rig& rig);
Assumption no_bulk_stress(const Rig& rig);
Assumption elastic_bodies(const Rig& rig);
Assumption no_fretting_wear(const Rig& rig);
Assumption no_fretting_heating(const Rig& rig);

Assumption contact_diameter(const Rig& rig);
Assumption known_stiffness(const Rig& rig);
Assumption similar_stiffness(const Rig& rig);
Assumption rigid_sensor(const Rig& rig);
Assumption rod_as_spring(const Rig& rig);
Assumption no_tilting(const Rig& rig);
Assumption sampled_often(const Rig& rig);

/// An assumption whose numbers models compute: a run takes the numbers of the file at their values.
inline Assumption at_values_of(const Rig& rig, Assumption a) {
    if (a.criteria.empty() || rig.uncertain.empty()) return a;
    if (!a.consequence.empty()) a.consequence += ' ';
    a.consequence += fmt::format(
        "Models compute this at the values of the file: the ± of {} {} not in it.",
        io::joined(rig.uncertain, std::identity()), rig.uncertain.size() == 1 ? "is" : "are");
    return a;
}

/// Of a sphere or cylinder on a half-space: a fretting test, or one that rolls.
inline std::vector<Assumption> half_space_assumptions(const Rig& rig) {
    std::vector<Assumption> all{large_specimens(rig)};
    if (rig.kind == Rig::Kind::cylinder) all.push_back(long_cylinder(rig));
    if (rig.c.rolling) {
        all.push_back(quasi_static_drive(rig));
        all.push_back(ideal_rolling(rig));
    }
    for (const auto one :
         {level_surface, no_bulk_stress, elastic_bodies, smooth_surfaces, unsaturated_contact})
        all.push_back(one(rig));
    const bool is_ball = rig.kind == Rig::Kind::sphere;
    if (!rig.c.rolling || is_ball) {
        all.push_back(rig.c.rolling ? no_heating(rig) : no_fretting_heating(rig));
        all.push_back(rig.c.rolling ? no_wear(rig) : no_fretting_wear(rig));
    }
    return all;
}

/// All of a rig, in the order in which they are shown.
inline std::vector<Assumption> assumptions_of(const Rig& rig, const StaticShift& static_shift,
                                              const RolledGrowth& growth) {
    const bool is_ball_or_line = rig.kind == Rig::Kind::sphere || rig.kind == Rig::Kind::cylinder;
    if (is_ball_or_line && !rig.b.is_known()) return half_space_assumptions(rig);
    switch (rig.kind) {
        case Rig::Kind::sphere:
            return {quasi_static_drive(rig),
                    ideal_rolling(rig),
                    level_surface(rig),
                    half_space(rig),
                    far_edges(rig),
                    elastic_substrate(rig),
                    at_values_of(rig, uncoupled(rig, static_shift)),
                    at_values_of(rig, growth_by_rolling(rig, growth)),
                    small_strains(rig),
                    rig.attracted ? at_values_of(rig, no_adhesion(rig)) : no_adhesion(rig),
                    smooth_surfaces(rig),
                    unsaturated_contact(rig),
                    no_heating(rig),
                    no_wear(rig),
                    fitted_constants(rig)};
        case Rig::Kind::cylinder:
            return {quasi_static_drive(rig), ideal_rolling(rig), level_surface(rig),
                    half_space_of_line(rig), far_edges(rig),     long_cylinder(rig),
                    elastic_substrate(rig),  uncoupled(rig, {}), smooth_surfaces(rig),
                    unsaturated_contact(rig)};
        case Rig::Kind::body:
            return {quasi_static_drive(rig), at_values_of(rig, half_space_of_body(rig)),
                    elastic_substrate(rig),
                    at_values_of(
                        rig, uncoupled(rig,
                                       [](const Rig& body, bool coupled) {
                                           return coupled ? body.body->coupled_static_shift.value
                                                          : body.body->layer.static_shift.value;
                                       })),
                    at_values_of(rig, no_adhesion_of_body(rig))};
        case Rig::Kind::micro_walking:
            return {contact_diameter(rig), known_stiffness(rig), similar_stiffness(rig),
                    rigid_sensor(rig),     rod_as_spring(rig),   no_tilting(rig),
                    sampled_often(rig)};
    }
    return {};
}

}  // namespace tricontact::experiments

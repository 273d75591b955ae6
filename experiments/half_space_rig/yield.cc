// Whether the bodies stay elastic, and shake down if they do not.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "comparisons/strength/body_strength.h"
#include "contact/base/special_values.h"
#include "experiments/assumptions/rolling_parts.h"

namespace tricontact::experiments {

namespace {

using enum Criterion::Relation;
using comparisons::Strength;

constexpr const char* yield_source =
    "Johnson (1985), sections 4.1 and 7.1; Hamilton and Goodman (1966)";

/// The part of mu F_N that acts at most: all where a shift or nothing is prescribed.
double force_share(const Rig& rig) {
    if (rig.U_a.is_known() || rig.c.load.is_by_limit()) return 1;
    if (rig.F_T.is_known()) return std::min(1., rig.F_T / (rig.mu * rig.F_N));
    return rig.f_T.is_known() ? std::min(1., double{rig.f_T}) : 1;
}

/// F_N, mu, the yield stresses that are given, in the order of the arguments of strength_with().
std::vector<Given> inputs_of(const Rig& rig) {
    std::vector<Given> given{{"F_N", rig.F_N, "N"}, {"mu", rig.mu, "1"}};
    if (rig.Y_1.is_known()) given.push_back({"Y_1", rig.Y_1, "Pa"});
    if (rig.Y_2.is_known()) given.push_back({"Y_2", rig.Y_2, "Pa"});
    return given;
}

std::optional<Strength> strength_with(const Rig& rig, const Values& x) {
    contact::Case c = rig.c;
    c.friction.coefficient = x[1];
    std::size_t next = 2;
    if (rig.Y_1.is_known()) c.yield_stress.indenter = x[next++];
    if (rig.Y_2.is_known()) c.yield_stress.substrate = x[next];
    return comparisons::strength_of(
        c, {x[0], force_share(rig) * x[1] * x[0], rig.sigma.is_known() ? double{rig.sigma} : 0});
}

}  // namespace

Assumption elastic_bodies(const Rig& rig) {
    Assumption a{
        .name = "elastic_bodies", .title = "Elastic bodies", .claim = "Neither body yields"};
    if (!rig.Y_1.is_known() && !rig.Y_2.is_known()) {
        a.missing = {"substrate.yield_stress"};
        return a;
    }
    const std::vector<Given> given = inputs_of(rig);
    const auto now = strength_with(rig, values_of(given));
    if (!now || !now->weakest()) {
        a.missing = {"closed forms of a contact whose edge slips backward under a bulk stress"};
        return a;
    }
    a.criteria.push_back({calculate("von_mises_ratio", "sigma_Mises/Y",
                                    "largest sqrt(3 J_2) below the contact over Y of its body",
                                    yield_source, "1", given,
                                    [rig](const Values& x) {
                                        const auto s = strength_with(rig, x);
                                        return s && s->weakest() ? 1 / s->weakest()->factor()
                                                                 : contact::undefined;
                                    }),
                          at_most, 1, "von Mises' criterion"});
    if (now->shakedown_pressure)
        a.background.push_back(calculate(
            "shakedown_ratio", "p_0/(k lambda)",
            "p_0/k over its limit of elastic shakedown in sliding, k = Y/sqrt(3)",
            "Johnson (1985), section 9.2; Ponter, Hearle and Johnson (1985)", "1", given,
            [rig](const Values& x) {
                const auto s = strength_with(rig, x);
                return s && s->shakedown_pressure ? *s->pressure_over_k() / *s->shakedown_pressure
                                                  : contact::undefined;
            }));
    for (const std::string& sentence : comparisons::strength_sentences(rig.c, *now))
        a.consequence += (a.consequence.empty() ? "" : " ") + sentence;
    return a;
}

}  // namespace tricontact::experiments

// Adhesion that a rig states and the fit has not, and whether the theory of the one that it has
// applies.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "contact/half_space_scales.h"
#include "experiments/identification/identification_models.h"
#include "experiments/identification/identification_report.h"
#include "report/format.h"
#include "theory/adhesion.h"

namespace tricontact::experiments {

namespace {

using report::Verdict;
using Measurement = IdentificationInput::Measurement;

// Between the limits of both theories; contact radii that differ by less are not called different.
constexpr double least_tabor_of_jkr = 1, negligible_widening = .01;

/// The least normal force of the measurements [N], under which adhesion does most.
double least_force(const IdentificationInput& input) {
    double least = *input.rig.load.normal_force;
    for (const auto& table : input.tables) {
        if (table.measurement == Measurement::contact_radius)
            least = std::min(least, std::ranges::min(table.given));
        if (table.measurement == Measurement::force_indentation ||
            table.measurement == Measurement::force_relaxation)
            least = std::min(least, std::ranges::min(table.observed));
        if (table.measurement == Measurement::indentation_creep)
            least = std::min(least, table.held);
    }
    return least;
}

double found_or(const IdentifiedModel& model, const char* key, double known) {
    const auto k = model.found.find(key);
    return k ? model.found.parameters[*k].value : known;
}

}  // namespace

std::optional<Verdict> left_out_adhesion(const IdentificationStudy& study) {
    const IdentificationInput& input = study.input;
    if (!input.work_of_adhesion || input.rig.adhesion) return {};
    const IdentifiedModel& model = reference_model(study);
    contact::Case c = input.rig;
    c.indenter.radius = found_or(model, "indenter.radius", c.indenter.radius);
    c.substrate.young = found_or(model, "substrate.young", c.substrate.young);
    c.substrate.poisson = found_or(model, "substrate.poisson", c.substrate.poisson);
    c.load.normal_force = least_force(input);
    const double work = *input.work_of_adhesion, modulus = c.materials().effective_modulus();
    const bool is_short_ranged =
        theory::tabor_parameter(c.indenter.radius, work, modulus, input.interatomic_distance) >
        least_tabor_of_jkr;
    const auto theory = is_short_ranged ? theory::Adhesion::jkr : theory::Adhesion::dmt;
    const double wider = theory::adhesive_contact_radius(theory, *c.load.normal_force,
                                                         c.indenter.radius, modulus, work) /
                         contact::half_space_scales(c).contact_radius;
    std::string sentence = fmt::format(
        "The fit has no adhesion: rig.work_of_adhesion = {} is left out. On a half-space of "
        "the modulus found it widens the contact by {} % under {} (by {})",
        report::given_quantity(work, "J/m2"), report::significant(100 * (wider - 1), 2),
        report::quantity(*c.load.normal_force, "N", 3),
        is_short_ranged ? "Johnson, Kendall and Roberts" : "Derjaguin, Muller and Toporov");
    if (input.find(Measurement::contact_radius))  // a^3 is proportional to 1/E
        sentence += fmt::format(", from which radii alone give E {} % too low",
                                report::significant(100 * (1 - std::pow(wider, -3)), 2));
    return Verdict{
        wider - 1 > negligible_widening ? Verdict::Standing::violated : Verdict::Standing::holds,
        sentence + "."};
}

std::optional<Verdict> range_of_adhesion(const IdentificationStudy& study) {
    const auto& tried = study.ranges;
    if (tried.empty()) return {};
    const auto text = [](const TriedRange& one) {
        return fmt::format("{} (Tabor's parameter {})", report::quantity(one.range, "m", 2),
                           report::significant(one.tabor, 2));
    };
    const auto best = std::ranges::min_element(tried, {}, &TriedRange::sum_of_squares);
    if (best->is_better)
        return Verdict{
            Verdict::Standing::finding,
            fmt::format("A range of the attraction explains these rows better than none: "
                        "over {} the sum of squares is less by {} and w is {}; state "
                        "adhesion.range.",
                        text(*best),
                        report::significant(
                            half_space_of(study)->found.sum_of_squares - best->sum_of_squares, 2),
                        report::quantity(best->work, "J/m2", 3))};
    if (tried.front().is_excluded)
        return Verdict{Verdict::Standing::finding,
                       fmt::format("These rows exclude that the attraction has a range of {} or "
                                   "more.",
                                   text(tried.front()))};
    const auto excluded = std::ranges::find(tried, true, &TriedRange::is_excluded);
    return Verdict{
        Verdict::Standing::not_resolved,
        fmt::format("These rows do not tell a range of the attraction from none, up to {}: w would "
                    "be {} then{}; state adhesion.range where it is known.",
                    text(*(excluded - 1)), report::quantity((excluded - 1)->work, "J/m2", 3),
                    excluded == tried.end() ? "" : ", and " + text(*excluded) + " is excluded")};
}

std::optional<Verdict> regime_of_adhesion(const IdentificationStudy& study) {
    const IdentificationInput& input = study.input;
    if (!input.rig.adhesion) return {};
    const IdentifiedModel& model = reference_model(study);
    const contact::Case c = rig_with(input, model.found.free, model.found.best()).as_case;
    if (!c.adhesion->is_short_ranged())
        return Verdict{
            Verdict::Standing::finding,
            fmt::format(
                "The contact is that of Maugis over a range of {}, with Tabor's parameter "
                "{}: above 5 it is that of Johnson, Kendall and Roberts, below 0.1 that of "
                "Derjaguin, Muller and Toporov.",
                report::quantity(c.adhesion->distance(), "m", 3),
                report::significant(theory::tabor_parameter(c.indenter.radius, c.adhesion->work,
                                                            c.materials().effective_modulus(),
                                                            c.adhesion->distance()),
                                    2))};
    constexpr double least_of_short_range = 5;
    const double tabor =
        theory::tabor_parameter(c.indenter.radius, c.adhesion->work,
                                c.materials().effective_modulus(), input.interatomic_distance);
    const bool holds = tabor > least_of_short_range;
    return Verdict{
        holds ? Verdict::Standing::holds : Verdict::Standing::violated,
        fmt::format("{} theory of Johnson, Kendall and Roberts, whose range is 0: Tabor's "
                    "parameter of these values is {} at a distance of {}, and it needs 5{}.",
                    holds ? "These values agree with the" : "These values do not agree with the",
                    report::significant(tabor, 2),
                    report::given_quantity(input.interatomic_distance, "m"),
                    holds ? ""
                          : "; below 0.1 the force of pull-off is 2 pi w R, so that w would be a "
                            "quarter less")};
}

}  // namespace tricontact::experiments

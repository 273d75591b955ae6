#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <utility>

#include "contact/cells.h"
#include "contact/heat.h"
#include "contact/load_path.h"
#include "fem/settings.h"
#include "io/case/case_checks.h"
#include "mdr/settings.h"

namespace tricontact::io {

namespace {

using contact::Case;
using contact::HalfSpaceScales;
using contact::ModelKind;
using contact::triangle_wave;

// As a contact rolls, cells enter and leave it. A sum of pressures over them varies by up to this
// times the square of cells over contact radius (seen: 0.26, of a power law of 1.4): at a fixed
// indentation that is F_N.
constexpr double force_of_cells = .5;

/// Largest F_T/(mu F_N) on a path whose loads oscillate as triangles. The quotient of two piecewise
/// linear functions is largest at a kink of either: at the crests and troughs. `force`: F_N over
/// its mean where the normal control is this times its own.
double largest_ratio(const Case::Load& load, double mean_ratio,
                     const std::function<double(double)>& force) {
    const double normal_shift = load.normal_phase / (2 * std::numbers::pi);
    const double tangential_shift = load.tangential_phase / (2 * std::numbers::pi);
    double worst = mean_ratio;
    for (const double shift : {normal_shift, tangential_shift})
        for (const double kink : {0.25, 0.75}) {
            const double phase = kink - shift;
            const double normal =
                force(1 + load.normal_amplitude_ratio * triangle_wave(phase + normal_shift));
            const double tangential =
                1 + load.tangential_amplitude_ratio * triangle_wave(phase + tangential_shift);
            worst = std::max(worst, mean_ratio * std::abs(tangential) / normal);
        }
    return worst;
}

void check_oscillating_ratio(const std::string& key, double worst, const Document& document) {
    if (worst >= 1)
        refuse(document, key,
               "with the oscillating loads F_T/(mu F_N) reaches " + rounded(worst) +
                   ", not below 1: the contact slides",
               "reduce it or the amplitude ratios in [load]");
}

void check_tells_sliding(const Case& c, const std::string& key, double ratio,
                         const Document& document) {
    if (ratio <= 1 - closest_to_sliding || c.tractive_rolling) return;
    if (all_have(c, &ModelKind::steps_are_exact) && !c.interface.is_elastic()) return;
    refuse(document, key,
           "F_T/(mu F_N) reaches " + shortest(ratio) +
               ": so close to 1 only mdr distinguishes stick from gross sliding",
           "stay at or below " + shortest(1 - closest_to_sliding) + ", or take mdr alone");
}

/// Edge of a cell, or distance of springs, over the contact radius; the coarsest of the models'.
double coarsest_cell(const Case& c, const HalfSpaceScales& s) {
    double coarsest = 0;
    const double path = contact::rolling_amplitude(*c.rolling, s.contact_radius) / s.contact_radius;
    const auto& cells = c.of<contact::Cells>();
    for (const std::string& model : c.models) {
        const ModelKind& kind = contact::model_kind(model);
        const auto& line = c.of<mdr::Settings>();
        if (kind.is_on_line())
            coarsest = std::max(coarsest, mdr::springs_are_independent(kind, c.interface)
                                              ? 2 * (1 + path) / line.springs
                                              : 1. / line.elements_per_radius);
        if (kind.is_on_cells())
            coarsest = std::max(coarsest, std::max(1., cells.ratio.value_or(1)) *
                                              (cells.spacing ? *cells.spacing / s.contact_radius
                                                             : 1 / *cells.per_radius));
    }
    return coarsest;
}

void check_force_of_cells(const Case& c, const HalfSpaceScales& scales, double ratio,
                          const Document& document) {
    if (!c.rolling) return;
    const double largest = 1 - force_of_cells * std::pow(coarsest_cell(c, scales), 2);
    if (ratio <= largest) return;
    refuse(document, "load.tangential_ratio",
           "F_T/(mu F_N) reaches " + shortest(ratio) +
               ", but at a fixed indentation F_N varies from cell to cell as the contact rolls: it "
               "may slide",
           "stay at or below " + rounded(largest) +
               ", use smaller cells or more springs, or give load.normal_force");
}

void check_at_depth(const Case& c, const HalfSpaceScales& scales, const Document& document) {
    const std::string key = "load.tangential_ratio";
    if (!c.load.tangential_ratio || contact::is_nominally_flat(c)) return;
    const double mean = std::abs(*c.load.tangential_ratio);
    // On the half-space; that of a layer falls no less where the indentation falls.
    const auto force = [&](double factor) {
        if (c.adhesion) return 1.;  // as in check_friction_limit
        Case other = c;
        other.load.indentation = *c.load.indentation * factor;
        return contact::half_space_scales(other).normal_force / scales.normal_force;
    };
    // What relaxes remembers more forces than this one.
    const bool constant = c.relaxation || c.load.normal_amplitude_ratio == 0;
    const double worst = constant ? mean : largest_ratio(c.load, mean, force);
    check_oscillating_ratio(key, worst, document);
    check_tells_sliding(c, key, worst, document);
    check_force_of_cells(c, scales, worst, document);
}

void check_rolls_one_way(const Case& c, const Document& document) {
    if (c.rolling)
        fail(document.find_section("tractive_rolling")->place, "[tractive_rolling]",
             "contradicts [rolling]: the indenter rolls back and forth, or on",
             "give one of the two");
    for (const auto& [key, ratio] :
         {std::pair("load.normal_amplitude_ratio", c.load.normal_amplitude_ratio),
          std::pair("load.tangential_amplitude_ratio", c.load.tangential_amplitude_ratio)})
        if (ratio != 0)
            refuse(document, key,
                   "a contact that rolls on has no period in which loads could oscillate",
                   "omit it");
    for (const auto& [key, time] : {std::pair("load.press_time", c.load.press_time.value_or(0)),
                                    std::pair("load.hold", c.load.hold)})
        if (time != 0)
            refuse(document, key,
                   "a contact that rolls on begins where all has relaxed under F_N and F_T",
                   "omit it");
}

/// What moves or turns across the rolling.
std::array<std::pair<const char*, double>, 2> across(const Case::TractiveRolling& rolling) {
    return {{{"tractive_rolling.lateral_creepage", rolling.lateral_creepage.value_or(0)},
             {"tractive_rolling.spin", rolling.spin}}};
}

void check_cylinder(const Case& c, const Document& document) {
    if (!c.is_line_contact()) return;
    for (const auto& [key, value] : across(*c.tractive_rolling))
        if (value != 0)
            refuse(document, key, "a line contact rolls and slides along x alone",
                   "omit it, or take a body that touches in an area");
}

/// Finite elements roll on what is the same anywhere along its surface, by what one cell displaces.
void check_rolled_elements(const std::string& model, const Case& c, const Document& document) {
    const std::string rolling = model + " rolls on by the response of one cell: ";
    if (c.relaxation)
        refuse(document, "substrate.relaxation.times",
               rolling + "how bodies creep along the way is not computed",
               "omit [substrate.relaxation], or take bem-layer");
    if (c.law != Case::Law::linear)
        refuse(document, "substrate.material",
               rolling + "at finite strains responses do not add up",
               "set it to \"linear\", or leave out " + model);
    if (c.of<fem::Settings>().mesh)
        refuse(document, "fem.mesh", rolling + "the block of a file is not the same along its way",
               "omit it");
    if (c.of<fem::Settings>().solver == fem::Solver::iterative)
        refuse(document, "fem.solver", rolling + "that takes a factor", "leave it out");
    if (document.find("fem.accuracy"))
        refuse(document, "fem.accuracy", rolling + "its accuracy is that of the cells",
               "give their size, fem.size");
    if (c.is_cylindrical() && !c.is_line_contact())
        refuse(document, "indenter.shape",
               rolling + "the ends of a roller are not the same along y",
               "take shape = \"cylinder\", or bem-layer");
}

void check_model(const std::string& model, const Case& c, const Document& document) {
    const ModelKind& kind = contact::model_kind(model);
    if (!kind.rolls_on)
        refuse(document, "models",
               model + " has no grid along which the contact could move by whole cells",
               "take mdr, bem, bem-layer, fem or fem-plane for [tractive_rolling]");
    if (kind.is_meshed()) check_rolled_elements(model, c, document);
    if (!kind.is_on_line()) return;
    for (const auto& [key, value] : across(*c.tractive_rolling))
        if (value != 0)
            refuse(document, key, "mdr is a line of springs along x: it has nothing across",
                   "omit it, or leave mdr out");
}

/// A limit of shakedown is that under constant loads.
void check_load_by_limit(const Case& c, const Document& document) {
    if (!c.load.is_by_limit()) return;
    const auto refuse_beside = [&](const std::string& what) {
        refuse(document, c.load.limit_key(),
               "is said by a limit that " + what + " has not: the least pressures on one path",
               "give load.tangential_ratio");
    };
    if (c.load.normal_amplitude_ratio != 0 || c.load.tangential_amplitude_ratio != 0)
        refuse_beside("a contact under oscillating loads");
    if (c.relaxation) refuse_beside("a relaxing substrate");
}

/// F_T points along x except where the body rolls on.
void check_direction(const Case& c, const Document& document) {
    if (c.load.tangential_ratio.value_or(0) < 0)
        refuse(document, "load.tangential_ratio",
               "must be at least 0 and less than 1 but with [tractive_rolling]",
               "give its amount, x points along F_T");
    if (c.load.tangential_force.value_or(0) < 0)
        refuse(document, "load.tangential_force", "must be at least 0 but with [tractive_rolling]",
               "give its amount, x points along F_T");
}

}  // namespace

void check_friction_limit(const Case& c, const HalfSpaceScales& scales, const Document& document) {
    if (!c.tractive_rolling) check_direction(c, document);
    check_load_by_limit(c, document);
    if (c.load.indentation) return check_at_depth(c, scales, document);
    if (!c.load.tangential_ratio && !c.load.tangential_force) return;
    const double limit = c.friction.law()->limit({*c.load.normal_force, contact::infinity});
    const double mean = std::abs(c.load.tangential_ratio ? *c.load.tangential_ratio
                                                         : *c.load.tangential_force / limit);
    const std::string key = used(document, "load.tangential_ratio", "load.tangential_force");
    if (mean >= 1)
        refuse(document, key,
               "F_T/(mu F_N) = " + rounded(mean) + " is not below 1: the contact slides",
               "reduce it below mu F_N = " + rounded(limit) + " N");
    // The area that attraction holds follows no force in proportion: the model tells whether it
    // carries the rest.
    const double worst =
        largest_ratio(c.load, mean, [&](double factor) { return c.adhesion ? 1 : factor; });
    check_oscillating_ratio(key, worst, document);
    check_tells_sliding(c, key, worst, document);
}

void check_tractive_rolling(const Case& c, const Document& document) {
    if (!c.tractive_rolling) return;
    if (document.find("tractive_rolling.speed") && !c.relaxation && !c.friction.rate &&
        !c.kept.find<contact::ContactHeat>())
        refuse(document, "tractive_rolling.speed",
               "has no effect without substrate.relaxation, friction.rate or substrate.heat, which "
               "are missing",
               "give [substrate.relaxation], [friction.rate] or [substrate.heat] too, or omit this "
               "key");
    check_rolls_one_way(c, document);
    // Others would bring new hills into contact at every step.
    if (c.indenter.roughness || contact::is_nominally_flat(c))
        refuse(document, "indenter.shape", "a rough body is not the same after it has rolled on",
               "take a smooth one, or omit [tractive_rolling]");
    check_cylinder(c, document);
    for (const std::string& model : c.models) check_model(model, c, document);
}

}  // namespace tricontact::io

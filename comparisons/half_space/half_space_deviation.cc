#include "comparisons/half_space/half_space_deviation.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "contact/base/error.h"
#include "contact/base/interruption.h"
#include "contact/load_path.h"

namespace tricontact::comparisons {

namespace {

using contact::Case;
using theory::LayerBase;

constexpr std::array<double, 7> rolled_thickness_ratios{.25, .5, 1, 2, 4, 8, 16};
constexpr std::array<double, 3> rolled_poissons{.3, .45, .5};
constexpr std::array<double, 6> curve_poissons{0, .3, .4, .45, .49, .5};
constexpr std::array<double, 13> map_poissons{0,   .1,   .2,  .3,  .35,  .4, .425,
                                              .45, .465, .48, .49, .495, .5};

/// Ten per decade.
std::vector<double> decades(int from, int to) {
    std::vector<double> values;
    for (int i = 10 * from; i <= 10 * to; ++i) values.push_back(std::pow(10., i / 10.));
    return values;
}

void check(const Case& c) {
    if (c.prescribed_path)
        throw contact::InputError(
            "[path] or an amplitude in [load]: layer and half-space are compared under constant "
            "loads, at rest or rolling "
            "back and forth; give load.normal_force in place of the path, or run it with the "
            "models bem and bem-layer");
    c.require_coulomb("a deviation");
    c.refuse_extras("deviations from Hertz' contact",
                    {Case::Extra::bulk_stress, Case::Extra::relaxing_indenter});
    if (!contact::is_hertz_round(c))
        throw contact::InputError(
            "indenter.shape: deviations are those from Hertz' contact; take a paraboloid or a "
            "sphere");
    if (!c.layer.thickness)
        throw contact::InputError(
            "substrate.thickness is missing: without it the substrate is a half-space; give the "
            "thickness, --set \"substrate.thickness=8 mm\"");
    if (c.relaxation)
        throw contact::InputError(
            "substrate.relaxation: deviations are those of an elastic layer; describe the relaxed "
            "one, without this section");
    if (!constant_loads(c))
        throw contact::InputError(
            "load.normal_amplitude_ratio, load.tangential_amplitude_ratio: deviations are those "
            "under constant loads; leave them out, or run the case with the models "
            "bem and bem-layer");
    if (c.load.is_by_limit())
        throw contact::InputError(
            std::string(c.load.limit_key()) +
            ": layer and half-space are compared under one F_T; give load.tangential_ratio");
}

NeededThicknesses needed_on(const ExactDeviation& exact, const Quantity* q,
                            const ExactCurve& curve) {
    std::vector<RatioPoint> points;
    for (std::size_t i = 0; i < curve.ratios.size(); ++i)
        points.push_back({curve.thickness_ratios[i], curve.ratios[i].at(q)});
    const auto ratio = [&](double thickness) { return *exact.ratio(q, thickness); };
    NeededThicknesses result;
    std::ranges::transform(deviation_tolerances, result.begin(), [&](double tolerance) {
        return needed_thickness(points, ratio, tolerance);
    });
    return result;
}

ExactCurve curve_of(const DeviationContact& contact, double poisson, LayerBase base, bool coupled) {
    const ExactDeviation exact(contact, poisson, base);
    // To 1000 D_c, where no deviation is above a tenth of a percent.
    ExactCurve curve{.poisson = poisson,
                     .base = base,
                     .thickness_ratios = decades(-1, 3),
                     .ratios = {},
                     .needed = {}};
    for (const double thickness : curve.thickness_ratios) {
        contact::interruption_point();
        curve.ratios.push_back(exact.ratios(thickness, coupled));
    }
    for (const auto& [q, ratio] : curve.ratios.front())
        curve.needed[q] = needed_on(exact, q, curve);
    return curve;
}

ExactMap map_of(const DeviationContact& contact) {
    ExactMap map{decades(-1, 2), {map_poissons.begin(), map_poissons.end()}, {}};
    for (const double poisson : map.poissons) {
        contact::interruption_point();
        const ExactDeviation exact(contact, poisson, LayerBase::bonded);
        for (const double thickness : map.thickness_ratios)
            map.ratios.push_back(exact.ratios(thickness, false));
    }
    return map;
}

/// The longest row of points that know a quantity, from the thickest on.
std::vector<RatioPoint> known_points(const RolledCurve& curve, const Quantity* q) {
    std::vector<RatioPoint> points;
    for (auto p = curve.points.rbegin(); p != curve.points.rend(); ++p) {
        const RolledRatio* ratio = found(p->ratios, q);
        if (!ratio) break;
        points.push_back({p->body.thickness_ratio, ratio->value, ratio->error});
    }
    std::ranges::reverse(points);
    return points;
}

void add_needed(RolledCurve& curve) {
    for (const Quantity* q : rolled_quantities) {
        const auto points = known_points(curve, q);
        if (points.size() < 3) continue;
        std::ranges::transform(
            deviation_tolerances, curve.needed[q].begin(),
            [&](double tolerance) { return needed_thickness(points, tolerance); });
    }
}

}  // namespace

DeviationContact deviation_contact(const Case& c) {
    check(c);
    const auto layer = compare_with_layer(c, {});
    if (!layer->exact) throw contact::InputError(layer->why_not);
    const double modulus = c.substrate.young / (1 - c.substrate.poisson * c.substrate.poisson);
    DeviationContact contact{
        .indenter = c.make_axisymmetric_indenter(),
        .normal_force = c.load.normal_force.value_or(layer->exact->normal_force),
        .effective_modulus = modulus};
    contact.hertz_diameter =
        2 * std::cbrt(3 * contact.normal_force * c.indenter.radius / (4 * modulus));
    contact.tangential_ratio = tangential_ratio(c, {contact.normal_force, contact::undefined});
    if (!(contact.tangential_ratio < 1))
        throw contact::InputError(
            "load.tangential_force: reaches the friction limit mu F_N; reduce it");
    const double radius = layer->exact->contact_radius;
    contact.amplitude_ratio = contact::path_amplitude(c, radius) / radius;
    if (contact.amplitude_ratio >= 1)
        throw contact::InputError(
            "rolling: w = W/a is at least 1: nothing stays in contact; reduce the amplitude");
    return contact;
}

HalfSpaceDeviation exact_deviation(const Case& c) {
    HalfSpaceDeviation result;
    result.c = c;
    result.contact = deviation_contact(c);
    result.thickness_ratio = *c.layer.thickness / result.contact.hertz_diameter;
    if (c.layer.base == Case::Base::frictionless) result.base = LayerBase::frictionless;
    const ExactDeviation exact(result.contact, c.substrate.poisson, result.base);
    result.here = exact.ratios(result.thickness_ratio);
    result.apparent = *compare_with_layer(c, {})->apparent;

    const auto add = [&](double poisson, LayerBase base) {
        const bool first = result.curves.empty();
        const auto same = [&](const ExactCurve& curve) {
            return curve.base == base &&
                   (curve.poisson == poisson || base == LayerBase::frictionless);
        };
        if (std::ranges::none_of(result.curves, same))
            result.curves.push_back(curve_of(result.contact, poisson, base, first));
    };
    add(c.substrate.poisson, result.base);
    for (const double poisson : curve_poissons) add(poisson, LayerBase::bonded);
    add(c.substrate.poisson, LayerBase::frictionless);
    result.map = map_of(result.contact);
    if (result.contact.amplitude_ratio > 0 && result.contact.tangential_ratio > 0)
        result.amplitudes =
            rolled_amplitudes(result.contact.amplitude_ratio, result.contact.tangential_ratio);
    return result;
}

std::vector<RolledBody> rolled_bodies(const HalfSpaceDeviation& deviation) {
    if (deviation.base == LayerBase::frictionless || deviation.contact.tangential_ratio == 0)
        return {};
    const double own = deviation.c.substrate.poisson;
    std::set<double> poissons(rolled_poissons.begin(), rolled_poissons.end());
    poissons.insert(own);
    std::vector<RolledBody> bodies;
    for (const double poisson : poissons)
        for (const bool coupled : {true, false}) {
            std::set<double> thicknesses(rolled_thickness_ratios.begin(),
                                         rolled_thickness_ratios.end());
            if (poisson == own) thicknesses.insert(deviation.thickness_ratio);
            for (const double thickness : thicknesses)
                bodies.push_back({thickness, poisson, coupled});
            bodies.push_back({.poisson = poisson, .coupled = coupled});
        }
    return bodies;
}

void add_rolled(const std::vector<RolledResult>& results, HalfSpaceDeviation& deviation) {
    for (const RolledDeviation& point : rolled_deviations(results)) {
        auto mine = std::ranges::find_if(deviation.rolled, [&](const RolledCurve& curve) {
            return curve.poisson == point.body.poisson && curve.coupled == point.body.coupled;
        });
        if (mine == deviation.rolled.end())
            mine = deviation.rolled.insert(mine, {point.body.poisson, point.body.coupled, {}, {}});
        mine->points.push_back(point);
    }
    for (RolledCurve& curve : deviation.rolled) add_needed(curve);
    deviation.n_failed_runs = static_cast<std::size_t>(
        std::ranges::count_if(results, [](const RolledResult& one) { return !one.values; }));
}

}  // namespace tricontact::comparisons

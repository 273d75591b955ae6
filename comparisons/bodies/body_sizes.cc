#include "comparisons/bodies/body_sizes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "bem/settings.h"
#include "comparisons/quantities/quantities.h"
#include "comparisons/resolution/refinement.h"
#include "contact/base/error.h"
#include "contact/bodies/body_forms.h"
#include "contact/bodies/upper_plate.h"
#include "contact/cells.h"
#include "contact/models/model_kind.h"
#include "fem/settings.h"
#include "io/results/output.h"
#include "mdr/settings.h"
#include "report/format.h"

namespace tricontact::comparisons {

namespace {

using contact::Case;
using contact::ElasticBody;
using std::numbers::pi;

constexpr std::array sizes{.01, .02, .05, .1, .15, .2, .25, .3, .35};
constexpr double largest_size = .35;  // a/R: a section's patch ends at .65 R
constexpr std::array poissons{.3, .45, .49};
constexpr std::array hubs{.2, .4, .6, .8};  // of R
// Rounding leaves less than the audit of forces asks for in small contacts of what does not change
// its volume; there deviations are straight from 0 on, since their logarithm has the factor 1-2 nu.
constexpr double nearly_incompressible = .498, least_of_these = .05;
constexpr double coarse_elements = 16;
constexpr double line_length = 100;  // over R: no line contact is wider than a share of it

/// Hertz (1882); Johnson (1985), ch. 4: a contact's load and pressure by its a/R.
struct Hertz {
    double radius, modulus, length;  ///< R [m], E* [Pa], L [m] of lines
    bool line;

    double depth(double size) const { return radius * size * size; }
    double force(double size) const {
        return line ? pi / 4 * modulus * length * radius * size * size
                    : 4. / 3 * modulus * radius * radius * size * size * size;
    }
    double pressure(double size) const {
        return line ? modulus * size / 2 : 2 / pi * modulus * size;
    }
    double size_of_depth(double d) const { return std::sqrt(d / radius); }
    double size_of_force(double f) const {
        return line ? std::sqrt(4 * f / (pi * modulus * length * radius))
                    : std::cbrt(3 * f / (4 * modulus * radius * radius));
    }
    double of(const Quantity& q, double size) const {
        if (&q == &quantities::normal_force) return force(size);
        if (&q == &quantities::indentation) return depth(size);
        return &q == &quantities::contact_radius ? size * radius : pressure(size);
    }
};

Hertz hertz_of(const SizeContact& contact, double poisson) {
    const Case::IndenterData& indenter = contact.c.indenter;
    return {.radius = indenter.radius,
            .modulus = indenter.material->young / (1 - poisson * poisson),
            .length = line_length * indenter.radius,
            .line = contact.is_line()};
}

void require_comparable(const Case& c) {
    const auto refuse = [](const std::string& text) { throw contact::InputError(text); };
    if (!c.indenter.body)
        refuse(
            "indenter.body is missing: without it the indenter is a half-space; give the body, "
            "--set indenter.body=hemisphere --set indenter.support=holder");
    const ElasticBody::Form form = c.indenter.body->form;
    if (form != ElasticBody::Form::hemisphere && form != ElasticBody::Form::ball &&
        form != ElasticBody::Form::cylinder)
        refuse(std::string(c.indenter.body->key()) +
               ": the size of hemispheres, balls and cylinders is compared; take one of them");
    if (!c.has_rigid_substrate)
        refuse(
            "substrate.rigid: the size of a body is judged on a rigid plane; set it to true, in "
            "place of the substrate's material, or judge the layer without --body");
    if (c.kept.find<contact::UpperPlate>())
        refuse(
            "upper_plate: the size of a body is judged between plates that are alike; leave "
            "[upper_plate] out");
    if (c.prescribed_path)
        refuse(
            "[path]: sizes are compared under one load; give load.normal_force in place of the "
            "path");
    c.refuse_extras("deviations from Hertz' contact",
                    {Case::Extra::bulk_stress, Case::Extra::relaxing_indenter});
    if (c.relaxation)
        refuse(
            "substrate.relaxation: deviations are those of elastic bodies; describe the relaxed "
            "ones, without this section");
    if (!contact::is_hertz_round(c) && !c.is_line_contact())
        refuse(
            "indenter.shape: deviations are those from Hertz' contact; take a paraboloid, sphere "
            "or cylinder");
}

/// Bodies beside the case's own, which comes first.
std::vector<SizedBody> bodies_of(const SizeContact& contact) {
    std::vector<SizedBody> list{contact.own};
    const auto add = [&](SizedBody body) {
        if (std::ranges::find(list, body) == list.end()) list.push_back(body);
    };
    SizedBody other = contact.own;
    using enum ElasticBody::Support;
    if (!contact.is_line()) {
        const bool whole = other.body.form == ElasticBody::Form::ball;
        other.body.form = whole ? ElasticBody::Form::hemisphere : ElasticBody::Form::ball;
        other.body.support = whole ? holder : plates;
        add(other);
    } else {
        other.body.support = plates;
        other.body.hub_radius = 0;
        add(other);
        for (const double hub : hubs) {
            other.body.support = contact::ElasticBody::Support::hub;
            other.body.hub_radius = hub * contact.c.indenter.radius;
            add(other);
        }
    }
    for (const double poisson : poissons) {
        other = contact.own;
        other.poisson = poisson;
        add(other);
    }
    return list;
}

}  // namespace

const std::vector<SizeMeasure>& size_measures() {
    using namespace quantities;
    static const std::vector<SizeMeasure> list{
        {&normal_force, true, "normal_force_at_equal_depth", false},
        {&contact_radius, true, "contact_radius_at_equal_depth", false},
        {&peak_pressure, true, "peak_pressure_at_equal_depth", false},
        {&indentation, false, "indentation_at_equal_force", false},
        {&contact_radius, false, "contact_radius_at_equal_force", true},
        {&peak_pressure, false, "peak_pressure_at_equal_force", true}};
    return list;
}

std::string name_of(const SizeMeasure& measure) {
    return fmt::format("{} at equal {}", label_of(*measure.quantity),
                       measure.at_depth ? "depth" : "force");
}

std::string name_of(const SizedBody& body, double radius) {
    const std::string form(contact::body_form(body.body.form).word);
    switch (body.body.support) {
        case ElasticBody::Support::holder:
            return form + " on a holder";
        case ElasticBody::Support::plates:
            return form + " between plates";
        case ElasticBody::Support::pressure:
            return form + " under a pressure";
        default:  // of holes and loose bodies there are no sizes
            break;
    }
    return fmt::format("{} on a hub of {} R", form,
                       report::significant(body.body.hub_radius / radius, 3));
}

const char* SizeContact::model() const {
    return is_line() ? contact::models::fem_plane : contact::models::fem_axisymmetric;
}

SizeContact size_contact(const Case& c) {
    require_comparable(c);
    SizeContact contact{.c = c, .own = {*c.indenter.body, c.indenter.material->poisson}};
    if (c.load.indentation && contact.is_line())
        throw contact::InputError(
            "load.indentation: a half-space in plane strain has no depth of its own; give "
            "load.normal_force");
    Hertz hertz = hertz_of(contact, contact.own.poisson);
    if (contact.is_line()) hertz.length = c.indenter.length;
    contact.size = c.load.indentation ? hertz.size_of_depth(*c.load.indentation)
                                      : hertz.size_of_force(*c.load.normal_force);
    if (contact.size > largest_size)
        throw contact::InputError(fmt::format(
            "load: a/R of Hertz' contact is {:.3g}; bodies are compared up to {}; reduce the load",
            contact.size, largest_size));
    return contact;
}

std::vector<SizeRun> size_runs(const SizeContact& contact) {
    std::vector<SizeRun> runs;
    for (const SizedBody& body : bodies_of(contact)) {
        std::vector<double> list(sizes.begin(), sizes.end());
        if (body == contact.own && std::ranges::find(list, contact.size) == list.end())
            list.push_back(contact.size);
        if (body.poisson > nearly_incompressible)
            std::erase_if(list, [](double size) { return size < least_of_these; });
        for (const double size : list)
            for (const int level : {0, 1}) runs.push_back({body, size, level});
    }
    return runs;
}

Case size_case(const SizeContact& contact, const SizeRun& run) {
    const Hertz hertz = hertz_of(contact, run.body.poisson);
    Case c = contact.c;
    c.models = {contact.model()};
    c.indenter.body = run.body.body;
    c.indenter.material->poisson = run.body.poisson;
    if (contact.is_line()) c.indenter.length = hertz.length;
    c.load = {};
    c.load.press = Case::Press::frictionless;
    if (contact.c.load.indentation)
        c.load.indentation = hertz.depth(run.size);
    else
        c.load.normal_force = hertz.force(run.size);
    c.load.tangential_ratio = 0;
    c.rolling.reset();
    c.tractive_rolling.reset();
    c.of<contact::Cells>() = {};
    c.kept.reset<bem::Settings>();
    c.kept.reset<mdr::Settings>();
    c.kept.reset<io::Output>();
    fem::Settings fem;
    fem.size = run.size * hertz.radius / (coarse_elements * (1 << run.level));
    fem.tolerance = c.of<fem::Settings>().tolerance;
    c.of<fem::Settings>() = fem;
    return c;
}

namespace {

/// Body over half-space, and where.
std::optional<SizePoint> ratio_of(const SizeMeasure& measure, const Hertz& hertz,
                                  const std::optional<Results>& run) {
    if (!run) return {};
    const auto force = run->number(quantities::normal_force),
               depth = run->number(quantities::indentation), value = run->number(*measure.quantity);
    if (!force || !depth || !value) return {};
    const double size =
        measure.at_depth ? hertz.size_of_depth(*depth) : hertz.size_of_force(*force);
    return SizePoint{.size = size, .ratio = *value / hertz.of(*measure.quantity, size)};
}

/// Two meshes may agree by chance, since contacts end between nodes.
void widen_by_neighbours(std::vector<SizePoint>& points) {
    const std::vector<SizePoint> own = points;
    for (std::size_t i = 0; i < own.size(); ++i) {
        if (i > 0) points[i].error = std::max(points[i].error, own[i - 1].error);
        if (i + 1 < own.size()) points[i].error = std::max(points[i].error, own[i + 1].error);
    }
}

}  // namespace

SizeDeviation size_deviation(const SizeContact& contact,
                             const std::vector<std::optional<Results>>& results) {
    SizeDeviation deviation{.contact = contact};
    const std::vector<SizeRun> runs = size_runs(contact);
    deviation.n_failed_runs = static_cast<std::size_t>(
        std::ranges::count(results, false, &std::optional<Results>::has_value));
    for (std::size_t i = 0; i + 1 < runs.size(); i += 2) {
        const SizeRun& run = runs[i];
        if (deviation.curves.empty() || !(deviation.curves.back().body == run.body))
            deviation.curves.push_back({run.body, {}});
        const Hertz hertz = hertz_of(contact, run.body.poisson);
        for (const SizeMeasure& measure : size_measures()) {
            if (contact.is_line() && !measure.of_lines) continue;
            const auto coarse = ratio_of(measure, hertz, results[i]);
            auto fine = ratio_of(measure, hertz, results[i + 1]);
            if (!coarse || !fine) continue;
            fine->error = safety_factor * std::abs(fine->ratio - coarse->ratio);
            fine->own = run.body == contact.own && run.size == contact.size;
            deviation.curves.back().points[&measure].push_back(*fine);
        }
    }
    for (SizeCurve& curve : deviation.curves)
        for (auto& [measure, points] : curve.points) {
            std::ranges::sort(points, {}, &SizePoint::size);
            widen_by_neighbours(points);
        }
    return deviation;
}

SizeLimits size_limits(const std::vector<SizePoint>& points) {
    std::vector<DeviationPoint> along{{}};  // a body that is large enough is a half-space
    for (const SizePoint& p : points) along.push_back({p.size, p.ratio - 1, p.error});
    SizeLimits limits;
    std::ranges::transform(size_tolerances, limits.begin(), [&](double tolerance) {
        return strain_threshold(along, tolerance, false);
    });
    return limits;
}

}  // namespace tricontact::comparisons

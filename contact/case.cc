#include "contact/case.h"

#include <fmt/format.h>

#include <algorithm>

#include "contact/base/error.h"
#include "contact/bodies/body_shapes.h"
#include "contact/relaxing_case.h"

namespace tricontact::contact {

const char* Case::Load::limit_key() const {
    return limit_fraction ? "load.limit_fraction" : limit_excess ? "load.limit_excess" : nullptr;
}

double Case::Load::ratio_by_limit(double limit) const {
    return limit_fraction ? *limit_fraction * limit : limit + *limit_excess * (1 - limit);
}

void Case::Load::set_tangential_ratio(double ratio) {
    limit_fraction.reset();
    limit_excess.reset();
    tangential_force.reset();
    tangential_ratio = ratio;
}

double Case::friction_coefficient() const {
    const auto mu = friction.law()->coulomb();
    if (!mu) require_coulomb("what is asked for");
    return mu.value();
}

void Case::require_coulomb(const std::string& what, const std::string& place,
                           const std::string& instead) const {
    if (friction.is_coulomb()) return;
    throw InputError(
        fmt::format("{}: {} presumes Coulomb's law, tau = mu p, and the case has tau = {}; give "
                    "friction.coefficient alone{}",
                    place, what, friction.formula(), instead.empty() ? "" : ", or " + instead));
}

double Case::bulk_stress_at(double phase) const {
    if (!prescribed_path) return load.bulk_stress;
    const auto& rows = prescribed_path->rows;
    const double last = static_cast<double>(rows.size() - 1);
    const auto from = static_cast<std::size_t>(std::clamp(std::floor(phase), 0., last));
    if (from + 1 == rows.size()) return rows.back().bulk_stress;
    return PrescribedPath::between(rows[from], rows[from + 1], phase - static_cast<double>(from))
        .bulk_stress;
}

void Case::refuse_extras(const std::string& what, std::initializer_list<Extra> known) const {
    const auto refuse = [&](Extra extra, bool has, const std::string& key, const char* reason) {
        if (has && std::ranges::find(known, extra) == known.end())
            throw InputError(key + ": " + what + ' ' + reason);
    };
    refuse(Extra::elastic_interface, interface.is_elastic(), "interface",
           "presume surfaces that touch without springs between them; leave out [interface]");
    refuse(Extra::bulk_stress, has_bulk_stress(),
           load.bulk_stress == 0 ? "path: bulk_stress" : "load.bulk_stress",
           "presume a substrate that the contact alone loads; omit it");
    refuse(Extra::adhesion, adhesion.has_value(), "adhesion.work",
           "presume surfaces that do not attract each other; leave out [adhesion]");
    refuse(Extra::relaxing_indenter, indenter_relaxes(*this), "substrate.relaxation.body",
           "know no indenter that relaxes; take body = \"substrate\"");
}

double Case::Layer::total_thickness() const {
    double sum = *thickness;
    for (const Lower& one : lower) sum += one.thickness;
    return sum;
}

bool is_hertz_round(const Case& c) {
    const bool round =
        c.indenter.shape == Case::Shape::paraboloid || c.indenter.shape == Case::Shape::sphere;
    return round && !c.indenter.roughness;
}

bool Case::has_bulk_stress() const {
    return load.bulk_stress != 0 || (prescribed_path && prescribed_path->has_bulk_stress());
}

bool Case::is_pressed_only() const {
    if (rolling || tractive_rolling) return false;
    if (!prescribed_path) return !load.is_tangential() && !has_bulk_stress();
    return std::ranges::none_of(prescribed_path->rows, [](const PrescribedPath::Row& row) {
        return row.rotation != 0 || row.offset != Vector2{} || row.bulk_stress != 0 ||
               std::ranges::any_of(row.tangential, [](const auto& t) { return t.value != 0; });
    });
}

bool is_coulomb_round(const Case& c) {
    return is_hertz_round(c) && c.friction.is_coulomb() && !c.interface.is_elastic() &&
           !c.has_bulk_stress() && !c.adhesion;
}

bool has_conical_tip(const Case& c) {
    const auto says = body_shape(c.indenter.shape).has_conical_tip;
    return says && says(c.indenter);
}

double rolling_amplitude(const Case::Rolling& rolling, double reference_radius) {
    return rolling.amplitude ? *rolling.amplitude : *rolling.amplitude_ratio * reference_radius;
}

bool pressure_falls(const Case& c) {
    const auto says = body_shape(c.indenter.shape).pressure_falls;
    return says && says(c.indenter) && !c.indenter.roughness;
}

// On a bonded base 0.01 % is left of the difference between held and free sides at 6 thicknesses; a
// line's displacements fall slower with the distance, 0.03 % at 6 and 0.003 % at 8.
// On a frictionless one the layer is a sheet whose sides are felt as the inverse square of their
// distance: 1.4 % at 6 thicknesses, nu = 1/2.
double far_sides(const Case& c) {
    if (c.layer.base != Case::Base::bonded) return 40;
    return c.is_line_contact() ? 8 : 6;
}

}  // namespace tricontact::contact

#include "mdr/model.h"

#include <fmt/format.h>

#include <cmath>

#include "contact/base/memory.h"
#include "contact/load_path.h"
#include "contact/models/model_kind.h"
#include "contact/relaxing_case.h"
#include "contact/wearing_contact.h"
#include "mdr/adhesive_model.h"
#include "mdr/layer_model.h"
#include "mdr/relaxing_bed.h"
#include "mdr/settings.h"
#include "mdr/spring_bed.h"

namespace tricontact::mdr {

namespace {

// Half width of the contact [m] under `factor` times the case's normal control.
double half_width(const contact::Case& c, const PlaneProfile& profile, double factor) {
    if (c.load.indentation) return profile.half_width(factor * *c.load.indentation);
    return profile.half_width_of_area(factor * *c.load.normal_force /
                                      c.materials().effective_modulus());
}

// Numbers per spring as measured: about 5 and 22 in pressing, more where the limit is followed.
void check_memory(const contact::Case& c) {
    constexpr double elastic = 10, relaxing = 26, branch = 2;
    const double numbers =
        c.relaxation ? relaxing + branch * static_cast<double>(c.relaxation->branches.size())
                     : elastic;
    const int n = c.of<Settings>().springs;
    contact::require_memory(fmt::format("mdr: a bed of {} springs", n),
                            sizeof(double) * numbers * n, "reduce mdr.springs");
}

}  // namespace

std::unique_ptr<contact::Model> make_model(const contact::Case& c) {
    if (c.adhesion) return make_adhesive_model(contact::models::mdr, c, make_model);
    if (c.interface.is_elastic()) return make_model_on_interface(c);
    check_memory(c);
    // A table of the profile over twice the half-space's radius, which grows at most with the load
    // (a cone's does with d); a flatter indenter meets the rim.
    const double peak_factor = contact::crest_factor(c);
    const double table = 2 * peak_factor * contact::half_space_scales(c).contact_radius;
    BedData data;
    data.profile = make_plane_profile(*c.make_axisymmetric_indenter(), table);
    if (c.kept.find<contact::Wear>()) data.wearing_body = c.make_axisymmetric_indenter();
    data.effective_modulus = c.materials().effective_modulus();
    data.effective_shear_modulus = c.materials().effective_shear_modulus();
    data.friction = c.friction.law();
    data.n_springs = c.of<Settings>().springs;
    data.rolling_angle = contact::path_direction(c);
    // 1 % more: the discrete contact is not exactly as wide as the continuous one.
    data.half_length =
        1.01 * (half_width(c, *data.profile, peak_factor) +
                contact::norm(contact::path_reach(c, half_width(c, *data.profile, 1))));
    data.relaxation = contact::common_relaxation(contact::models::mdr, contact::without_layer(c));
    if (data.relaxation) return std::make_unique<RelaxingBed>(std::move(data));
    return std::make_unique<SpringBed>(std::move(data));
}

}  // namespace tricontact::mdr

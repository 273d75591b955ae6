#include "benchmarks/reference/reference.h"

#include <algorithm>

#include "benchmarks/reference/reference_kinds.h"
#include "contact/prescribed_path.h"
#include "files/digest.h"
#include "io/case/case_reader.h"

namespace tricontact::benchmarks {

namespace {

using contact::Case;
namespace keys = quantity_keys;

std::vector<std::string> prescribed_by(const Case& c) {
    using contact::NormalControl;
    using contact::TangentialControl;
    std::vector<std::string> list;
    const bool by_force = final_normal(c).kind == NormalControl::Kind::force;
    list.emplace_back(by_force ? keys::normal_force : keys::indentation);
    if (c.tractive_rolling && c.tractive_rolling->longitudinal_creepage) {
        list.emplace_back(keys::creepage);
        return list;
    }
    if (!c.prescribed_path) {
        if (c.load.tangential_force.value_or(0) != 0 ||
            (by_force && c.load.tangential_ratio.value_or(0) != 0))
            list.emplace_back(keys::tangential_force);
        return list;
    }
    const auto& along = c.prescribed_path->rows.back().tangential[0];
    if (along.kind == TangentialControl::Kind::shift) list.emplace_back(keys::shift);
    if (along.kind == TangentialControl::Kind::force) list.emplace_back(keys::tangential_force);
    return list;
}

/// Body and tractions are of revolution at the end of the path.
bool is_axisymmetric(const Case& c) {
    if (c.is_cylindrical() || c.indenter.shape == Case::Shape::ellipsoid) return false;
    return c.is_pressed_only();
}

}  // namespace

bool Reference::is_prescribed(const std::string& key) const {
    return std::ranges::find(prescribed, key) != prescribed.end();
}

Reference reference(const Case& c, const contact::ModelRunner& runner, const contact::Say& say) {
    check_has_reference(c);
    Reference result{.c = c, .digest = files::digest_of(io::write_case(c))};
    result.geometry = c.is_line_contact()  ? Geometry::plane
                      : is_axisymmetric(c) ? Geometry::axisymmetric
                                           : Geometry::spatial;
    result.prescribed = prescribed_by(c);
    if (has_finite_body(c)) {
        say("reference: finite elements of the section on three meshes");
        refer_section(result, runner);
    } else if (c.tractive_rolling) {
        refer_carter(result);
    } else if (is_frictionless(c) && has_exact_radial_contact(c)) {
        say("reference: exact frictionless contact beside springs and boundary elements");
        refer_radial(result, runner);
    } else if (is_frictionless(c) && has_exact_line_contact(c)) {
        say("reference: exact plane contact beside boundary elements");
        refer_line(result, runner);
    } else {
        say("reference: boundary elements on three grids");
        refer_computed(result, runner);
    }
    // Sections have their sides.
    if (!has_finite_body(c)) add_sides_of_case(result);
    if (!c.contact.coupling && would_couple(c))
        result.remarks.emplace_back(
            "the case leaves the coupling of normal and tangential contact out: a code that has it "
            "is to be run without friction, or with contact.coupling = true here");
    // What a case prescribes has no error.
    for (const std::string& key : result.prescribed)
        if (const auto found = result.values.find(key); found != result.values.end())
            found->second.grid = found->second.model = found->second.domain = 0;
    return result;
}

}  // namespace tricontact::benchmarks

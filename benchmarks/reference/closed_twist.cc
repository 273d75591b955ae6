#include <cmath>
#include <numbers>

#include "benchmarks/reference/exact_parts.h"
#include "contact/base/root.h"
#include "contact/half_space_scales.h"
#include "theory/torsion.h"

namespace tricontact::benchmarks {

namespace {

using contact::Case;
namespace keys = quantity_keys;
using std::numbers::pi;

/// A round body pressed and then twisted about its axis, nothing else.
bool is_twisted_once(const Case& c) {
    if (!c.prescribed_path || c.layer.thickness || !contact::is_coulomb_round(c)) return false;
    const contact::PrescribedPath& path = *c.prescribed_path;
    if (path.rows.size() != 2 || path.starts_unloaded() || path.loads_across()) return false;
    const auto &first = path.rows.front(), &last = path.rows.back();
    return first.normal == last.normal && first.rotation == 0 && last.rotation != 0 &&
           last.tangential[0].value == 0 && first.tangential[0].value == 0 &&
           last.offset == contact::Vector2{} && path.centre == contact::CentreOfRotation{};
}

double shear_compliance(const Case& c) {
    const double indenter = c.indenter.material ? 1 / c.indenter.material->shear_modulus() : 0;
    return indenter + 1 / c.substrate.shear_modulus();
}

}  // namespace

// Circumferential tractions displace nothing else: exact whatever nu.
void take_closed_twist(Reference& reference) {
    const Case& c = reference.c;
    if (!is_uncoupled(c) || !is_twisted_once(c)) return;
    const double a = reference.contact_radius;
    const double limit = c.friction_coefficient() * reference.values.at(keys::normal_force).value;
    const double twist = c.prescribed_path->rows.back().rotation;
    const double ratio = std::abs(twist) * a * a / (limit * shear_compliance(c));
    constexpr double least = 1e-6;  // of c/a
    if (!(theory::twist_ratio(least) > ratio)) return;
    const double stick = contact::bracketed_root(
        [&](double rho) { return theory::twist_ratio(rho) - ratio; }, least, 1.);
    replace_by_exact(reference,
                     {{keys::torque, std::copysign(theory::torque_ratio(stick) * limit * a, twist)},
                      {keys::stick_area, pi * a * a * stick * stick}},
                     "Lubkin (1951)");
}

}  // namespace tricontact::benchmarks

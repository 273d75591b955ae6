#include "contact/substrates/material.h"

#include "contact/base/error.h"

namespace tricontact::contact {

namespace {

void check(const Material& material, const char* body) {
    if (!(material.young > 0))
        throw InputError(std::string(body) + ": Young's modulus must be positive");
    if (!(material.poisson > -1 && material.poisson <= 0.5))
        throw InputError(std::string(body) + ": Poisson's ratio must lie in (-1, 0.5]");
}

}  // namespace

// Of G/K = 3 (1 - 2 nu)/(2 (1 + nu)), which is 0 for nu = 1/2.
Material Material::with_shear_ratio(double ratio) const {
    const double g_over_k = ratio * 3 * (1 - 2 * poisson) / (2 * (1 + poisson));
    const double nu = (3 - 2 * g_over_k) / (2 * (3 + g_over_k));
    return {2 * ratio * shear_modulus() * (1 + nu), nu};
}

MaterialPair::MaterialPair(std::optional<Material> indenter, Material substrate) {
    // Johnson (1985), eq. 4.33 and 7.42 (tangential), 5.3 (coupling): each body adds its own part.
    auto add = [this](const Material& body, double coupling_sign) {
        const double g = body.shear_modulus();
        normal_compliance_ += (1 - body.poisson) / (2 * g);
        tangential_compliance_ += (2 - body.poisson) / (4 * g);
        nu_over_g_ += body.poisson / g;
        coupling_compliance_ += coupling_sign * (1 - 2 * body.poisson) / g;
    };
    check(substrate, "substrate");
    add(substrate, 1);
    if (indenter) {
        check(*indenter, "indenter");
        add(*indenter, -1);
    }
    if (normal_compliance_ == 0) throw InputError("both bodies are rigid; one has to deform");
}

}  // namespace tricontact::contact

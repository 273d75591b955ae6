#include "contact/substrates/relaxing_case.h"

#include <fmt/format.h>

#include <algorithm>

#include "contact/error.h"
#include "contact/substrates/partly_relaxing_substrate.h"
#include "contact/substrates/relaxing_substrate.h"

namespace tricontact::contact {

namespace {

constexpr double largest_elastic_share = 1e-3;  // of the compliance, what may be left out

bool bulk_stays(const Case& c) {
    return c.relaxation->bulk == Relaxation::Bulk::elastic && c.substrate.poisson < 0.5;
}

bool below_stays(const Case& c) {
    auto matters = [&](const Material& body) {
        return body.plane_compliance() > largest_elastic_share * c.substrate.plane_compliance();
    };
    const auto& lower = c.layer.lower;
    return (c.layer.ground && matters(*c.layer.ground)) ||
           std::any_of(lower.begin(), lower.end(),
                       [&](const auto& layer) { return matters(layer.material); });
}

double indenter_share(const Case& c) {
    const MaterialPair substrate({}, c.substrate);
    return 1 - c.materials().effective_modulus() / substrate.effective_modulus();
}

}  // namespace

Unrelaxed what_stays(const Case& c) {
    if (!c.relaxation) return Unrelaxed::nothing;
    if (bulk_stays(c)) return Unrelaxed::bulk;
    if (below_stays(c)) return Unrelaxed::below;
    return indenter_share(c) > largest_elastic_share ? Unrelaxed::indenter : Unrelaxed::nothing;
}

Case without_layer(const Case& c) {
    Case half_space = c;
    half_space.layer = {};
    return half_space;
}

std::optional<Relaxation> common_relaxation(const std::string& model, const Case& c) {
    const Unrelaxed stays = what_stays(c);
    if (stays == Unrelaxed::nothing) return c.relaxation;
    if (stays == Unrelaxed::below)
        throw InputError(fmt::format(
            "substrate.relaxation: {} has one relaxation function, which elastic layers or "
            "ground below do not leave; take another model",
            model));
    if (stays == Unrelaxed::bulk)
        throw InputError(fmt::format(
            "substrate.relaxation: {} has one relaxation function, which an elastic bulk below "
            "Poisson's ratio 1/2 does not leave; take another model, or bulk = \"proportional\" if "
            "the bulk relaxes alike",
            model));
    const double share = indenter_share(c);
    throw InputError(fmt::format(
        "substrate.relaxation: {:.3g} of the compliance is the indenter's, which does not relax, "
        "but {} lets all of it relax; take another model, or omit young and poisson of the "
        "indenter to take it as rigid",
        share, model));
}

Case with_relaxing_ratio(const Case& c, double ratio) {
    Case elastic = c;
    elastic.relaxation.reset();
    elastic.relaxation_input = {};
    elastic.dma_fit.reset();
    if (c.relaxation->bulk == Relaxation::Bulk::proportional)
        elastic.substrate.young *= ratio;
    else
        elastic.substrate = c.substrate.with_shear_ratio(ratio);
    return elastic;
}

std::unique_ptr<Substrate> make_substrate(const Case& c, std::shared_ptr<const Compliance> relaxed,
                                          const ComplianceOf& compliance_of) {
    if (!c.relaxation) return std::make_unique<ElasticSubstrate>(std::move(relaxed));
    if (relaxes_as_one(c))
        return std::make_unique<RelaxingSubstrate>(std::move(relaxed), *c.relaxation);
    const StieltjesInterpolation interpolation = interpolation_of(*c.relaxation);
    CombinedCompliance::Parts parts;
    for (const double ratio : interpolation.nodes())
        parts.push_back(compliance_of(with_relaxing_ratio(c, ratio)));
    return std::make_unique<PartlyRelaxingSubstrate>(std::move(parts), interpolation,
                                                     *c.relaxation);
}

}  // namespace tricontact::contact

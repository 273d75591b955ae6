#include "contact/relaxing_case.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "contact/base/compensated_sum.h"
#include "contact/base/error.h"
#include "contact/base/special_values.h"

namespace tricontact::contact {

namespace {

constexpr double largest_elastic_share = 1e-3;  // of the compliance, what may be left out

std::vector<const Material*> relaxing_bodies(const Case& c) {
    std::vector<const Material*> bodies;
    if (substrate_relaxes(c)) bodies.push_back(&c.substrate);
    if (indenter_relaxes(c)) bodies.push_back(&*c.indenter.material);
    return bodies;
}

bool bulk_stays(const Case& c) {
    return c.relaxation->bulk == Relaxation::Bulk::elastic &&
           std::ranges::any_of(relaxing_bodies(c),
                               [](const Material* body) { return body->poisson < .5; });
}

bool matters_beside(const Material& body, const Material& relaxing) {
    return body.plane_compliance() > largest_elastic_share * relaxing.plane_compliance();
}

bool below_stays(const Case& c) {
    const auto matters = [&](const Material& body) {
        return matters_beside(body, relaxing_material(c));
    };
    const auto& lower = c.layer.lower;
    return (c.layer.ground && matters(*c.layer.ground)) ||
           std::any_of(lower.begin(), lower.end(),
                       [&](const auto& layer) { return matters(layer.material); });
}

bool substrate_stays(const Case& c) {
    return !substrate_relaxes(c) && !c.has_rigid_substrate &&
           matters_beside(c.substrate, *c.indenter.material);
}

double indenter_share(const Case& c) {
    const MaterialPair substrate({}, c.substrate);
    return 1 - c.materials().effective_modulus() / substrate.effective_modulus();
}

/// Of a half-space [-]: (1 - nu)/G, nu/G and (1 - 2 nu)/G are sums of 1/G and 1/(3 K + G), to
/// which an elastic indenter or interface adds what it has. Layers, and what else a mesh holds: too
/// many.
std::vector<double> known_poles(const Case& c, bool is_half_space) {
    if (!is_half_space) return {};
    std::vector<double> poles{0};
    if (bulk_stays(c))
        for (const Material* body : relaxing_bodies(c)) {
            const double nu = body->poisson, pole = 2 * (1 + nu) / (1 - 2 * nu);  // 3 K/G
            if (nu < .5 && std::ranges::find(poles, pole) == poles.end()) poles.push_back(pole);
        }
    const bool one_is_elastic =
        substrate_relaxes(c) ? c.indenter.material && !indenter_relaxes(c) : !c.has_rigid_substrate;
    if (one_is_elastic || c.interface.is_elastic()) poles.push_back(infinity);
    return poles;
}

}  // namespace

RelaxingSubstrate::RelaxingSubstrate(std::shared_ptr<const Compliance> relaxed,
                                     Relaxation relaxation)
    : compliance_(std::move(relaxed)),
      relaxation_(std::move(relaxation)),
      n_(compliance_->points().size()) {
    check(relaxation_);
    forget();
}

bool RelaxingSubstrate::begin(double duration, const SurfaceField&, const SurfaceField& u) {
    RelaxationStep step(relaxation_, duration);
    duration_ = duration;
    decay_ = std::move(step.decay);
    gain_ = std::move(step.gain);
    stiffness_ = step.stiffness;
    before_ = u;
    for (int d = 0; d < 3; ++d) {
        auto& offset = *components(offset_)[d];
        const auto& old = *components(u)[d];
        for (std::size_t i = 0; i < n_; ++i) {
            offset[i] = 0;
            for (std::size_t b = 0; b < branches_.size(); ++b)
                offset[i] +=
                    decay_[b] * (*components(branches_[b].displacement)[d])[i] - gain_[b] * old[i];
        }
    }
    return false;
}

Substrate::Energies RelaxingSubstrate::end(const SurfaceField& t, const SurfaceField& u) {
    const auto& area = compliance_->points().area;
    CompensatedSum all_stored, all_dissipated, all_work;
    Energies energies;
    std::vector<StepIntegrals> integrals;
    for (const auto& branch : relaxation_.branches) integrals.emplace_back(duration_ / branch.time);
    for (int d = 0; d < 3; ++d)
        for (std::size_t i = 0; i < n_; ++i) {
            auto& relaxed = (*components(relaxed_)[d])[i];
            const double displacement = (*components(u)[d])[i];
            const double before = (*components(before_)[d])[i];
            const double change = displacement - before;
            // t = stiffness K u_new + sum (decay_i K h_i - gain_i K u_old)
            double remembered = 0;
            for (std::size_t b = 0; b < branches_.size(); ++b)
                remembered +=
                    decay_[b] * (*components(branches_[b].traction)[d])[i] - gain_[b] * relaxed;
            const double next = ((*components(t)[d])[i] - remembered) / stiffness_;
            const double driven = next - relaxed;
            double mean = (relaxed + next) / 2;  // traction in the step
            double load = std::abs(relaxed) + std::abs(next);
            relaxed = next;
            double stored = next * displacement, dissipated = 0;
            for (std::size_t b = 0; b < branches_.size(); ++b) {
                const double ratio = relaxation_.branches[b].ratio;
                const StepIntegrals& s = integrals[b];
                auto& h = (*components(branches_[b].displacement)[d])[i];
                auto& k_h = (*components(branches_[b].traction)[d])[i];
                dissipated += k_h * h / ratio * s.ee + (k_h * change + driven * h) * s.ew +
                              ratio * driven * change * s.ww;
                mean += k_h * s.mean + ratio * driven * s.drift;
                load += std::abs(k_h);
                h = decay_[b] * h + gain_[b] * change;
                k_h = decay_[b] * k_h + gain_[b] * driven;
                stored += k_h * h / ratio;
            }
            all_stored.add(area[i] / 2 * stored);
            all_dissipated.add(area[i] * dissipated);
            all_work.add(area[i] * mean * change);
            energies.magnitude +=
                area[i] * (load * (std::abs(displacement) + std::abs(before)) + std::abs(stored));
        }
    energies.stored = all_stored.value();
    energies.dissipated = all_dissipated.value();
    energies.work = all_work.value();
    return energies;
}

/// Strains are those of the tractions K u; energies add up over springs and branches.
std::unique_ptr<const Interior> RelaxingSubstrate::interior(const SurfaceField& t) const {
    auto elastic = [&](const SurfaceField& field) {
        return compliance_->interior(field.down, field.in_surface);
    };
    const auto stressed = elastic(t);
    if (!stressed) return nullptr;
    const auto strained = elastic(relaxed_);
    auto inside = std::make_unique<Interior>(*stressed);
    inside->displacement = strained->displacement;
    inside->strain_energy = strained->strain_energy;
    inside->energy_density = strained->energy_density;
    for (std::size_t b = 0; b < branches_.size(); ++b) {
        const auto branch = elastic(branches_[b].traction);
        const double ratio = relaxation_.branches[b].ratio;
        inside->strain_energy += branch->strain_energy / ratio;
        for (std::size_t k = 0; k < inside->energy_density.size(); ++k)
            inside->energy_density[k] += branch->energy_density[k] / ratio;
    }
    return inside;
}

bool substrate_relaxes(const Case& c) {
    return c.relaxation && c.relaxation->body != Relaxation::Body::indenter;
}

bool indenter_relaxes(const Case& c) {
    return c.relaxation && c.relaxation->body != Relaxation::Body::substrate;
}

const Material& relaxing_material(const Case& c) {
    return c.relaxation && !substrate_relaxes(c) ? *c.indenter.material : c.substrate;
}

const char* relaxing_word(const Case& c) {
    if (!indenter_relaxes(c)) return "substrate";
    return substrate_relaxes(c) ? "pair of bodies" : "indenter";
}

Unrelaxed what_stays(const Case& c) {
    if (!c.relaxation) return Unrelaxed::nothing;
    if (bulk_stays(c)) return Unrelaxed::bulk;
    if (substrate_stays(c)) return Unrelaxed::substrate;
    if (below_stays(c)) return Unrelaxed::below;
    if (c.interface.is_elastic()) return Unrelaxed::interface;
    if (indenter_relaxes(c)) return Unrelaxed::nothing;
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
    if (stays == Unrelaxed::interface)
        throw InputError(fmt::format(
            "substrate.relaxation: {} has one relaxation function, which the springs of "
            "an [interface] do not share; take another model",
            model));
    if (stays == Unrelaxed::substrate)
        throw InputError(fmt::format(
            "substrate.relaxation.body: {} has one relaxation function, which a substrate that "
            "does not relax beside its indenter does not leave; take another model, or "
            "substrate.rigid = true",
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
    const bool proportional = c.relaxation->bulk == Relaxation::Bulk::proportional;
    const auto stiffen = [&](Material& body) {
        if (proportional)
            body.young *= ratio;
        else
            body = body.with_shear_ratio(ratio);
    };
    if (substrate_relaxes(c)) stiffen(elastic.substrate);
    if (indenter_relaxes(c)) stiffen(*elastic.indenter.material);
    return elastic;
}

StieltjesInterpolation interpolation_of(const Case& c, bool is_half_space) {
    return interpolation_of(*c.relaxation, known_poles(c, is_half_space));
}

std::unique_ptr<Substrate> make_substrate(const Case& c, bool is_half_space,
                                          std::shared_ptr<const Compliance> relaxed,
                                          const ComplianceOf& compliance_of, const SumOf& sum_of) {
    if (!c.relaxation) return std::make_unique<ElasticSubstrate>(std::move(relaxed));
    if (relaxes_as_one(c))
        return std::make_unique<RelaxingSubstrate>(std::move(relaxed), *c.relaxation);
    const StieltjesInterpolation interpolation = interpolation_of(c, is_half_space);
    CombinedCompliance::Parts parts;
    for (const double ratio : interpolation.nodes)
        parts.push_back(compliance_of(with_relaxing_ratio(c, ratio)));
    const auto sum = sum_of ? sum_of(parts) : PartlyRelaxingSubstrate::Sum{};
    return std::make_unique<PartlyRelaxingSubstrate>(std::move(parts), interpolation, *c.relaxation,
                                                     true, sum);
}

}  // namespace tricontact::contact

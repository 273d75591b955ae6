#pragma once

#include <functional>
#include <memory>
#include <string>

#include "contact/case.h"
#include "contact/substrates/partly_relaxing_substrate.h"
#include "contact/substrates/relaxation.h"
#include "contact/substrates/substrate.h"

namespace tricontact::contact {

/// A substrate whose relaxation is one function of time for all its stiffness. With A the
/// compliance of the relaxed substrate, K its inverse,
///   t = K [u + sum h_i],   so that   A t = stiffness u + offset
/// at the end of a step in which displacements change linearly (see RelaxationStep), `offset` known
/// from the step before. Points out of contact (t = 0) go on relaxing, so that receding contact
/// needs nothing else. Exact for such steps but for rounding, energies too.
class RelaxingSubstrate final : public Substrate {
  public:
    RelaxingSubstrate(std::shared_ptr<const Compliance> relaxed, Relaxation relaxation);

    std::unique_ptr<Substrate> fresh(bool) const override {
        return std::make_unique<RelaxingSubstrate>(compliance_, relaxation_);
    }
    void forget() override {
        relaxed_ = offset_ = before_ = SurfaceField(n_);
        branches_.assign(relaxation_.branches.size(), {SurfaceField(n_), SurfaceField(n_)});
    }
    bool begin(double duration, const SurfaceField& t, const SurfaceField& u) override;
    const Compliance& compliance() const override { return *compliance_; }
    double stiffness() const override { return stiffness_; }
    const SurfaceField& offset() const override { return offset_; }
    Energies end(const SurfaceField& t, const SurfaceField& u) override;
    std::unique_ptr<const Interior> interior(const SurfaceField& t) const override;

  private:
    std::vector<SurfaceField*> memory() override {
        std::vector<SurfaceField*> fields{&relaxed_};
        for (Branch& branch : branches_)
            fields.insert(fields.end(), {&branch.displacement, &branch.traction});
        return fields;
    }

    struct Branch {
        SurfaceField displacement;  // h_i [m]
        SurfaceField traction;      // K h_i [Pa]
    };

    std::shared_ptr<const Compliance> compliance_;
    Relaxation relaxation_;
    std::size_t n_;
    double duration_ = 0, stiffness_ = 1;
    std::vector<double> decay_, gain_;
    std::vector<Branch> branches_;
    SurfaceField before_;   // displacements at the beginning of the step [m]
    SurfaceField relaxed_;  // K u [Pa]
    SurfaceField offset_;
};

/// Which of both bodies relax. The indenter that does has a material.
bool substrate_relaxes(const Case& c);
bool indenter_relaxes(const Case& c);
/// Whose modulus the terms of the relaxation are over: the substrate's where both relax.
const Material& relaxing_material(const Case& c);
/// "substrate", "indenter" or "pair of bodies", for sentences about what relaxes.
const char* relaxing_word(const Case& c);

/// What stays elastic in a case whose substrate relaxes, the top layer: its finite bulk modulus
/// below nu = 1/2; layers or a half-space below whose plane-strain compliance (1 - nu^2)/E is more
/// than 1e-3 of its own; an indenter with more than 1e-3 of the compliance; the springs of an
/// elastic interface. Where the indenter relaxes, a substrate likewise.
enum class Unrelaxed { nothing, bulk, below, indenter, interface, substrate };
Unrelaxed what_stays(const Case& c);

/// The relaxation multiplies all the stiffness, or nothing relaxes.
inline bool relaxes_as_one(const Case& c) {
    return what_stays(c) == Unrelaxed::nothing;
}

/// The case as models of the half-space see it.
Case without_layer(const Case& c);

/// For models that know no other. Throws InputError unless relaxes_as_one().
std::optional<Relaxation> common_relaxation(const std::string& model, const Case& c);

/// The case with what relaxes `ratio` times as stiff as relaxed, and elastic.
Case with_relaxing_ratio(const Case& c, double ratio);

/// How the compliance of the case depends on `ratio` in the range of its relaxation: of a
/// half-space by its own poles.
StieltjesInterpolation interpolation_of(const Case& c, bool is_half_space);
inline StieltjesInterpolation interpolation_of(const Case& c) {
    return interpolation_of(c, !c.layer.thickness);
}

/// The substrate of a case, the half-space or another body. `compliance_of`: an elastic case's, on
/// the same points always;
/// `relaxed`: that of the relaxed case; not needed unless relaxes_as_one(). `sum_of`: sums of these
/// parts, see PartlyRelaxingSubstrate::Sum, for models that know how.
using ComplianceOf = std::function<std::shared_ptr<const Compliance>(const Case&)>;
using SumOf = std::function<PartlyRelaxingSubstrate::Sum(const CombinedCompliance::Parts&)>;
std::unique_ptr<Substrate> make_substrate(const Case& c, bool is_half_space,
                                          std::shared_ptr<const Compliance> relaxed,
                                          const ComplianceOf& compliance_of,
                                          const SumOf& sum_of = {});

}  // namespace tricontact::contact

#pragma once

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

    std::unique_ptr<Substrate> fresh(bool coupled) const override;
    void forget() override;
    bool begin(double duration, const SurfaceField& t, const SurfaceField& u) override;
    const Compliance& compliance() const override { return *compliance_; }
    double stiffness() const override { return stiffness_; }
    const SurfaceField& offset() const override { return offset_; }
    void carry() override;
    Energies end(const SurfaceField& t, const SurfaceField& u) override;
    std::unique_ptr<const Interior> interior(const SurfaceField& t) const override;
    void write(StateWriter& out) const override;
    void read(StateReader& in) override;

  private:
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

}  // namespace tricontact::contact

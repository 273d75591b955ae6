#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "contact/solvers/compliance.h"
#include "contact/substrates/relaxation.h"
#include "contact/substrates/substrate.h"

namespace tricontact::contact {

/// How the compliance of an elastic body depends on the modulus of a part of it: with x a factor of
/// some of its stiffness (its shear moduli, say, while bulk moduli stay),
///   C(x) = sum c_k/(x + l_k),   all c_k positive semidefinite, 0 <= l_k <= infinity,
/// whatever the body's shape (l_k: the generalised eigenvalues of the rest in that part). Hence
/// the rational interpolation
///   C(x) = sum_m X_m/(x + pole_m),   X_m = sum_j weight(m, j) C(node_j),
/// at Zolotarev's points, best for all l_k at once, converges exponentially, and its error is
/// bounded without knowledge of the body:
///   |C(x) - exact| <= error * exact   for 1 <= x <= range, in the energy of any load.
/// Zolotarev (1877); Braess (1986), Nonlinear Approximation Theory, V.5.
struct StieltjesInterpolation {
    /// `least_range` > 1. As few points as `most_error` [-] allows, in a range as wide as these do.
    StieltjesInterpolation(double least_range, double most_error);

    std::size_t size() const { return nodes.size(); }
    double weight(std::size_t m, std::size_t j) const { return weights[m * size() + j]; }
    /// The share of C(node_j) in C(x).
    std::vector<double> shares(double x) const {
        std::vector<double> shares(size());
        for (std::size_t m = 0; m < size(); ++m)
            for (std::size_t j = 0; j < size(); ++j) shares[j] += weight(m, j) / (x + poles[m]);
        return shares;
    }

    double range, error;               ///< where the bound holds; the bound
    std::vector<double> nodes, poles;  ///< x_j > 1; > 0
    std::vector<double> weights;       ///< row by row, see weight()
};

/// A substrate of which a part relaxes: its shear and not its bulk, a layer and not the ground
/// below. The relaxation is no common factor of its stiffness. By the correspondence principle
/// (Lee 1955; Christensen 1982, ch. 2) the compliance in the Laplace domain is the elastic one with
/// that part multiplied by G(s)/G_inf, of which StieltjesInterpolation makes creep of scalars:
///   u(t) = sum_m X_m int J_m(t - t') dt,   J_m the Retardation of a spring pole_m.
/// With the variables e of its branches, e' = t' - e/time, in a step in which tractions change
/// linearly,
///   u = sum_m X_m [relaxed_m t - sum_i compliance_mi e_mi],
/// exact; energies are those of the Kelvin branches.
class PartlyRelaxingSubstrate final : public Substrate {
  public:
    using Parts = CombinedCompliance::Parts;
    /// The weighted sum of the parts as one compliance, whose products cost as much as one part's.
    using Sum =
        std::function<std::shared_ptr<const Compliance>(const std::vector<double>& weights)>;

    /// `parts`: elastic compliances with the relaxing part's moduli times interpolation.nodes.
    /// Not `coupled`: normal tractions displace normally alone. `sum` empty: products are summed.
    PartlyRelaxingSubstrate(Parts parts, StieltjesInterpolation interpolation,
                            Relaxation relaxation, bool coupled = true, Sum sum = {});

    std::unique_ptr<Substrate> fresh(bool coupled) const override {
        return std::make_unique<PartlyRelaxingSubstrate>(parts_, interpolation_, relaxation_,
                                                         coupled, sum_);
    }
    void forget() override;
    bool begin(double duration, const SurfaceField& t, const SurfaceField& u) override;
    const Compliance& compliance() const override { return step_; }
    double stiffness() const override { return 1; }
    const SurfaceField& offset() const override { return offset_; }
    const Compliance& relaxed() const override { return relaxed_; }
    Energies end(const SurfaceField& t, const SurfaceField& u) override;
    /// Unavailable: strains inside would need the body's own history.
    std::unique_ptr<const Interior> interior(const SurfaceField&) const override { return nullptr; }

  private:
    std::vector<SurfaceField*> memory() override;

    struct Branch {
        SurfaceField traction;      // e [Pa]
        SurfaceField displacement;  // X e [m]
    };
    struct Mode {
        Retardation creep;
        std::vector<Branch> branches;
        SurfaceField displacement;  // X t of the last step [m]
    };

    /// Components of a step at the points that carry tractions before or after it, in their order.
    struct Loaded {
        std::vector<std::size_t> points;
        std::vector<double> area, before, after, change;  // [m^2], t [Pa]
    };

    void set_weights(CombinedCompliance& compliance, const std::vector<double>& weights) const;
    std::vector<SurfaceField> modal_displacements(const SurfaceField& t, double& magnitude);
    double largest_energy(const SurfaceField& u, const SurfaceField& t) const;
    Loaded loaded(int d, const SurfaceField& t) const;
    void advance(Mode& mode, int d, const std::vector<double>& now, const Loaded& loaded,
                 Energies& energies) const;
    Energies advance(Branch& branch, const Retardation::Branch& creep, int d,
                     const std::vector<double>& change, const Loaded& loaded) const;

    Parts parts_;
    StieltjesInterpolation interpolation_;
    Relaxation relaxation_;
    bool coupled_;
    Sum sum_;
    std::size_t n_;
    std::vector<double> weights_;  // of step_
    CombinedCompliance step_, relaxed_;
    std::vector<Mode> modes_;
    std::vector<std::shared_ptr<const Compliance>> modal_;  // X_m, where they are known; if needed
    double duration_ = 0;
    SurfaceField traction_, displacement_;  // at the beginning of the step
    SurfaceField offset_;
};

/// The points at which a body of this relaxation is needed, for displacements to 1e-7 at any time.
StieltjesInterpolation interpolation_of(const Relaxation& relaxation);

}  // namespace tricontact::contact

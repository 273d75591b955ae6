#pragma once

#include <array>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "fem/condensed_layer.h"
#include "fem/distributed/session.h"
#include "fem/distributed/stiffness.h"

namespace tricontact::fem::distributed {

/// The Schur complement of a stiffness on its contact patch by MUMPS (Amestoy, Duff, L'Excellent
/// and Koster 2001): Cholesky, METIS' nested dissection, the factor distributed over the ranks, the
/// complement whole on the first one.
class Condensation {
  public:
    /// Symbolic analysis only. Collective, as all but the predictions. Throws std::bad_alloc.
    Condensation(const Stiffness& stiffness, const Session& session);
    ~Condensation();

    /// What this rank will take on top of now [bytes], predicted by MUMPS.
    double predicted_bytes() const;
    double factor_entries() const;  ///< numbers in the factor of all ranks
    double operations() const;      ///< of the elimination on all ranks [flop]

    /// Throws contact::NotConverged if the matrix is not positive definite; std::bad_alloc.
    void factorise();
    /// When all held components are moved by one in a direction and the contact is kept where it
    /// was, the forces on the contact's components that do so, with the opposite sign [N], one
    /// after another like columns of the compliance. On the first rank; empty on others. With one
    /// step of iterative refinement. After factorise(), before compliance().
    std::array<std::vector<double>, 3> forces_of_motion() const;
    /// CondensedLayer::compliance on the first rank; empty on others. After factorise(), once.
    std::vector<double> compliance();

  private:
    struct Parts;
    std::unique_ptr<Parts> parts_;
};

/// `problem` of the first rank on all. Collective.
LayerProblem broadcast(LayerProblem problem, const Session& session);

/// Receives one line about what was done; on the first rank only.
using Say = std::function<void(const std::string&)>;

/// fem::condense by all ranks together; the layer is returned on the first one, an empty one on
/// others. Collective, `problem` the same on all. Throws what fem::condense throws, on all ranks.
CondensedLayer condense(const LayerProblem& problem, const Session& session, const Say& say);

}  // namespace tricontact::fem::distributed

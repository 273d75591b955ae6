#pragma once

#include <cstddef>
#include <vector>

namespace tricontact::experiments {

/// Where a row of a force curve stands on the curve of adhesion. The place of a jump depends on the
/// range of the attraction and on the stiffness of the machine: where the forces show one, the rows
/// beyond it are left out, and those before it are in contact whatever their depth.
enum class AdhesiveWay {
    approach,    ///< apart up to the depth of first touch
    joined,      ///< approaching, held by tension at any depth
    held,        ///< pulled, held by tension at any depth
    separation,  ///< pulled, in contact down to the depth at which it lets go
};

/// Rows of a force curve that are evaluated.
struct AdhesiveRows {
    std::vector<std::size_t> rows;  ///< of the table, increasing
    std::vector<AdhesiveWay> ways;  ///< of these
    bool shows_jump = false;        ///< the forces show tension, and rows were left out
    /// Of a branch, the larger number: how often tension begins. More than once or by a stray row
    /// it does so in rows that were sorted, and are those of both branches in turn.
    int n_onsets = 0;
};

/// `depths`, `forces`: of rows in the order of time, which turn at the deepest one. `error`: of a
/// force [N]; 0: that which the differences of neighbours show. A branch shows tension where its
/// least force is below the eightfold error; then the rows up to that force while it approaches,
/// and from that force on while it is pulled, are left out.
AdhesiveRows adhesive_rows(const std::vector<double>& depths, const std::vector<double>& forces,
                           double error);

}  // namespace tricontact::experiments

#include "fem/distributed/layer.h"

#include <fmt/format.h>

#include <array>
#include <optional>
#include <vector>

#include "contact/base/error.h"
#include "fem/distributed/halves.h"
#include "fem/distributed/petsc.h"
#include "fem/distributed/stages.h"
#include "fem/distributed/stiffness.h"

// LAPACK: Cholesky factor of a symmetric positive definite matrix, and the inverse from it.
extern "C" void dpotrf_(const char* uplo, const int* n, double* a, const int* lda, int* info);
extern "C" void dpotri_(const char* uplo, const int* n, double* a, const int* lda, int* info);

// The same condensation as fem/condensation.h by several processes (docs/how-to/scaling.md). MUMPS
// gives the Schur complement S of the interior; the root rank inverts it, S^-1 being the
// compliance, since it is dense and small beside the factor. Every step is collective: a rank that
// fails alone would leave the others waiting, so errors are agreed on before they are thrown.

namespace tricontact::fem::distributed {

namespace {

// MUMPS' controls: see the users' guide of 5.5, section 6.
constexpr int icntl_ordering = 7, metis = 5;
constexpr int icntl_reserve = 14, percent_of_reserve = 40;
constexpr int icntl_schur_solve = 26, interior_alone = 0;
constexpr int info_megabytes = 15, infog_factor_entries = 20, rinfog_operations = 1;

void refuse_failure(Mat factor) {
    MatFactorError error = MAT_FACTOR_NOERROR;
    check(MatFactorGetError(factor, &error));
    if (error == MAT_FACTOR_NOERROR) return;
    if (error == MAT_FACTOR_OUTMEMORY) throw std::bad_alloc();
    int code = 0, detail = 0;
    check(MatMumpsGetInfog(factor, 1, &code));
    check(MatMumpsGetInfog(factor, 2, &detail));
    if (code == -10 || code == -40)
        throw contact::NotConverged(
            "the layer's stiffness is not positive definite: the mesh has parts that nothing "
            "holds, or inverted elements");
    throw std::runtime_error("MUMPS: error " + std::to_string(code) + " (" +
                             std::to_string(detail) + ")");
}

Vector like(Mat matrix) {
    Vector vector;
    check(MatCreateVecs(matrix, vector.put(), nullptr));
    return vector;
}

// Rounding leaves 1e-9 to 1e-7; beyond this it is no rounding.
constexpr double largest_reaction_error = 1e-5;

/// The Schur complement of a stiffness on its contact patch by MUMPS (Amestoy, Duff, L'Excellent
/// and Koster 2001): Cholesky, METIS' nested dissection, the factor distributed over the ranks, the
/// complement whole on the first one.
class Condensation {
  public:
    /// Symbolic analysis only. Collective, as all but the predictions. Throws std::bad_alloc.
    Condensation(const Stiffness& stiffness, const Session& session)
        : stiffness_(stiffness), session_(session) {
        for (int c = 0; c < static_cast<int>(n_components()); ++c) {
            const auto& rows = stiffness.contact_rows;
            if (rows[c] >= 0) free_rows_.push_back(rows[c]), components_.push_back(c);
        }
        analyse();
    }

    /// What this rank will take on top of now [bytes], predicted by MUMPS.
    double predicted_bytes() const {
        int megabytes = 0;
        check(MatMumpsGetInfo(factor_, info_megabytes, &megabytes));
        const double complement = static_cast<double>(n()) * n();
        const auto compliance = static_cast<double>(n_components() * n_components());
        return 1e6 * megabytes + sizeof(double) * (complement + compliance);
    }

    /// Numbers in the factor of all ranks.
    double factor_entries() const {
        int entries = 0;  // negative: millions
        check(MatMumpsGetInfog(factor_, infog_factor_entries, &entries));
        return entries < 0 ? -1e6 * entries : entries;
    }

    /// Of the elimination on all ranks [flop].
    double operations() const {
        double operations = 0;
        check(MatMumpsGetRinfog(factor_, rinfog_operations, &operations));
        return operations;
    }

    /// Throws contact::NotConverged if the matrix is not positive definite; std::bad_alloc.
    void factorise() {
        check(MatCholeskyFactorNumeric(factor_, stiffness_.matrix, &info_));
        session_.agree([&] { refuse_failure(factor_); });
    }

    /// When all held components are moved by one in a direction and the contact is kept where it
    /// was, the forces on the contact's components that do so, with the opposite sign [N], one
    /// after another like columns of the compliance. On the first rank; empty on others. With one
    /// step of iterative refinement. After factorise(), before compliance().
    std::array<std::vector<double>, 3> forces_of_motion() const {
        Mat matrix = stiffness_.matrix;
        const Vector forces = like(matrix), displacement = like(matrix), held_by = like(matrix);
        std::array<std::vector<double>, 3> result;
        for (int direction = 0; direction < 3; ++direction) {
            check(VecCopy(stiffness_.held_rows[direction], forces));
            check(VecScale(forces, -1));
            solve_interior(forces, displacement);
            check(MatMult(matrix, displacement, held_by));
            check(VecAXPY(forces, -1, held_by));
            result[direction] = at_contact(forces);
        }
        return result;
    }

    /// CondensedLayer::compliance on the first rank; empty on others. After factorise(), once.
    std::vector<double> compliance() {
        Mat complement = nullptr;
        check(MatFactorGetSchurComplement(factor_, &complement, nullptr));
        double* values = nullptr;
        check(MatDenseGetArray(complement, &values));
        std::vector<double> compliance;
        session_.agree_on_first([&] { compliance = inverse_of(values); });
        check(MatDenseRestoreArray(complement, &values));
        check(MatFactorRestoreSchurComplement(factor_, &complement, MAT_FACTOR_SCHUR_INVERTED));
        return compliance;
    }

  private:
    int n() const { return static_cast<int>(free_rows_.size()); }
    std::size_t n_components() const {
        return session_.is_root() ? stiffness_.contact_rows.size() : 0;
    }

    Indices contact() const {
        Indices indices;
        check(ISCreateGeneral(PETSC_COMM_SELF, n(), free_rows_.data(), PETSC_COPY_VALUES,
                              indices.put()));
        return indices;
    }

    void analyse() {
        Mat matrix = stiffness_.matrix;
        check(MatSetOption(matrix, MAT_SPD, PETSC_TRUE));
        check(MatGetFactor(matrix, MATSOLVERMUMPS, MAT_FACTOR_CHOLESKY, factor_.put()));
        check(MatFactorSetSchurIS(factor_, contact()));
        check(MatMumpsSetIcntl(factor_, icntl_ordering, metis));
        check(MatMumpsSetIcntl(factor_, icntl_reserve, percent_of_reserve));
        check(MatFactorInfoInitialize(&info_));
        check(MatCholeskyFactorSymbolic(factor_, matrix, nullptr, &info_));
        check(MatMumpsSetIcntl(factor_, icntl_schur_solve, interior_alone));
        session_.agree([&] { refuse_failure(factor_); });
    }

    // Displacements [m] of the interior under `forces` [N] with the contact kept where it is.
    void solve_interior(Vec forces, Vec displacement) const {
        Mat matrix = stiffness_.matrix;
        const Vector residual = like(matrix), correction = like(matrix);
        check(MatSolve(factor_, forces, displacement));
        check(MatMult(matrix, displacement, residual));
        check(VecAYPX(residual, -1, forces));
        check(MatSolve(factor_, residual, correction));
        check(VecAXPY(displacement, 1, correction));
    }

    // Values of a distributed vector at the contact's components; on the first rank.
    std::vector<double> at_contact(Vec vector) const {
        Vector local;
        check(VecCreateSeq(PETSC_COMM_SELF, n(), local.put()));
        Scatter scatter;
        check(VecScatterCreate(vector, contact(), local, nullptr, scatter.put()));
        check(VecScatterBegin(scatter, vector, local, INSERT_VALUES, SCATTER_FORWARD));
        check(VecScatterEnd(scatter, vector, local, INSERT_VALUES, SCATTER_FORWARD));
        const double* values = nullptr;
        check(VecGetArrayRead(local, &values));
        std::vector<double> result(n_components(), 0.0);
        for (int i = 0; i < n(); ++i) result[components_[i]] = values[i];
        check(VecRestoreArrayRead(local, &values));
        return result;
    }

    // Inverse of the complement (n x n) at the places of all components. MUMPS alone gives the
    // lower triangle by columns; with others by rows (and in the other one nothing of value).
    std::vector<double> inverse_of(double* complement) const {
        const int size = n();
        const bool lower = session_.n_ranks() == 1;
        const char* triangle = lower ? "L" : "U";
        int status = 0;
        if (size > 0) dpotrf_(triangle, &size, complement, &size, &status);
        if (size > 0 && status == 0) dpotri_(triangle, &size, complement, &size, &status);
        if (status != 0)
            throw contact::NotConverged("the condensed stiffness of the contact is singular");
        const std::size_t ld = n_components();
        std::vector<double> inverse(ld * ld, 0.0);
        for (std::size_t c = 0; c < components_.size(); ++c)
            for (std::size_t r = c; r < components_.size(); ++r)
                inverse[components_[c] * ld + components_[r]] =
                    inverse[components_[r] * ld + components_[c]] =
                        lower ? complement[c * size + r] : complement[r * size + c];
        return inverse;
    }

    const Stiffness& stiffness_;
    const Session& session_;
    std::vector<int> free_rows_;   // of the contact; none but on the first rank
    std::vector<int> components_;  // contact components of these
    Matrix factor_;
    MatFactorInfo info_{};
};

// Ranks on one machine share its memory.
void refuse_too_large(const Condensation& condensation, const Session& session) {
    const double needed = session.sum_on_machine(condensation.predicted_bytes());
    session.agree([&] {
        const double available = available_bytes();
        if (needed > available)
            throw contact::InputError(fmt::format(
                "condensing the layer needs {:.1f} GB of memory for the ranks of one machine, "
                "{:.1f} GB are there; spread the ranks over more machines or choose a larger "
                "fem.size",
                needed / 1e9, available / 1e9));
    });
}

// What fem::condense finds. What the contact must do when all held components are moved by one:
// move with them, 1 in that direction and 0 in the others.
std::array<std::vector<double>, 3> missing_reaction(
    const std::array<std::vector<double>, 3>& forces, const std::vector<double>& compliance,
    const std::vector<int>& rows) {
    const std::size_t n = rows.size();
    std::array<std::vector<double>, 3> missing;
    for (std::size_t direction = 0; direction < 3; ++direction) {
        missing[direction].assign(n, 0);
        for (std::size_t r = 0; r < n; ++r) {
            if (rows[r] < 0) continue;
            double moved = 0;
            for (std::size_t c = 0; c < n; ++c)
                moved += compliance[r * n + c] * forces[direction][c];
            missing[direction][r] = (r / (n / 3) == direction ? 1 : 0) - moved;
        }
    }
    return missing;
}

}  // namespace

LayerProblem broadcast(LayerProblem problem, const Session& session) {
    auto& [mesh, materials, base, sides, largest_bulk_ratio, line_length, held_by_symmetry,
           pressed_evenly] = problem;
    session.broadcast(mesh.nodes);
    session.broadcast(mesh.hexes);
    session.broadcast(mesh.regions);
    session.broadcast(mesh.faces);
    for (auto& material : materials) {
        session.broadcast(&material.young, sizeof(double));
        session.broadcast(&material.poisson, sizeof(double));
    }
    session.broadcast(&base, sizeof(base));
    session.broadcast(&sides, sizeof(sides));
    session.broadcast(&largest_bulk_ratio, sizeof(largest_bulk_ratio));
    session.broadcast(&line_length, sizeof(line_length));
    session.broadcast(&held_by_symmetry, sizeof(held_by_symmetry));
    session.broadcast(&pressed_evenly, sizeof(pressed_evenly));
    return problem;
}

CondensedLayer condense(const LayerProblem& problem, const Session& session, const Say& say) {
    session.agree([&] {
        if (problem.needs_symmetry())
            throw contact::InputError(
                "indenter.support: ranks condense bodies that are held; condense one between "
                "plates or under a pressure without mpirun");
    });
    Stages stages(session, say);
    if (session.n_ranks() == 2)
        if (auto layer = condense_halves(problem, session, stages)) return *std::move(layer);
    const Stiffness stiffness(problem, session);
    stages.finished(fmt::format("stiffness of {} unknowns on {} ranks", stiffness.n_unknowns,
                                session.n_ranks()));
    Condensation condensation(stiffness, session);
    stages.finished(fmt::format("analysis, {:.3g} numbers in the factor, {:.3g} Gflop",
                                condensation.factor_entries(), 1e-9 * condensation.operations()));
    refuse_too_large(condensation, session);
    condensation.factorise();
    stages.finished("factor");
    const auto forces = condensation.forces_of_motion();
    stages.finished("6 solutions");
    CondensedLayer layer;
    layer.compliance = condensation.compliance();
    session.agree_on_first([&] {
        layer.points = stiffness.surface.points;
        layer.contact_mass = stiffness.surface.mass;
        layer.missing_reaction = missing_reaction(forces, layer.compliance, stiffness.contact_rows);
        if (layer.reaction_error() > largest_reaction_error)
            throw contact::NotConverged(fmt::format(
                "the condensed layer is wrong: the ground's reaction misses the force by {:.1e}",
                layer.reaction_error()));
    });
    stages.finished("compliance");
    return layer;
}

}  // namespace tricontact::fem::distributed

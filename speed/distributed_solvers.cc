// Conjugate gradients with algebraic multigrid on the layer's stiffness with K/G cut at these
// ratios: what docs/how-to/scaling.md says about iterative solvers.
// usage: [mpirun -n N] distributed_solvers CASE.toml SIZE_IN_MM RATIO...

#include <petscksp.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include "fem/case/layer_condenser.h"
#include "fem/case/model.h"
#include "fem/distributed/layer.h"
#include "fem/distributed/petsc.h"
#include "fem/distributed/stiffness.h"
#include "io/case/case_reader.h"

namespace {

using namespace tricontact;
using namespace tricontact::fem::distributed;

constexpr double tolerance = 1e-10;
constexpr int most_iterations = 2000;

// The six rigid motions for smoothed aggregation.
void describe_rigid_motions(const Stiffness& stiffness) {
    Mat matrix = stiffness.matrix;
    Vector coordinates;
    check(MatCreateVecs(matrix, coordinates.put(), nullptr));
    check(VecSetBlockSize(coordinates, 3));
    double* values = nullptr;
    check(VecGetArray(coordinates, &values));
    for (const auto& x : stiffness.owned_nodes())
        for (const double component : x) *values++ = component;
    values = nullptr;
    check(VecRestoreArray(coordinates, &values));
    MatNullSpace motions = nullptr;
    check(MatNullSpaceCreateRigidBody(coordinates, &motions));
    check(MatSetBlockSize(matrix, 3));
    check(MatSetNearNullSpace(matrix, motions));
    check(MatNullSpaceDestroy(&motions));
}

// A unit normal force on the middle of the contact.
Vector force(const Stiffness& stiffness) {
    Vector vector;
    check(MatCreateVecs(stiffness.matrix, vector.put(), nullptr));
    const auto& rows = stiffness.contact_rows;
    int low = 0, high = 0;
    check(VecGetOwnershipRange(vector, &low, &high));
    const int row = rows[2 * rows.size() / 3 + rows.size() / 6];
    if (row >= low && row < high) check(VecSetValue(vector, row, 1, INSERT_VALUES));
    check(VecAssemblyBegin(vector));
    check(VecAssemblyEnd(vector));
    return vector;
}

void solve(const Stiffness& stiffness, const char* preconditioner, double ratio,
           const Session& session) {
    KSP solver = nullptr;
    PC multigrid = nullptr;
    check(KSPCreate(PETSC_COMM_WORLD, &solver));
    check(KSPSetOperators(solver, stiffness.matrix, stiffness.matrix));
    check(KSPSetType(solver, KSPCG));
    check(KSPSetNormType(solver, KSP_NORM_UNPRECONDITIONED));
    check(KSPGetPC(solver, &multigrid));
    check(PCSetType(multigrid, preconditioner));
    check(KSPSetTolerances(solver, tolerance, 0, PETSC_DEFAULT, most_iterations));
    const Vector right = force(stiffness);
    Vector solution;
    check(VecDuplicate(right, solution.put()));
    double seconds = -MPI_Wtime(), residual = 0;
    check(KSPSetUp(solver));
    check(KSPSolve(solver, right, solution));
    seconds += MPI_Wtime();
    int iterations = 0;
    KSPConvergedReason reason{};
    check(KSPGetIterationNumber(solver, &iterations));
    check(KSPGetResidualNorm(solver, &residual));
    check(KSPGetConvergedReason(solver, &reason));
    if (session.is_root())
        std::printf("K/G %8.0e  %-6s %5d iterations %8.1f s  residual %.1e%s\n", ratio,
                    preconditioner, iterations, seconds, residual,
                    reason > 0 ? "" : "  not converged");
    std::fflush(stdout);
    check(KSPDestroy(&solver));
}

void measure(const std::string& file, const std::string& size, const std::vector<double>& ratios,
             const Session& session) {
    fem::LayerProblem problem;
    session.agree_on_first([&] {
        const contact::Case c = io::read_case(file, {"fem.size=" + size + " mm"});
        problem = fem::problem_of(c, fem::make_mesh(c, {}));
    });
    problem = broadcast(std::move(problem), session);
    for (const double ratio : ratios) {
        problem.largest_bulk_ratio = ratio;
        const Stiffness stiffness(problem, session);
        if (ratio == ratios[0] && session.is_root())
            std::printf("%lld unknowns, %d ranks\n", static_cast<long long>(stiffness.n_unknowns),
                        session.n_ranks());
        describe_rigid_motions(stiffness);
        for (const char* preconditioner : {PCGAMG, PCHYPRE})
            solve(stiffness, preconditioner, ratio, session);
    }
}

}  // namespace

int main(int argc, char** argv) {
    if (argc < 4) {
        std::fprintf(stderr, "usage: %s CASE.toml SIZE_IN_MM RATIO...\n", argv[0]);
        return 2;
    }
    const Session session;
    std::vector<double> ratios;
    for (int i = 3; i < argc; ++i) ratios.push_back(std::atof(argv[i]));
    session.abort_on_local_error([&] { measure(argv[1], argv[2], ratios, session); });
}

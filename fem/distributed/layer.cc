#include "fem/distributed/layer.h"

#include <fmt/format.h>
#include <sys/resource.h>
#include <sys/time.h>

#include <algorithm>
#include <chrono>
#include <cmath>

#include "contact/error.h"
#include "fem/distributed/condensation.h"
#include "fem/distributed/stiffness.h"

namespace tricontact::fem::distributed {

namespace {

// Rounding leaves 1e-9 to 1e-7; beyond this it is no rounding.
constexpr double largest_reaction_error = 1e-5;

// Seconds of this process, and its largest size so far.
struct Cost {
    double wall =
        std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
    double user = 0, gigabytes = 0;

    Cost() {
        rusage usage{};
        getrusage(RUSAGE_SELF, &usage);
        user = static_cast<double>(usage.ru_utime.tv_sec) +
               1e-6 * static_cast<double>(usage.ru_utime.tv_usec);
        gigabytes = 1024e-9 * static_cast<double>(usage.ru_maxrss);
    }
};

// Tells what each stage cost, all ranks together.
class Stages {
  public:
    Stages(const Session& session, const Say& say) : session_(session), say_(say) {}

    void finished(const std::string& what) {
        const Cost now;
        const double user = session_.sum(now.user - last_.user);
        const double gigabytes = session_.largest(now.gigabytes);
        if (session_.speaks())
            say_(fmt::format("{}: {:.1f} s, {:.1f} s of processors, at most {:.2f} GB per rank",
                             what, now.wall - last_.wall, user, gigabytes));
        last_ = now;
    }

  private:
    const Session& session_;
    const Say& say_;
    Cost last_;
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

LayerProblem share(LayerProblem problem, const Session& session) {
    auto& [mesh, materials, base, sides, largest_bulk_ratio, line_length] = problem;
    session.share(mesh.nodes);
    session.share(mesh.hexes);
    session.share(mesh.regions);
    session.share(mesh.faces);
    for (auto& material : materials) {
        session.share(&material.young, sizeof(double));
        session.share(&material.poisson, sizeof(double));
    }
    session.share(&base, sizeof(base));
    session.share(&sides, sizeof(sides));
    session.share(&largest_bulk_ratio, sizeof(largest_bulk_ratio));
    session.share(&line_length, sizeof(line_length));
    return problem;
}

CondensedLayer condense(const LayerProblem& problem, const Session& session, const Say& say) {
    Stages stages(session, say);
    const Stiffness stiffness(problem, session);
    stages.finished(fmt::format("stiffness of {} unknowns on {} ranks", stiffness.n_unknowns(),
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
        layer.points = stiffness.surface().points;
        layer.contact_mass = stiffness.surface().mass;
        layer.missing_reaction =
            missing_reaction(forces, layer.compliance, stiffness.contact_rows());
        if (layer.reaction_error() > largest_reaction_error)
            throw contact::NotConverged(fmt::format(
                "the condensed layer is wrong: the ground's reaction misses the force by {:.1e}",
                layer.reaction_error()));
    });
    stages.finished("compliance");
    return layer;
}

}  // namespace tricontact::fem::distributed

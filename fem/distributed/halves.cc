#include "fem/distributed/halves.h"

namespace tricontact::fem::distributed {

std::optional<CondensedLayer> condense_halves(const LayerProblem& problem, const Session& session,
                                              Stages& stages) {
    std::optional<HalfCondensation> half;
    session.agree([&] { half.emplace(problem, session.rank()); });
    if (!half->exists()) return std::nullopt;
    const double needed = session.sum_on_machine(half->predicted_bytes());
    if (session.largest(needed - available_bytes()) > 0) return std::nullopt;
    stages.finished("stiffness and analysis of a half by each of 2 ranks");
    CondensedLayer layer;
    session.agree([&] { layer = half->condense(); });
    session.add_on_first(layer.compliance);
    for (auto& missing : layer.missing_reaction) session.add_on_first(missing);
    stages.finished("both halves' factors and their compliances");
    if (!session.is_root()) return CondensedLayer{};
    return layer;
}

}  // namespace tricontact::fem::distributed

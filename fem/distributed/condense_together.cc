#include "fem/distributed/condense_together.h"

#include <exception>
#include <utility>

#include "fem/distributed/session.h"

namespace tricontact::fem::distributed {

namespace {

void condense_by(const Session& session, const SharedOrder& order) {
    while (true) {
        std::optional<LayerProblem> problem;
        session.agree_on_first([&] { problem = order.problem(); });
        bool is_needed = problem.has_value();
        session.broadcast(&is_needed, sizeof(is_needed));
        if (!is_needed) return;
        problem = broadcast(std::move(problem).value_or(LayerProblem{}), session);
        const auto layer = condense(*problem, session, order.say);
        session.agree_on_first([&] { order.keep(layer); });
    }
}

}  // namespace

void condense_together(const SharedOrder& order) {
    std::exception_ptr failure;
    {
        const Session session;
        try {
            session.abort_on_local_error([&] { condense_by(session, order); });
        } catch (...) {
            failure = std::current_exception();  // MPI is to end before this goes on
        }
    }
    if (failure) std::rethrow_exception(failure);
}

}  // namespace tricontact::fem::distributed

#include "contact/solvers/tangential_solver.h"

#include <fmt/format.h>

#include <algorithm>
#include <list>
#include <memory>
#include <utility>

#include "contact/base/error.h"
#include "contact/compliances/blocks.h"
#include "contact/solvers/tangential_newton.h"

namespace tricontact::contact {

namespace {

/// Nothing touches, nothing holds the indenter: it goes where its shifts are prescribed and stays
/// where no force is.
void leave_apart(const TangentialProblem& problem, TangentialSolution& solution) {
    if (const double force = prescribed_force(problem.control); force > 0)
        throw InputError(fmt::format(
            "tangential contact: nothing touches that could carry the force {:.6g} N; prescribe "
            "the shift, or no tangential force while the contact is lost",
            force));
    solution = {};
    solution.traction = solution.displacement = TangentialField(problem.bound.size());
    for (int d = 0; d < 2; ++d)
        if (problem.control[d].kind == TangentialControl::Kind::shift)
            solution.shift_increment[d] = problem.control[d].value;
}

constexpr std::size_t most_kept = std::size_t{64} << 20;  // [bytes]

/// What the operator of n points takes [bytes]: a matrix of 2n rows in double and single precision
/// and its factor.
std::size_t size_of_dense(std::size_t n) {
    return 4 * n * n * (sizeof(double) + 2 * sizeof(float));
}

}  // namespace

/// Dense operators, the last one used in front: a contact that rolls to and fro comes back to the
/// same points, and what was gathered and factorised for them.
class TangentialSolver::KeptOperators {
  public:
    explicit KeptOperators(const Compliance& compliance) : compliance_(compliance) {}

    /// One of at most most_kept.
    const ActiveOperator& among(const std::vector<std::size_t>& active) {
        const auto at = std::ranges::find(kept_, active, &Kept::active);
        if (at != kept_.end()) {
            kept_.splice(kept_.begin(), kept_, at);
            return *kept_.front().products;
        }
        make_room(size_of_dense(active.size()));
        Kept& own = kept_.front();
        own.products = make_active_operator(compliance_, active, &own.memory);
        own.active = active;
        return *own.products;
    }

  private:
    struct Kept {
        std::vector<std::size_t> active = {};  // empty without products
        std::size_t size = 0;                  // [bytes]
        OperatorMemory memory = {};
        std::unique_ptr<const ActiveOperator> products = {};
    };

    /// In front: new memory, or what has not been used for longest where there is no more.
    void make_room(std::size_t size) {
        if (kept_.empty() || size_ + size <= most_kept) {
            kept_.emplace_front();
        } else {
            kept_.splice(kept_.begin(), kept_, std::prev(kept_.end()));
            kept_.front().products.reset();
            kept_.front().active.clear();
        }
        Kept& own = kept_.front();
        size_ += std::max(own.size, size) - own.size;  // memory does not shrink
        own.size = std::max(own.size, size);
        for (; size_ > most_kept && kept_.size() > 1; kept_.pop_back()) size_ -= kept_.back().size;
    }

    const Compliance& compliance_;
    std::list<Kept> kept_;
    std::size_t size_ = 0;  // of all [bytes]
};

/// On from where the last ones ended, for Newton's steps since then led nowhere: gradients
/// alone descend without end.
void TangentialNewton::take_gradient_steps() {
    if (gradient_iterations_ > gradient_iterations) {
        solution_.traction = descended_.traction;
        solution_.shift_increment = descended_.shift_increment;
    } else {
        hand_over();
    }
    projected_gradient(compliance_, active_, products_, problem_, gradient_iterations_, solution_);
    gradient_iterations_ = std::min(2 * gradient_iterations_, most_gradient_iterations);
    descended_.traction = solution_.traction;
    descended_.shift_increment = solution_.shift_increment;
    take_over();
    update_slip();
}

TangentialSolver::TangentialSolver(const Compliance& compliance, double tolerance)
    : compliance_(compliance), tolerance_(tolerance) {}
TangentialSolver::~TangentialSolver() = default;

void TangentialSolver::solve(const TangentialProblem& problem, TangentialSolution& solution) {
    const Blocks points(problem.bound.size(), compliance_.n_threads());
    const std::vector<std::size_t> active =
        points.points_where([&](std::size_t i) { return problem.bound[i] > 0; });
    if (active.empty()) return leave_apart(problem, solution);
    const ActiveOperator& products = products_among(active);
    TangentialNewton(compliance_, active, products, problem, tolerance_, solution).run();
}

const ActiveOperator& TangentialSolver::products_among(const std::vector<std::size_t>& active) {
    if (compliance_.dense() && size_of_dense(active.size()) <= most_kept) {
        if (!kept_) kept_ = std::make_unique<KeptOperators>(compliance_);
        return kept_->among(active);
    }
    if (!products_ || active != active_) {
        products_.reset();
        active_ = active;
        products_ = make_active_operator(compliance_, active_, &memory_);
    }
    return *products_;
}

}  // namespace tricontact::contact

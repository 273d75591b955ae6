#include <fmt/format.h>

#include <chrono>
#include <exception>
#include <iostream>
#include <optional>
#include <stdexcept>

#include "app/fem_entries.h"
#include "contact/error.h"
#include "fem/distributed/layer.h"
#include "fem/layer_cache.h"
#include "fem/model.h"
#include "fem/workshop.h"
#include "io/case/case_reader.h"

namespace tricontact::app {

namespace {

void say(const std::string& line) {
    std::cerr << "fem: " << line << '\n';
}

/// A case's layer on its way into the cache.
class Order {
  public:
    explicit Order(const CondenseOptions& options)
        : case_(io::read_case(options.file, options.overrides)), cache_(case_.fem.cache) {
        if (cache_.folder().empty())
            throw contact::InputError(
                "fem.cache: condense keeps the layer for later runs, but nothing is to be kept; "
                "name a folder");
    }

    /// Empty when the layer is there already.
    std::optional<fem::LayerProblem> problem() {
        const fem::Say raw = [](const std::string& line) { std::cerr << line << '\n'; };
        auto problem = fem::problem_of(case_, fem::make_mesh(case_, raw));
        key_ = fem::LayerCache::key(problem);
        n_elements_ = problem.mesh.hexes.size();
        std::string why;
        if (const auto layer = cache_.load(key_, &why)) {
            say(fmt::format("condensed layer is there already: {} ({} contact nodes)",
                            cache_.path_of(key_), layer->points.size()));
            return std::nullopt;
        }
        if (!why.empty()) say(fmt::format("condensed layer recomputed: {}", why));
        return problem;
    }

    void keep(const fem::CondensedLayer& layer) const {
        std::string why;
        if (!cache_.store(key_, layer, &why))
            throw std::runtime_error("condensed layer not kept: " + why);
        const auto taken = std::chrono::steady_clock::now() - start_;
        say(
            fmt::format("layer of {} elements condensed to {} contact nodes in {:.1f} s, kept in "
                        "{}",
                        n_elements_, layer.points.size(),
                        std::chrono::duration<double>(taken).count(), cache_.path_of(key_)));
    }

  private:
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
    contact::Case case_;
    fem::LayerCache cache_;
    std::string key_;
    std::size_t n_elements_ = 0;
};

void condense_alone(const CondenseOptions& options) {
    Order order(options);
    if (const auto problem = order.problem()) order.keep(fem::condense(*problem));
}

/// The first rank reads, prints and writes; all condense.
void condense_together(const CondenseOptions& options, const fem::distributed::Session& session) {
    std::optional<Order> order;
    std::optional<fem::LayerProblem> problem;
    session.agree_on_first([&] {
        order.emplace(options);
        problem = order->problem();
    });
    bool is_needed = problem.has_value();
    session.share(&is_needed, sizeof(is_needed));
    if (!is_needed) return;
    problem = fem::distributed::share(std::move(problem).value_or(fem::LayerProblem{}), session);
    const auto layer = fem::distributed::condense(*problem, session, say);
    session.agree_on_first([&] { order->keep(layer); });
}

}  // namespace

void condense_layer(const CondenseOptions& options) {
    if (!options.distributed && !fem::distributed::started_by_launcher())
        return condense_alone(options);
    std::exception_ptr failure;
    {
        const fem::distributed::Session session;
        try {
            session.together([&] { condense_together(options, session); });
        } catch (...) {
            failure = std::current_exception();  // MPI is to end before this goes on
        }
    }
    if (failure) std::rethrow_exception(failure);
}

}  // namespace tricontact::app

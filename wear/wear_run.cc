#include "wear/wear_run.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>

#include "contact/base/error.h"
#include "contact/base/interruption.h"
#include "contact/base/state_bytes.h"
#include "contact/load_path.h"
#include "contact/path_cycles.h"

namespace tricontact::wear {

namespace {

using contact::WearingContact;
using contact::WornCycle;
using Field = std::vector<double>;

double largest_difference(const Field& a, const Field& b) {
    double largest = 0;
    for (std::size_t i = 0; i < a.size(); ++i) largest = std::max(largest, std::abs(a[i] - b[i]));
    return largest;
}

template <class Archive, class State>
void transfer(Archive& archive, State& s, double& next) {
    auto& c = s.cycle;
    archive(s.cycles, s.volume, s.depth, s.volume_error, s.depth_error, s.work, s.worn, next,
            c.rate, c.slip_path, c.pressure, c.volume, c.volume_by_means, c.work, c.stick_area,
            c.contact_area, c.normal_force, c.indentation, c.force_amplitude, c.shift_amplitude,
            c.shakedown_limit);
}

/// From state to state.
class Wearing {
  public:
    Wearing(WearingContact& contact, const contact::Wear& wear, const WearOptions& options)
        : contact_(contact), wear_(wear), options_(options) {}

    std::vector<WornState> go() {
        recall();
        if (states_.empty()) begin();
        while (now().cycles < wear_.cycles) {
            contact::interruption_point();
            if (options_.cycle_by_cycle)
                add_cycles(1);
            else
                jump();
            keep();
        }
        return std::move(states_);
    }

    int cycles_computed() const { return n_cycles_; }

  private:
    const WornState& now() const { return states_.back(); }

    WornCycle cycle(const Field& worn) {
        ++n_cycles_;
        return contact_.cycle(worn);
    }

    /// What lies between two worn profiles, whichever is worn more [m^3].
    double volume_between(const Field& a, const Field& b) const {
        double volume = 0;
        for (std::size_t i = 0; i < a.size(); ++i)
            volume += contact_.area()[i] * std::abs(a[i] - b[i]);
        return volume;
    }

    void begin() {
        WornState fresh;
        fresh.worn.assign(contact_.area().size(), 0);
        fresh.cycle = cycle(fresh.worn);
        refuse_fast(fresh.cycle);
        states_.push_back(std::move(fresh));
        keep();
    }

    /// A cycle wears the profile that it begins with. Where that changes much, worn profiles
    /// oscillate from cycle to cycle, and the contact becomes ever wider.
    static void refuse_fast(const WornCycle& cycle) {
        constexpr double most = .1;  // of the depth
        const double worn = *std::ranges::max_element(cycle.rate);
        if (cycle.indentation > 0 && worn > most * cycle.indentation)
            throw contact::InputError(fmt::format(
                "[wear]: the first cycle wears {:.3g} um, and is computed on the profile that it "
                "begins with, {:.3g} um deep: at most a tenth of that; reduce wear.coefficient or "
                "the slip of a cycle",
                1e6 * worn, 1e6 * cycle.indentation));
    }

    /// A whole number of cycles, even unless it is the last.
    double next_cycles() const {
        const double left = wear_.cycles - now().cycles;
        const double wanted = 2 * std::floor(std::max(next_, 2.) / 2);
        return wanted + 1 >= left ? left : wanted;
    }

    void jump() {
        for (;;) {
            const double n = next_cycles();
            if (n < 2) return add_cycles(1);
            const WornState& from = now();
            const Field whole = contact_.jump(from.worn, from.cycle, n);
            const Field half = contact_.jump(from.worn, from.cycle, n / 2);
            const WornCycle middle = cycle(half);
            const Field twice = contact_.jump(half, middle, n / 2);
            const double error = volume_between(whole, twice);
            const double allowed = wear_.tolerance * std::max(volume_between(from.worn, twice),
                                                              share_of_all * from.volume);
            next_ = n * (error > 0 ? std::clamp(safety * std::sqrt(allowed / error), least_factor,
                                                largest_factor)
                                   : largest_factor);
            if (error <= allowed) return accept({whole, half, twice}, middle, n, error);
            if (n <= 2) return add_cycles(static_cast<int>(n));
        }
    }

    /// Worn depths after a jump, after one of half its cycles, after two of these.
    struct Jumps {
        const Field &whole, &half, &twice;
    };

    /// Extrapolated, but where the second half wears less than a third of the first: there a jump
    /// wears off most of what is left, and the extrapolation of 1/(1 + z) would do more than all.
    void accept(const Jumps& jumps, const WornCycle& middle, double n, double error) {
        constexpr double nearly_worn = 1. / 3;
        const auto& [whole, half, twice] = jumps;
        const Field& from = now().worn;
        WornState to;
        to.worn = twice;
        for (std::size_t i = 0; i < twice.size(); ++i)
            if (twice[i] - half[i] > nearly_worn * (half[i] - from[i]) && half[i] > from[i])
                to.worn[i] = std::max(from[i], 2 * twice[i] - whole[i]);
        const double first = now().cycle.work, between = middle.work;
        const auto work = [=](double last) { return n / 6 * (first + 4 * between + last); };
        add(std::move(to), n, work, largest_difference(whole, twice), error);
    }

    /// One by one, which is no approximation.
    void add_cycles(int n) {
        for (int k = 0; k < n; ++k) {
            WornState to;
            to.worn = now().worn;
            for (std::size_t i = 0; i < to.worn.size(); ++i) to.worn[i] += now().cycle.rate[i];
            const double work = now().cycle.work;
            add(
                std::move(to), 1, [=](double) { return work; }, 0, 0);
        }
    }

    template <class Work>
    void add(WornState to, double n, const Work& work, double error, double volume_error) {
        const WornState& from = now();
        to.cycles = from.cycles + n;
        to.cycle = cycle(to.worn);
        to.depth = *std::ranges::max_element(to.worn);
        for (std::size_t i = 0; i < to.worn.size(); ++i)
            to.volume += contact_.area()[i] * to.worn[i];
        to.work = from.work + work(to.cycle.work);
        const double by_sum = error > 0 ? .5 : 0;
        to.depth_error =
            from.depth_error + error + by_sum * largest_difference(from.cycle.rate, to.cycle.rate);
        to.volume_error = from.volume_error + volume_error +
                          by_sum * std::abs(from.cycle.volume - to.cycle.volume);
        states_.push_back(std::move(to));
        if (options_.show) options_.show(now());
    }

    void recall() {
        if (!options_.kept) return;
        for (const std::string& bytes : options_.kept->found()) {
            contact::StateReader in(bytes);
            WornState state;
            transfer(in, state, next_);
            in(n_cycles_);
            states_.push_back(std::move(state));
        }
        n_kept_ = states_.size();
    }

    void keep() {
        for (; n_kept_ < states_.size(); ++n_kept_) {
            if (!options_.kept) continue;
            contact::StateWriter out;
            transfer(out, states_[n_kept_], next_);
            out(n_cycles_);
            options_.kept->append(out.take());
        }
    }

    static constexpr double share_of_all = .05, safety = .85, least_factor = .25,
                            largest_factor = 4;

    WearingContact& contact_;
    const contact::Wear& wear_;
    const WearOptions& options_;
    std::vector<WornState> states_;
    std::size_t n_kept_ = 0;
    double next_ = 2;  // cycles of the next jump
    int n_cycles_ = 0;
};

/// Onto the grid that kept states are on.
void enlarge_as_kept(KeptStates& kept, WearingContact& contact) {
    const auto found = kept.found();
    if (found.empty()) return;
    contact::StateReader in(found.front());
    WornState first;
    double next = 0;
    transfer(in, first, next);
    while (contact.area().size() < first.worn.size())
        contact.enlarge(tricontact::contact::ContactAtEdge("the kept states are on a larger grid"));
    if (contact.area().size() != first.worn.size()) kept.clear();
}

}  // namespace

const char* name_of(WearRegime regime) {
    switch (regime) {
        case WearRegime::stick:
            return "stick";
        case WearRegime::partial_slip:
            return "partial-slip";
        case WearRegime::gross_slip:
            break;
    }
    return "gross-slip";
}

WearRegime WornState::regime() const {
    if (cycle.stick_area == 0) return WearRegime::gross_slip;
    return cycle.stick_area < cycle.contact_area ? WearRegime::partial_slip : WearRegime::stick;
}

double WornState::stick_radius() const {
    return std::sqrt(cycle.stick_area / std::numbers::pi);
}

double WornState::contact_radius() const {
    return std::sqrt(cycle.contact_area / std::numbers::pi);
}

contact::WearProblem wear_problem(const contact::Case& c, bool coupled) {
    const auto cycles = contact::repeated_cycles(*c.prescribed_path);
    if (cycles.empty()) throw contact::InputError("[wear]: the path has no closed cycle");
    const contact::PathCycle& cycle = cycles.back();
    const contact::LoadPath path = contact::make_load_path(c, 0, 0);
    contact::WearProblem problem{.law = c.of<contact::Wear>(),
                                 .steps = contact::pressing_of_path(c, path, coupled)};
    problem.n_before = problem.steps.size();
    for (const contact::LoadStep& step : path.loading) {
        if (step.phase > static_cast<double>(cycle.end)) break;
        problem.steps.push_back(step);
        if (step.phase <= static_cast<double>(cycle.begin)) problem.n_before = problem.steps.size();
    }
    return problem;
}

WearHistory run_wear(const contact::Case& c, contact::Model& model, const WearOptions& options) {
    auto* const wearable = dynamic_cast<contact::Wearable*>(&model);
    if (!wearable)
        throw contact::InputError("[wear]: " + model.name() +
                                  " has no worn profile; leave it out, or take bem");
    const contact::WearProblem problem = wear_problem(c, model.is_coupled());
    const auto contact = wearable->wearing(problem);
    if (options.kept) enlarge_as_kept(*options.kept, *contact);
    for (;;) {
        try {
            Wearing wearing(*contact, problem.law, options);
            WearHistory history{.model = model.name(), .states = wearing.go()};
            history.cycles_computed = wearing.cycles_computed();
            if (options.at_end) options.at_end(*contact, history);
            return history;
        } catch (const contact::ContactAtEdge& reached) {
            contact->enlarge(reached);
            if (options.kept) options.kept->clear();
        }
    }
}

}  // namespace tricontact::wear

// Random cases rolled for N, 2N and 4N periods: what is decided stays decided, and what the verdict
// says is to come, comes:
//   random_verdicts SEED COUNT [N]       the cases 0 to COUNT - 1; N = 8 unless given
//   random_verdicts SEED --only I [N]    case I alone, its text first
// A fifth of the cases are line contacts, one in sixteen on layers is computed by coarse finite
// elements. Ends with 1 if one verdict is wrong.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <exception>
#include <map>
#include <string>
#include <vector>

#include "contact/base/error.h"
#include "contact/run.h"
#include "contact/verdict.h"
#include "fem/settings.h"
#include "io/case/case_reader.h"
#include "mdr/settings.h"
#include "tests/random/case_generator.h"
#include "tests/random/random_models.h"

namespace tricontact::random_cases {
namespace {

using contact::Case;
using contact::History;
using contact::State;

constexpr int most_springs = 3000;  // the verdict does not need the resolution

/// As drawn; every fifth body a cylinder as long as its contact is wide, where that is one.
std::string text_of(std::uint64_t seed, std::uint64_t index) {
    std::string text = random_case(seed, index);
    const std::string round = "shape = \"paraboloid\"\nradius = \"";
    const auto at = text.find(round);
    if (index % 5 != 0 || at == std::string::npos || text.find("normal_force") == std::string::npos)
        return text;
    const double radius = std::stod(text.substr(at + round.size()));
    const auto angle = text.find("angle = ", at);  // a cylinder rolls along x
    text.erase(angle, text.find('\n', angle) + 1 - angle);
    return text.replace(
        at, round.size(),
        fmt::format("shape = \"cylinder\"\nlength = \"{} m\"\nradius = \"", radius / 10));
}

Case case_of(const std::string& text, [[maybe_unused]] std::uint64_t index) {
    Case c = io::parse_case(text, "case.toml");
#ifdef TRICONTACT_WITH_FEM
    if (c.layer.thickness && index % 16 == 15) {
        c.models = {"fem"};
        c.of<fem::Settings>().size = half_space_scales(c).contact_radius / 2;
        c.of<fem::Settings>().accuracy.reset();
        c.of<fem::Settings>().cache = "none";
        c = io::parse_case(io::write_case(c), "case.toml");
    }
#endif
    return c;
}

class Trial {
  public:
    Trial(Case c, int n) : case_(std::move(c)) {
        case_.of<mdr::Settings>().springs =
            std::min(case_.of<mdr::Settings>().springs, most_springs);
        case_.rolling->run_all = true;
        for (const int periods : {n, 2 * n, 4 * n}) {
            case_.rolling->periods = periods;
            runs_.push_back(contact::run(case_, *make_model(case_)));
        }
        unit_ = runs_.back().scales.unit_shift;
        compare_prefixes();
        for (std::size_t i = 0; i + 1 < runs_.size(); ++i) compare(runs_[i], runs_.back());
        compare_with_limit();
    }

    State state() const { return runs_.back().verdict.state; }
    std::string wrong;

  private:
    template <class... Arguments>
    void complain(fmt::format_string<Arguments...> format, Arguments&&... arguments) {
        wrong += fmt::format(format, std::forward<Arguments>(arguments)...) + "; ";
    }

    /// A longer run begins with the shorter one, to the last bit.
    void compare_prefixes() {
        for (const History& h : runs_)
            if (!std::ranges::equal(
                    h.shift_per_period,
                    std::span(runs_.back().shift_per_period).first(h.shift_per_period.size())))
                complain("the shifts of {} periods are others", h.shift_per_period.size());
    }

    void compare(const History& brief, const History& all) {
        const auto n = brief.shift_per_period.size();
        const contact::Verdict &early = brief.verdict, &late = all.verdict;
        if (early.state == State::undecided) {
            if (early.missing.empty()) complain("undecided, nothing missing");
        } else if (early.state != late.state) {
            complain("{} after {} periods, {} in the end", name_of(early.state), n,
                     name_of(late.state));
        }
        if (early.state == State::ratcheting)
            compare_increments(brief, all);
        else
            compare_shifts(brief, all);
        const double works = std::abs(all.dissipation_per_period.back()) / all.friction_limit;
        const double negligible = known().negligible_work * unit_;
        if (early.state == State::cyclic_slip && works < negligible)
            complain("cyclic slip after {} periods, but no work in the end", n);
    }

    contact::Judged known() const {
        return judged(case_, make_model(case_)->step_accuracy(), false, runs_.back().amplitude, 0);
    }

    static double last_increment(const History& h) {
        const auto& u = h.shift_per_period;
        return u.back() - (u.size() > 1 ? u[u.size() - 2] : h.static_shift);
    }

    /// What was bounded stays inside: the increments of ratcheting, or of undecided, not.
    void compare_increments(const History& brief, const History& all) {
        const double change = std::abs(last_increment(all) - last_increment(brief)) / unit_;
        const double allowed = brief.verdict.remaining_error;
        // Of a series, but not of a limit that knows better, increments cannot sink to nothing.
        if (change > allowed + rounding() && (!brief.verdict.by_limit || std::isfinite(allowed)))
            complain("increments change by {:.2e} from {:.2e} after {} periods, allowed {:.2e}",
                     change, last_increment(brief) / unit_, brief.shift_per_period.size(), allowed);
    }

    void compare_shifts(const History& brief, const History& all) {
        const double way = (all.shift_per_period.back() - brief.shift_per_period.back()) / unit_;
        const double since = static_cast<double>(all.shift_per_period.size());
        const double off = std::abs(way - brief.verdict.remaining + all.verdict.remaining);
        const double allowed = brief.verdict.remaining_error + all.verdict.remaining_error +
                               since * known().negligible_shift + rounding();
        if (off > allowed)
            complain("the shift comes to {:.2e} instead of {:.2e} +- {:.1e} after {} periods",
                     way + all.verdict.remaining, brief.verdict.remaining,
                     brief.verdict.remaining_error, brief.shift_per_period.size());
    }

    double rounding() const {
        return 1e-12 * std::abs(runs_.back().shift_per_period.back()) / unit_;
    }

    /// Away from it by 0.1 %, the limit of an uncoupled contact and the series agree.
    void compare_with_limit() {
        const History& all = runs_.back();
        if (!all.verdict.by_limit) return;
        const double f = all.tangential_force / all.friction_limit;
        const double limit = all.limit_tangential_ratio;
        if (std::abs(f - limit) < 1e-3 * limit) return;
        const State fate =
            contact::run(case_, *make_model(case_), {}, known().negligible_shift).verdict.state;
        if (fate != State::undecided && fate != all.verdict.state)
            complain("{} by the series, f_T = {}, limit {}", name_of(fate), f, limit);
        if ((all.verdict.state == State::ratcheting) != (f > limit))
            complain("wrong side of the limit");
    }

    Case case_;
    std::vector<History> runs_;
    double unit_ = 0;
};

/// Prints what is wrong; false if something is.
bool try_case(const std::string& text, std::uint64_t index, int n,
              std::map<std::string, int>& ends) {
    try {
        const Trial trial(case_of(text, index), n);
        ++ends[name_of(trial.state())];
        if (trial.wrong.empty()) return true;
        fmt::print("{}: {}\n", index, trial.wrong);
        return false;
    } catch (const contact::InputError&) {
        ++ends["refused"];
    } catch (const std::exception& error) {  // what random_cases counts
        ++ends["not converged"];
        fmt::print("{}: {}\n", index, error.what());
    }
    return true;
}

int run(std::uint64_t seed, std::uint64_t first, std::uint64_t end, int n) {
    std::map<std::string, int> ends;
    int n_wrong = 0;
    for (std::uint64_t index = first; index < end; ++index)
        n_wrong += !try_case(text_of(seed, index), index, n, ends);
    fmt::print("seed {}: {} wrong", seed, n_wrong);
    for (const auto& [name, count] : ends) fmt::print(", {} {}", count, name);
    fmt::print("\n");
    return n_wrong == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}

}  // namespace
}  // namespace tricontact::random_cases

int main(int argc, char** argv) {
    using namespace tricontact::random_cases;
    const bool only = argc >= 4 && std::string(argv[2]) == "--only";
    const int needed = only ? 4 : 3;
    if (argc != needed && argc != needed + 1) {
        fmt::print(stderr, "usage: random_verdicts SEED COUNT [N] | SEED --only I [N]\n");
        return 2;
    }
    try {
        const std::uint64_t seed = std::stoull(argv[1]), index = std::stoull(argv[needed - 1]);
        const int n = argc > needed ? std::stoi(argv[needed]) : 8;
        if (!only) return run(seed, 0, index, n);
        fmt::print("{}", text_of(seed, index));
        return run(seed, index, index + 1, n);
    } catch (const std::exception& error) {
        fmt::print(stderr, "random_verdicts: {}\n", error.what());
        return 2;
    }
}

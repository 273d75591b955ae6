// Random cases, each of which has to converge or to be refused before it runs:
//   random_cases SEED COUNT        the cases 0 to COUNT - 1
//   random_cases SEED --only N     case N alone, its text first
// Ends with 1 if more than one in a thousand fails. What only the run can tell, that a contact
// slides whose pressures friction changes, is counted as refused after it began.

#include <fmt/format.h>

#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <exception>
#include <map>
#include <stdexcept>
#include <string>

#include "contact/base/error.h"
#include "contact/run.h"
#include "io/case/case_reader.h"
#include "tests/random/case_generator.h"
#include "tests/random/random_models.h"

namespace tricontact::random_cases {
namespace {

constexpr double allowed_share = 1e-3;  // of cases that fail

enum class End { computed, refused, refused_late, failed };

struct Outcome {
    End end = End::computed;
    std::string why{};
    double seconds = 0;
};

Outcome compute(const std::string& text) {
    bool runs = false;
    try {
        const contact::Case c = io::parse_case(text, "case.toml");
        const auto model = make_model(c);
        const contact::History history =
            contact::run(c, *model, [&](const auto&...) { runs = true; });
        if (!history.audit.passed()) return {End::failed, "audit failed"};
        for (const double value : history.shift_per_period)
            if (!std::isfinite(value)) return {End::failed, "shift is not finite"};
        return {End::computed};
    } catch (const contact::InputError& error) {
        return {runs ? End::refused_late : End::refused, error.what()};
    } catch (const std::exception& error) {
        return {End::failed, error.what()};
    }
}

Outcome timed(const std::string& text) {
    const auto start = std::chrono::steady_clock::now();
    Outcome outcome = compute(text);
    outcome.seconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return outcome;
}

const char* name_of(End end) {
    switch (end) {
        case End::computed:
            return "computed";
        case End::refused:
            return "refused";
        case End::refused_late:
            return "refused after it began";
        case End::failed:
            return "failed";
    }
    return "";
}

int run_all(std::uint64_t seed, std::uint64_t count) {
    std::map<End, int> ends;
    Outcome slowest;
    std::uint64_t slowest_case = 0;
    for (std::uint64_t n = 0; n < count; ++n) {
        const Outcome outcome = timed(random_case(seed, n));
        ++ends[outcome.end];
        if (outcome.end != End::computed)
            fmt::print("{} {}: {}\n", n, name_of(outcome.end), outcome.why);
        if (outcome.seconds < slowest.seconds) continue;
        slowest = outcome;
        slowest_case = n;
    }
    fmt::print(
        "seed {}: {} cases, {} computed, {} refused, {} refused after they began, {} failed;"
        " slowest: {} with {:.1f} s\n",
        seed, count, ends[End::computed], ends[End::refused], ends[End::refused_late],
        ends[End::failed], slowest_case, slowest.seconds);
    return ends[End::failed] <= allowed_share * static_cast<double>(count) ? EXIT_SUCCESS
                                                                           : EXIT_FAILURE;
}

int run_one(std::uint64_t seed, std::uint64_t index) {
    const std::string text = random_case(seed, index);
    fmt::print("{}", text);
    const Outcome outcome = timed(text);
    fmt::print("# {} in {:.2f} s {}\n", name_of(outcome.end), outcome.seconds, outcome.why);
    return outcome.end == End::failed ? EXIT_FAILURE : EXIT_SUCCESS;
}

}  // namespace
}  // namespace tricontact::random_cases

int main(int argc, char** argv) {
    using namespace tricontact::random_cases;
    const bool only = argc == 4 && std::string(argv[2]) == "--only";
    if (argc != 3 && !only) {
        fmt::print(stderr, "usage: random_cases SEED COUNT | SEED --only N\n");
        return 2;
    }
    try {
        const std::uint64_t seed = std::stoull(argv[1]), n = std::stoull(argv[argc - 1]);
        return only ? run_one(seed, n) : run_all(seed, n);
    } catch (const std::exception& error) {
        fmt::print(stderr, "random_cases: {}\n", error.what());
        return 2;
    }
}

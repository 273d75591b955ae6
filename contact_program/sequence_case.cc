#include "contact_program/sequence_case.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>
#include <vector>

#include "contact_program/sequence.h"
#include "io/case/case_reader.h"
#include "io/keys/messages.h"

namespace tricontact::contact_program {

namespace {

using contact::Vector2;
using contact::operator-;

constexpr double rounding = 1e-6;         // of values in a file, relative
constexpr double offset_rounding = 1e-3;  // of offsets, in cells

double length(const Vector2& v) {
    return std::hypot(v[0], v[1]);
}

/// What is pressed, loaded and rolled back and forth in whole periods of equal steps.
class RolledSequence {
  public:
    explicit RolledSequence(ProgramSequence cases) : cases_(cases) {}

    /// False for another sequence.
    bool find() {
        const bool turns = std::ranges::any_of(
            cases_, [](const ProgramCase& one) { return one.step.rotation != 0; });
        return !head().distance.heights && !turns && find_loading() && find_period();
    }

    std::string text(const std::string& name, bool is_coupled) const {
        return bodies_text(head(), name) + load_text(is_coupled) + rolling_text() +
               cells_text(head());
    }

    /// Whether its steps are those of a case. How an uncoupled contact is pressed is all the same.
    bool has_steps(const std::vector<SequenceStep>& of_case, bool is_coupled) const {
        std::span<const SequenceStep> expected = of_case;
        ProgramSequence given = cases_;
        if (!is_coupled) {
            for (const ProgramCase& one : given.first(n_pressing()))
                if (one.step.tangential && length(one.step.values()) != 0) return false;
            expected = expected.subspan(1);
            given = given.subspan(n_pressing());
        }
        return std::ranges::equal(given, expected,
                                  [&](const ProgramCase& one, const SequenceStep& step) {
                                      return agrees(one.step, step);
                                  });
    }

  private:
    const ProgramCase& head() const { return cases_.front(); }
    const ProgramCase& loading() const { return cases_[n_upright_ - 1]; }
    std::size_t n_pressing() const { return n_upright_ - 1; }

    bool is_upright(const SequenceStep& step) const {
        return length(step.offset) <= offset_rounding * head().spacing[0];
    }

    /// The last step before the indenter moves.
    bool find_loading() {
        while (n_upright_ < cases_.size() && is_upright(cases_[n_upright_].step)) ++n_upright_;
        if (n_upright_ == 0) return false;
        const SequenceStep& load = loading().step;
        const double ratio = load.along[0].value;
        return load.tangential && load.is_forced(0) && ratio >= 0 && ratio < 1;
    }

    /// A period of equal steps: out to the first turning point, and three quarters more.
    bool find_period() {
        const ProgramSequence rolling = cases_.subspan(n_upright_);
        if (rolling.empty()) return true;
        double way = 0;
        while (n_quarter_ < rolling.size() && length(rolling[n_quarter_].step.offset) > way)
            way = length(rolling[n_quarter_++].step.offset);
        turning_point_ = rolling[n_quarter_ - 1].step.offset;
        n_periods_ = rolling.size() / (4 * n_quarter_);
        return rolling.size() % (4 * n_quarter_) == 0;
    }

    std::string load_text(bool is_coupled) const {
        std::string text =
            "[load]\n" + normal_text(loading()) +
            fmt::format("tangential_ratio = {}\n", io::toml_number(loading().step.along[0].value));
        if (!is_coupled || n_pressing() == 0) return text;
        if (!head().step.tangential) return text + "press = \"frictionless\"\n";
        return text + fmt::format("press_steps = {}\n", n_pressing());
    }

    std::string rolling_text() const {
        if (n_periods_ == 0) return {};
        const std::string steps = n_quarter_ == 1
                                      ? "steps = \"turning-points\""
                                      : fmt::format("steps_per_quarter = {}", n_quarter_);
        return fmt::format(
            "[rolling]\namplitude = \"{} mm\"\nangle = \"{} deg\"\nperiods = {}\nrun_all = true\n"
            "{}\n",
            1e3 * length(turning_point_),
            std::atan2(turning_point_[1], turning_point_[0]) * 180 / std::numbers::pi, n_periods_,
            steps);
    }

    bool agrees(const SequenceStep& given, const SequenceStep& expected) const {
        const Vector2 aside = given.offset - expected.offset;
        return given.tangential == expected.tangential &&
               is_close(given.normal.value, expected.normal.value) &&
               length(aside) <= offset_rounding * head().spacing[0] &&
               (!given.tangential || is_loaded_as(given, expected.along[0].value));
    }

    /// Shifts may stand for forces of zero where the contact is symmetric.
    bool is_loaded_as(const SequenceStep& given, double ratio) const {
        const bool symmetric_in_y = std::abs(turning_point_[1]) <= rounding * head().spacing[0];
        const bool along = given.is_forced(0) || (ratio == 0 && is_upright(given));
        const bool across = given.is_forced(1) || !given.is_forced(0) || symmetric_in_y;
        return along && across && is_close(given.along[0].value, ratio) &&
               given.along[1].value == 0;
    }

    ProgramSequence cases_;
    std::size_t n_upright_ = 0;  // steps before the indenter moves
    std::size_t n_quarter_ = 0, n_periods_ = 0;
    Vector2 turning_point_{};
};

}  // namespace

std::optional<std::string> sequence_case(ProgramSequence steps, const std::string& name,
                                         bool is_coupled, const std::string& heading) {
    RolledSequence sequence(steps);
    if (!sequence.find()) return {};
    const std::string text = heading + sequence.text(name, is_coupled);
    const auto of_case = sequence_of(io::parse_case(text, name + ", as a case"), is_coupled);
    return sequence.has_steps(of_case, is_coupled) ? std::optional(text) : std::nullopt;
}

}  // namespace tricontact::contact_program

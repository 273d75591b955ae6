#include "io/contact_program/sequence_case.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "io/case/case_reader.h"
#include "io/contact_program/sequence.h"
#include "io/keys/messages.h"

namespace tricontact::io {

namespace {

using contact::Vector2;

constexpr double rounding = 1e-6;         // of values in a file, relative
constexpr double offset_rounding = 1e-3;  // of offsets, in cells

double length(const Vector2& v) {
    return std::hypot(v[0], v[1]);
}

/// Reads the case out of a sequence.
class SequenceReading {
  public:
    SequenceReading(ProgramSequence steps, const std::string& name) : name_(name), steps_(steps) {
        if (head().distance.heights)
            refuse(head().distance.line, "IBASE", "heights do not define how the body moves on",
                   "give 1");
        for (const ProgramCase& one : steps)
            if (one.rotation != 0)
                refuse(one.loads_line, fmt::format("CPHI = {}", one.rotation),
                       "a case that rolls back and forth has no twist", "give 0");
        find_loading();
        find_period();
    }

    std::string text(bool is_coupled) const {
        return bodies_text(head(), name_) + load_text(is_coupled) + rolling_text() +
               cells_text(head());
    }

    /// Each step of the file is one of the case's. How an uncoupled contact is pressed is all the
    /// same.
    void check_steps(std::vector<SequenceStep> expected, bool is_coupled) const {
        ProgramSequence given = steps_;
        if (!is_coupled) {
            for (const ProgramCase& one : given.first(n_pressing()))
                if (one.digits.tangential == 1 && length(one.tangential) != 0)
                    refuse(one.loads_line, "FX, FY",
                           "load the contact tangentially in several steps", "load it in one");
            expected.erase(expected.begin());
            given = given.subspan(n_pressing());
        }
        if (given.size() != expected.size())
            refuse(given.front().digits.line, "the sequence",
                   fmt::format("has {} steps where the case has {}", given.size(), expected.size()),
                   "press a coupled contact ahead of the tangential force");
        for (std::size_t k = 0; k < given.size(); ++k) check_step(given[k], expected[k]);
    }

  private:
    const ProgramCase& head() const { return steps_.front(); }
    const ProgramCase& loading() const { return steps_[n_upright_ - 1]; }
    std::size_t n_pressing() const { return n_upright_ - 1; }

    [[noreturn]] void refuse(int line, const std::string& subject, const std::string& rule,
                             const std::string& remedy) const {
        fail(fmt::format("{}:{}:1", name_, line), subject, rule, remedy);
    }

    bool is_upright(const ProgramCase& one) const {
        return length(one.distance.offset) <= offset_rounding * head().spacing[0];
    }

    /// The last step before the indenter moves.
    void find_loading() {
        while (n_upright_ < steps_.size() && is_upright(steps_[n_upright_])) ++n_upright_;
        if (n_upright_ == 0)
            refuse(head().distance.data_line, "B(4), B(5)", "the indenter does not begin upright",
                   "put its lowest point to the origin");
        const ProgramCase& load = loading();
        if (load.digits.tangential != 1 || load.digits.force == 0)
            refuse(load.digits.line,
                   fmt::format("T = {}, F = {}", load.digits.tangential, load.digits.force),
                   "the tangential force is due here",
                   "give T = 1 and F = 2 with FX, which may be 0");
        if (load.tangential[0] > 0 || load.tangential[0] <= -1)
            refuse(load.loads_line, fmt::format("FX = {}", load.tangential[0]),
                   "must be above -1, and not positive: on body 1, against the load on body 2",
                   "let x point along the load on body 2");
    }

    /// A period of equal steps: out to the first turning point, and three quarters more.
    void find_period() {
        const ProgramSequence rolling = steps_.subspan(n_upright_);
        if (rolling.empty()) return;
        double way = 0;
        while (n_quarter_ < rolling.size() && length(rolling[n_quarter_].distance.offset) > way)
            way = length(rolling[n_quarter_++].distance.offset);
        turning_point_ = rolling[n_quarter_ - 1].distance.offset;
        if (rolling.size() % (4 * n_quarter_) != 0)
            refuse(rolling.back().digits.line, "the path",
                   fmt::format("ends within a period of {} steps", 4 * n_quarter_),
                   "roll back and forth in whole periods; what rolls on is computed by tricontact "
                   "run");
        n_periods_ = rolling.size() / (4 * n_quarter_);
    }

    std::string load_text(bool is_coupled) const {
        std::string text =
            "[load]\n" + normal_text(loading()) +
            fmt::format("tangential_ratio = {}\n", toml_number(std::abs(loading().tangential[0])));
        if (!is_coupled || n_pressing() == 0) return text;
        if (head().digits.tangential == 0) return text + "press = \"frictionless\"\n";
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

    void check_step(const ProgramCase& given, const SequenceStep& expected) const {
        const auto demand = [&](bool holds, int line, const std::string& what,
                                const std::string& rule) {
            if (!holds)
                refuse(line, what, rule,
                       "give the steps of a case (docs/reference/contact-program.md)");
        };
        demand(given.digits.tangential == expected.tangential, given.digits.line,
               fmt::format("T = {}", given.digits.tangential), "is another kind of step than due");
        demand(is_close(program_load(given), expected.normal.value), given.loads_line,
               fmt::format("{} {}", given.digits.normal == 1 ? "FN" : "PEN", program_load(given)),
               fmt::format("is not {:.7g}, which equal steps of pressing, then constant loads, "
                           "would have (SI units)",
                           expected.normal.value));
        demand(length({given.distance.offset[0] - expected.offset[0],
                       given.distance.offset[1] - expected.offset[1]}) <=
                   offset_rounding * head().spacing[0],
               given.distance.data_line, "B(4), B(5)",
               fmt::format("put the indenter elsewhere than to ({:.7g}, {:.7g}) mm, where equal "
                           "steps of a triangular path have it",
                           1e3 * expected.offset[0] + 0.0, 1e3 * expected.offset[1] + 0.0));
        if (given.digits.tangential == 1) check_tangential(given, expected);
    }

    /// Shifts may stand for forces of zero where the contact is symmetric.
    void check_tangential(const ProgramCase& given, const SequenceStep& expected) const {
        const int forces = given.digits.force;
        const bool symmetric_in_y = std::abs(turning_point_[1]) <= rounding * head().spacing[0];
        const double ratio = expected.along[0].value;
        if ((forces == 0 && (ratio != 0 || !is_upright(given))) || (forces == 1 && !symmetric_in_y))
            refuse(given.digits.line, fmt::format("F = {}", forces),
                   "prescribes a shift where a case has a force", "give 2");
        if (!is_close(-given.tangential[0], ratio))
            refuse(given.loads_line, fmt::format("FX = {}", given.tangential[0]),
                   fmt::format("is not {:.7g}, the load of the case", -ratio), "keep it constant");
        if (given.tangential[1] != 0)
            refuse(given.loads_line, "FY", "there is no load along y", "give 0");
    }

    const std::string& name_;
    ProgramSequence steps_;
    std::size_t n_upright_ = 0;  // steps before the indenter moves
    std::size_t n_quarter_ = 0, n_periods_ = 0;
    Vector2 turning_point_{};
};

}  // namespace

std::string sequence_case(ProgramSequence steps, const std::string& name, bool is_coupled,
                          const std::string& heading) {
    const SequenceReading reading(steps, name);
    const std::string text = heading + reading.text(is_coupled);
    reading.check_steps(sequence_of(parse_case(text, name + ", as a case"), is_coupled),
                        is_coupled);
    return text;
}

}  // namespace tricontact::io

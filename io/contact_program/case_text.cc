#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <optional>
#include <span>

#include "io/case/case_reader.h"
#include "io/contact_program/program_case.h"
#include "io/contact_program/sequence.h"
#include "io/keys/messages.h"

namespace tricontact::io {

namespace {

using contact::Vector2;
using Sequence = std::span<const ProgramCase>;

constexpr double rounding = 1e-6;         // of values in a file, relative
constexpr double offset_rounding = 1e-3;  // of offsets, in cells
constexpr double rigid_from = rigid_shear_ratio / 10;

double length(const Vector2& v) {
    return std::hypot(v[0], v[1]);
}

bool is_close(double a, double b) {
    return std::abs(a - b) <= rounding * std::max(std::abs(a), std::abs(b));
}

/// Reads the case out of the cases of a file.
class SequenceReading {
  public:
    SequenceReading(std::string text, const std::string& name)
        : name_(name), cases_(read_program_cases(std::move(text), name)) {
        find_sequence();
        check_all_alike();
        check_body();
        find_loading();
        find_period();
    }

    contact::MaterialPair materials() const {
        return {is_rigid() ? std::nullopt : std::optional(material(0)), material(1)};
    }

    ImportedCase imported(bool is_coupled) const {
        return {fmt::format("title = {}\nmodels = [\"bem\"]\n{}{}{}{}[bem]\nspacing = \"{} mm\"\n"
                            "tolerance = {}\n",
                            toml_string("Sequence of CONTACT, " + name_), body_text(),
                            material_text(), load_text(is_coupled), rolling_text(),
                            1e3 * head().spacing[0], toml_number(head().tolerance)),
                steps_.size(), cases_.size() - steps_.size()};
    }

    /// Each step of the file is one of the case's. How an uncoupled contact is pressed is all the
    /// same.
    void check_steps(std::vector<SequenceStep> expected, bool is_coupled) const {
        Sequence given = steps_;
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
    bool is_line_contact() const { return head().n_y == 1; }

    [[noreturn]] void refuse(int line, const std::string& subject, const std::string& rule,
                             const std::string& remedy) const {
        fail(fmt::format("{}:{}:1", name_, line), subject, rule, remedy);
    }

    /// The last case that begins again; what stands ahead may be normal problems.
    void find_sequence() {
        std::size_t start = cases_.size();
        do --start;
        while (start > 0 && cases_[start].digits.previous != 2);
        for (std::size_t k = 0; k < start; ++k)
            if (cases_[k].digits.tangential != 0)
                refuse(cases_[start].digits.line, "P = 2", "begins another sequence of steps",
                       "keep one sequence per file");
        steps_ = Sequence(cases_).subspan(start);
    }

    void check_all_alike() const {
        for (const ProgramCase& one : steps_) {
            const auto demand = [&](bool same, const char* what) {
                if (!same) refuse(one.digits.line, what, "changes within the sequence", "keep it");
            };
            demand(is_close(one.friction_coefficient, head().friction_coefficient), "friction");
            demand(one.poisson == head().poisson && one.shear_modulus == head().shear_modulus,
                   "the material");
            demand(one.n_x == head().n_x && one.n_y == head().n_y && one.first == head().first &&
                       one.spacing == head().spacing,
                   "the potential contact area");
            demand(one.digits.normal == head().digits.normal, "N");
            for (const std::size_t axis : {0, 1})
                demand(is_close(one.curvature[axis], head().curvature[axis]), "the body");
        }
    }

    void check_body() const {
        if (head().is_hertzian)
            refuse(head().cells_line, "IPOTCN < 0", "leaves cells and body to Hertz' theory",
                   "give the cells by IPOTCN = 1 and the body by IBASE = 1");
        if (!is_line_contact() && !is_close(head().spacing[0], head().spacing[1]))
            refuse(head().cells_line, "DX and DY", "differ, but cells are squares",
                   "give the same size");
        if (head().curvature[0] == 0)
            refuse(head().digits.line, "Z = 0", "no undeformed distance has been given", "give 2");
        if (is_line_contact() != (head().curvature[1] == 0))
            refuse(head().distance_line, fmt::format("MY = {}", head().n_y),
                   "a body that is straight along y has one row of cells, and no other has",
                   "give MY = 1, or B(3) > 0");
    }

    bool is_upright(const ProgramCase& one) const {
        return length(one.offset) <= offset_rounding * head().spacing[0];
    }

    /// The last step before the indenter moves.
    void find_loading() {
        while (n_upright_ < steps_.size() && is_upright(steps_[n_upright_])) ++n_upright_;
        if (n_upright_ == 0)
            refuse(head().distance_line, "B(4), B(5)", "the indenter does not begin upright",
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
        const Sequence rolling = steps_.subspan(n_upright_);
        if (rolling.empty()) return;
        double way = 0;
        while (n_quarter_ < rolling.size() && length(rolling[n_quarter_].offset) > way)
            way = length(rolling[n_quarter_++].offset);
        turning_point_ = rolling[n_quarter_ - 1].offset;
        if (rolling.size() % (4 * n_quarter_) != 0)
            refuse(
                rolling.back().digits.line, "the path",
                fmt::format("ends within a period of {} steps", 4 * n_quarter_),
                "roll to and fro in whole periods; what rolls on is computed by tricontact roll");
        n_periods_ = rolling.size() / (4 * n_quarter_);
    }

    bool is_rigid() const {
        return head().shear_modulus[0] >= rigid_from * head().shear_modulus[1];
    }

    contact::Material material(std::size_t body) const {
        const double nu = head().poisson[body];
        return {2 * head().shear_modulus[body] * (1 + nu), nu};
    }

    std::string body_text() const {
        const auto radius = [&](std::size_t axis) {
            return fmt::format("\"{} mm\"", 1e3 / (2 * head().curvature[axis]));
        };
        if (is_line_contact())
            return fmt::format(
                "[indenter]\nshape = \"cylinder\"\nradius = {}\nlength = \"{} mm\"\n", radius(0),
                1e3 * head().spacing[1]);
        if (is_close(head().curvature[0], head().curvature[1]))
            return fmt::format("[indenter]\nshape = \"paraboloid\"\nradius = {}\n", radius(0));
        return fmt::format("[indenter]\nshape = \"ellipsoid\"\nradius = {}\nradius_y = {}\n",
                           radius(0), radius(1));
    }

    std::string material_text() const {
        const auto text_of = [](const contact::Material& m) {
            return fmt::format("young = \"{} MPa\"\npoisson = {}\n", 1e-6 * m.young,
                               toml_number(m.poisson));
        };
        return (is_rigid() ? "" : text_of(material(0))) + "[substrate]\n" + text_of(material(1)) +
               fmt::format("[friction]\ncoefficient = {}\n",
                           toml_number(head().friction_coefficient));
    }

    std::string load_text(bool is_coupled) const {
        const bool force = loading().digits.normal == 1;
        std::string text = fmt::format("[load]\n{} = \"{} {}\"\ntangential_ratio = {}\n",
                                       force ? "normal_force" : "indentation",
                                       loading().normal * (force ? 1 : 1e3), force ? "N" : "mm",
                                       toml_number(std::abs(loading().tangential[0])));
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
                refuse(line, what, rule, "give the steps of a case (docs/contact-program.md)");
        };
        demand(given.digits.tangential == expected.tangential, given.digits.line,
               fmt::format("T = {}", given.digits.tangential), "is another kind of step than due");
        demand(is_close(given.normal, expected.normal.value), given.loads_line,
               fmt::format("{} {}", given.digits.normal == 1 ? "FN" : "PEN", given.normal),
               fmt::format("is not {:.7g}, which equal steps of pressing, then constant loads, "
                           "would have (SI units)",
                           expected.normal.value));
        demand(
            length({given.offset[0] - expected.offset[0], given.offset[1] - expected.offset[1]}) <=
                offset_rounding * head().spacing[0],
            given.distance_line, "B(4), B(5)",
            fmt::format("put the indenter elsewhere than to ({:.7g}, {:.7g}) mm, where equal "
                        "steps of a triangular path have it",
                        1e3 * expected.offset[0] + 0.0, 1e3 * expected.offset[1] + 0.0));
        if (given.digits.tangential == 1) check_tangential(given, expected);
    }

    /// Shifts may stand for forces of zero where the contact is symmetric.
    void check_tangential(const ProgramCase& given, const SequenceStep& expected) const {
        const int forces = given.digits.force;
        const bool symmetric_in_y = std::abs(turning_point_[1]) <= rounding * head().spacing[0];
        if ((forces == 0 && (expected.force_ratio != 0 || !is_upright(given))) ||
            (forces == 1 && !symmetric_in_y))
            refuse(given.digits.line, fmt::format("F = {}", forces),
                   "prescribes a shift where a case has a force", "give 2");
        if (!is_close(-given.tangential[0], expected.force_ratio))
            refuse(given.loads_line, fmt::format("FX = {}", given.tangential[0]),
                   fmt::format("is not {:.7g}, the load of the case", -expected.force_ratio),
                   "keep it constant");
        if (given.tangential[1] != 0)
            refuse(given.loads_line, "FY", "there is no load along y", "give 0");
    }

    std::string name_;
    std::vector<ProgramCase> cases_;
    Sequence steps_;
    std::size_t n_upright_ = 0;  // steps before the indenter moves
    std::size_t n_quarter_ = 0, n_periods_ = 0;
    Vector2 turning_point_{};
};

}  // namespace

ImportedCase case_of_sequence(std::string text, const std::string& name,
                              const std::function<bool(const contact::MaterialPair&)>& is_coupled) {
    const SequenceReading reading(std::move(text), name);
    const bool coupled = is_coupled(reading.materials());
    ImportedCase out = reading.imported(coupled);
    reading.check_steps(sequence_of(parse_case(out.text, name + ", as a case"), coupled), coupled);
    return out;
}

}  // namespace tricontact::io

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "contact/bodies/half_space_scales.h"
#include "io/case/case_reader.h"
#include "io/contact_program/sequence_case.h"
#include "io/keys/messages.h"

namespace tricontact::io {

namespace {

using contact::Vector2;

constexpr double same_depth = 1e-3;  // a depth that is that of a force, but for its rounding
constexpr double same_place = 1e-9;  // of offsets, in cells

/// Without the sign of zero.
double unsigned_zero(double value) {
    return value == 0 ? 0 : value;
}

/// Reads rows of loads and motions out of shifts.
class PathReading {
  public:
    PathReading(ProgramSequence steps, const std::string& name) : steps_(steps), name_(name) {
        for (const ProgramCase& one : steps.subspan(1))
            if (one.digits.tangential == 0)
                refuse(one.digits.line, "T = 0", "only the first case presses without friction",
                       "give T = 1");
        by_force_ = head().digits.normal == 1;
        turns_ =
            std::ranges::any_of(steps, [](const ProgramCase& one) { return one.rotation != 0; });
        for (const int axis : {0, 1}) {
            moves_[axis] = moves(axis);
            kind_[axis] = kind_along(axis);
        }
    }

    std::string text(const std::string& heading) const {
        const std::string bodies = bodies_text(head(), name_);
        const double depth = depth_of_force(heading + bodies);
        std::string table = by_force_ ? "normal_force [N]" : "indentation [mm]";
        for (const int axis : {0, 1}) {
            const char* letter = axis == 0 ? "x" : "y";
            if (kind_[axis] == Kind::force)
                table += fmt::format(", tangential_force_{} [N]", letter);
            if (kind_[axis] == Kind::shift) table += fmt::format(", shift_{} [mm]", letter);
            if (moves_[axis]) table += fmt::format(", offset_{} [mm]", letter);
        }
        if (turns_) table += ", rotation [rad]";
        table += "\n";
        const bool frictionless = head().digits.tangential == 0;
        table += row(head(), 0, {}, 0, depth, !frictionless);
        Vector2 shift{};
        double rotation = 0;
        for (const ProgramCase& one : steps_.subspan(frictionless ? 1 : 0)) {
            for (const int axis : {0, 1})
                if (one.digits.force <= axis) shift[axis] += one.tangential[axis];
            rotation += one.rotation;
            table += row(one, 1, shift, rotation, depth, false);
        }
        return heading + bodies + (frictionless ? "[load]\npress = \"frictionless\"\n" : "") +
               "[path]\nsteps = 1\ntable = \"\"\"\n" + table + "\"\"\"\n" + cells_text(head());
    }

  private:
    enum class Kind { none, force, shift };

    const ProgramCase& head() const { return steps_.front(); }

    [[noreturn]] void refuse(int line, const std::string& subject, const std::string& rule,
                             const std::string& remedy) const {
        fail(fmt::format("{}:{}:1", name_, line), subject, rule, remedy);
    }

    bool moves(int axis) const {
        const double start = head().distance.offset[axis];
        return std::ranges::any_of(steps_, [&](const ProgramCase& one) {
            return std::abs(one.distance.offset[axis] - start) > same_place * one.spacing[0];
        });
    }

    /// Forces or shifts along an axis. No shift stands for no force where all is symmetric: while
    /// the indenter is pressed, and along y.
    Kind kind_along(int axis) const {
        const ProgramCase *force = nullptr, *shift = nullptr;
        bool held = false;
        for (const ProgramCase& one : steps_) {
            if (one.digits.tangential == 0) continue;
            const bool forced = one.digits.force > axis;
            const bool loaded = one.tangential[axis] != 0;
            if (forced && loaded) force = &one;
            if (!forced && (loaded || (force && axis == 0))) shift = &one;
            held |= !forced && axis == 0;
        }
        if (force && shift)
            refuse(shift->loads_line, fmt::format("F = {}", shift->digits.force),
                   "prescribes a shift where other cases of the sequence have a force",
                   "keep F, or begin another sequence by P = 2");
        if (force) return Kind::force;
        return shift || (held && moves_[0]) ? Kind::shift : Kind::none;
    }

    /// Of the first case's force, where others prescribe a depth [m].
    double depth_of_force(const std::string& beginning) const {
        const bool mixed = std::ranges::any_of(steps_, [&](const ProgramCase& one) {
            return one.digits.normal != head().digits.normal;
        });
        if (!mixed) return 0;
        if (!by_force_ || head().distance.heights)
            refuse(head().digits.line, "N", "changes within the sequence", "keep it");
        const auto c = parse_case(beginning + "[load]\n" + normal_text(head()) +
                                      "tangential_ratio = 0\n" + cells_text(head()),
                                  name_ + ", as a case");
        return contact::half_space_scales(c).indentation;
    }

    double normal_value(const ProgramCase& one, double depth) const {
        if ((one.digits.normal == 1) == by_force_) return program_load(one);
        if (!(std::abs(program_load(one) / depth - 1) <= same_depth))
            refuse(one.loads_line, fmt::format("PEN = {}", 1e3 * one.normal),
                   fmt::format("is not the depth {:.6g} mm of the force of the first case",
                               1e3 * depth),
                   "keep N");
        return head().normal;
    }

    /// `share` 0: no load yet, or that of pressing without friction (not `unloaded`).
    std::string row(const ProgramCase& one, double share, const Vector2& shift, double rotation,
                    double depth, bool unloaded) const {
        const double load = normal_value(one, depth);
        std::string text = fmt::format("{}", unloaded ? 0 : load * (by_force_ ? 1 : 1e3));
        for (const int axis : {0, 1}) {
            if (kind_[axis] == Kind::force)
                text += fmt::format(", {}", unsigned_zero(share * force(one, axis, load)));
            if (kind_[axis] == Kind::shift)
                text += fmt::format(", {}", unsigned_zero(share * 1e3 * shift[axis]));
            if (moves_[axis])
                text += fmt::format(", {}", unsigned_zero(1e3 * one.distance.offset[axis]));
        }
        if (turns_) text += fmt::format(", {}", unsigned_zero(share * rotation));
        return text + "\n";
    }

    /// On the substrate [N].
    double force(const ProgramCase& one, int axis, double load) const {
        if (one.digits.force <= axis || one.tangential[axis] == 0) return 0;
        if (!by_force_)
            refuse(one.loads_line, axis == 0 ? "FX" : "FY",
                   "is over an F_N that a depth does not give", "give N = 1 and FN");
        return -one.tangential[axis] * one.friction_coefficient * load;
    }

    ProgramSequence steps_;
    const std::string& name_;
    bool by_force_ = false, turns_ = false;
    bool moves_[2] = {};
    Kind kind_[2] = {};
};

}  // namespace

std::string path_case(ProgramSequence steps, const std::string& name, const std::string& heading) {
    return PathReading(steps, name).text(heading);
}

std::string pressing_case(ProgramSequence steps, const std::string& name, bool is_coupled,
                          const std::string& heading) {
    const ProgramCase& one = steps.front();
    return heading + bodies_text(one, name) + "[load]\n" + normal_text(one) +
           "tangential_ratio = 0\n" + (is_coupled ? "press = \"frictionless\"\n" : "") +
           cells_text(one);
}

}  // namespace tricontact::io

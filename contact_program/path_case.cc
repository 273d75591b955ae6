#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "contact/half_space_scales.h"
#include "contact_program/sequence_case.h"
#include "io/case/case_reader.h"
#include "io/keys/messages.h"

namespace tricontact::contact_program {

namespace {

using contact::Vector2;
using contact::operator+;
using contact::operator-;
using contact::operator*;

constexpr double same_depth = 1e-3;  // a depth that is that of a force, but for its rounding
constexpr double same_place = 1e-9;  // of places, in cells

/// Without the sign of zero.
double unsigned_zero(double value) {
    return value == 0 ? 0 : value;
}

/// Reads rows of loads and motions out of shifts.
class PathReading {
  public:
    PathReading(ProgramSequence steps, const std::string& name, const PressedDepth& pressed_depth)
        : steps_(steps), name_(name), pressed_depth_(pressed_depth) {
        for (const ProgramCase& one : steps.subspan(1))
            if (!one.step.tangential)
                refuse_at(name_, one.digits.line, "T = 0",
                          "only the first case presses without friction", "give T = 1");
        by_force_ = head().step.by_force();
        const auto turning = std::ranges::find_if(
            steps, [](const ProgramCase& one) { return one.step.rotation != 0; });
        turns_ = turning != steps.end();
        origin_ = origin_of_case(head());
        if (turns_) centre_ = turning->step.centre;
        for (const int axis : {0, 1}) {
            moves_[axis] = moves(axis);
            is_aside_[axis] = is_aside(axis);
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
            if (is_aside_[axis]) table += fmt::format(", offset_{} [mm]", letter);
        }
        if (turns_) table += ", rotation [rad]";
        table += "\n";
        const bool frictionless = !head().step.tangential;
        table += row(head(), 0, {}, 0, depth, !frictionless);
        Vector2 shift{};
        double rotation = 0;
        const auto further = steps_.subspan(frictionless ? 1 : 0);
        for (const ProgramCase& one : further) {
            const Vector2 moved = shift_at_centre(one);
            for (const int axis : {0, 1})
                if (!one.step.is_forced(axis)) shift[axis] += moved[axis];
            rotation += one.step.rotation;
            table += row(one, 1, shift, rotation, depth, false);
        }
        if (further.empty()) table += row(head(), 0, {}, 0, depth, false);  // a path has two rows
        return heading + bodies + (frictionless ? "[load]\npress = \"frictionless\"\n" : "") +
               "[path]\nsteps = 0\n" + centre_text() + "table = \"\"\"\n" + table + "\"\"\"\n" +
               cells_text(head());
    }

  private:
    enum class Kind { none, force, shift };

    const ProgramCase& head() const { return steps_.front(); }

    /// The twist of all cases is about the point of the first that has one: what the indenter is
    /// shifted by there, where a case prescribes the shift of another point [m].
    Vector2 shift_at_centre(const ProgramCase& one) const {
        const Vector2 arm = centre_ - one.step.centre;
        return one.step.values() + one.step.rotation * Vector2{-arm[1], arm[0]};
    }

    std::string centre_text() const {
        if (!turns_) return {};
        std::string text = "centre_of_rotation = \"substrate\"\n";
        for (const int axis : {0, 1})
            text += fmt::format("centre_{} = \"{} mm\"\n", axis == 0 ? "x" : "y",
                                1e3 * from_origin(centre_, axis));
        return text;
    }

    /// Without the rounding of what lies at it [m].
    double from_origin(const Vector2& place, int axis) const {
        const double distance = place[axis] - origin_[axis];
        return std::abs(distance) > same_place * head().spacing[0] ? distance : 0;
    }

    bool is_aside(int axis) const {
        return !head().distance.heights && std::ranges::any_of(steps_, [&](const ProgramCase& one) {
            return from_origin(one.step.offset, axis) != 0;
        });
    }

    bool moves(int axis) const {
        const double start = head().step.offset[axis];
        return std::ranges::any_of(steps_, [&](const ProgramCase& one) {
            return std::abs(one.step.offset[axis] - start) > same_place * one.spacing[0];
        });
    }

    /// Forces or shifts along an axis. No shift stands for no force where all is symmetric about
    /// the other one.
    Kind kind_along(int axis) const {
        const ProgramCase *force = nullptr, *shift = nullptr;
        const bool is_symmetric = !turns_ && !moves_[axis] && !head().distance.heights;
        for (const ProgramCase& one : steps_) {
            if (!one.step.tangential) continue;
            const bool forced = one.step.is_forced(axis);
            const bool counts = one.step.along[axis].value != 0 || !is_symmetric;
            if (forced && counts) force = &one;
            if (!forced && (counts || force)) shift = &one;
        }
        if (force && shift)
            refuse_at(name_, shift->loads_line, fmt::format("F = {}", shift->digits.force),
                      "prescribes a shift where other cases of the sequence have a force",
                      "keep F, or begin another sequence by P = 2");
        return force ? Kind::force : shift ? Kind::shift : Kind::none;
    }

    /// Of the first case's force, where others prescribe a depth [m].
    double depth_of_force(const std::string& beginning) const {
        const bool mixed = std::ranges::any_of(
            steps_, [&](const ProgramCase& one) { return one.step.by_force() != by_force_; });
        if (!mixed) return 0;
        if (!by_force_ || head().distance.heights)
            refuse_at(name_, head().digits.line, "N", "changes within the sequence", "keep it");
        const auto c = io::parse_case(beginning + "[load]\n" + normal_text(head()) +
                                          "tangential_ratio = 0\n" + cells_text(head()),
                                      name_ + ", as a case");
        return pressed_depth_(c);
    }

    double normal_value(const ProgramCase& one, double depth) const {
        if (one.step.by_force() == by_force_) return one.step.normal.value;
        if (!(std::abs(one.step.normal.value / depth - 1) <= same_depth))
            refuse_at(name_, one.loads_line, fmt::format("PEN = {}", 1e3 * one.normal),
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
            if (is_aside_[axis])
                text += fmt::format(", {}", 1e3 * from_origin(one.step.offset, axis));
        }
        if (turns_) text += fmt::format(", {}", unsigned_zero(share * rotation));
        return text + "\n";
    }

    /// On the substrate [N].
    double force(const ProgramCase& one, int axis, double load) const {
        if (!one.step.is_forced(axis) || one.step.along[axis].value == 0) return 0;
        if (!by_force_)
            refuse_at(name_, one.loads_line, axis == 0 ? "FX" : "FY",
                      "is over an F_N that a depth does not give", "give N = 1 and FN");
        return one.step.along[axis].value * one.friction_coefficient * load;
    }

    ProgramSequence steps_;
    const std::string& name_;
    const PressedDepth& pressed_depth_;
    bool by_force_ = false, turns_ = false;
    Vector2 origin_{};                       // of the case there [m]
    Vector2 centre_{};                       // of rotation, there [m]
    bool moves_[2] = {}, is_aside_[2] = {};  // from the origin
    Kind kind_[2] = {};
};

}  // namespace

double hertzian_depth(const contact::Case& c) {
    return contact::half_space_scales(c).indentation;
}

std::string path_case(ProgramSequence steps, const std::string& name, const std::string& heading,
                      const PressedDepth& pressed_depth) {
    return PathReading(steps, name, pressed_depth).text(heading);
}

std::string pressing_case(ProgramSequence steps, const std::string& name, bool is_coupled,
                          const std::string& heading) {
    const ProgramCase& one = steps.front();
    return heading + bodies_text(one, name) + "[load]\n" + normal_text(one) +
           "tangential_ratio = 0\n" + (is_coupled ? "press = \"frictionless\"\n" : "") +
           cells_text(one);
}

}  // namespace tricontact::contact_program

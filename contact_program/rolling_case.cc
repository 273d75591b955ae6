#include <fmt/format.h>

#include <cmath>
#include <numbers>

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

constexpr double same_direction = 1e-6;  // [rad]
constexpr double same_step = 1e-3;       // of DX

bool rolls_on(const ProgramCase& one) {
    return one.step.is_rolling() && !one.step.is_steady();
}

/// Reads rolling on out of a steady state, or of steps from rest.
class RollingReading {
  public:
    RollingReading(ProgramSequence steps, const std::string& name)
        : steps_(steps), name_(name), rolling_(steps.back()) {
        sign_ = sign_of_x();
        if (rolling_.distance.heights)
            refuse_at(name_, rolling_.distance.line, "IBASE",
                      "a body given by heights does not define how it rolls on",
                      "give a quadratic body by IBASE = 1");
        if (rolls_on(rolling_)) check_from_rest();
    }

    std::string text(const std::string& heading) const {
        const std::string sections =
            bodies_text(rolling_, name_) + load_text() + "[tractive_rolling]\n" + drive_text();
        const std::string cells = cells_text(rolling_, cell_shift());
        const auto c = io::parse_case(heading + sections + cells, name_ + ", as a case");
        if (rolling_.friction_rate || rolling_.friction_temperature)
            return heading + sections + cells;  // the steady state alone
        const double a = contact::half_space_scales(c).contact_radius;
        return heading + sections +
               fmt::format("distance = {}\n",
                           io::toml_number(n_rolled() * rolling_.spacing[0] / a)) +
               cells;
    }

  private:
    /// Cells; of a steady state, which is found directly, one.
    double n_rolled() const {
        double n = 0;
        for (const ProgramCase& one : steps_) n += rolls_on(one);
        return std::max(n, 1.);
    }

    /// The indenter rolls towards +x here: a contact that rolls towards -x is turned round.
    double sign_of_x() const {
        const double turns = rolling_.direction / std::numbers::pi, whole = std::round(turns);
        if (std::abs(turns - whole) * std::numbers::pi > same_direction)
            refuse_at(name_, rolling_.rolling_line, fmt::format("CHI = {}", rolling_.direction),
                      "the contact rolls along x, to one side or the other", "give 0 or 180d");
        return std::fmod(whole, 2) == 0 ? 1 : -1;
    }

    /// Pressed and loaded in one step, then rolled cell by cell under the same loads.
    void check_from_rest() const {
        std::size_t n_pressed = 0;
        while (!steps_[n_pressed].step.is_rolling()) ++n_pressed;
        if (n_pressed > 1)
            refuse_at(name_, steps_[1].digits.line, "T = 1",
                      "what rolls on from rest is pressed and loaded in one case",
                      "give one case T = 1");
        const bool forced = rolling_.step.is_forced(0);
        if (n_pressed == 0 && forced)
            refuse_at(name_, rolling_.loads_line, "FX",
                      "acts before the contact rolls on from rest", "load it by a case T = 1");
        if (n_pressed == 1 && !same_rest(steps_[0], forced))
            refuse_at(name_, steps_[0].loads_line, "FX",
                      forced ? "must be that of rolling on" : "no load acts before a creepage does",
                      "give the same FN and FX in all cases, or no FX");
        for (const ProgramCase& one : steps_.subspan(n_pressed)) check_step(one);
    }

    bool same_rest(const ProgramCase& rest, bool forced) const {
        const bool same_normal = rest.step.by_force() == rolling_.step.by_force() &&
                                 is_close(rest.step.normal.value, rolling_.step.normal.value);
        const double load = rest.step.tangential ? rest.step.along[0].value : 0;
        const bool same_load = forced && rest.step.is_forced(0)
                                   ? is_close(load, rolling_.step.along[0].value)
                                   : load == 0 && (!forced || rolling_.step.along[0].value == 0);
        return same_normal && same_load && rest.step.along[1].value == 0 && rest.step.rotation == 0;
    }

    void check_step(const ProgramCase& one) const {
        const auto demand = [&](bool same, int line, const char* what) {
            if (!same)
                refuse_at(name_, line, what, "changes while the contact rolls on from rest",
                          "keep it");
        };
        demand(rolls_on(one), one.digits.line, "T");
        demand(one.step.n_forced() == rolling_.step.n_forced() &&
                   one.step.by_force() == rolling_.step.by_force(),
               one.digits.line, "F or N");
        demand(is_close(one.normal, rolling_.normal) &&
                   one.step.values() == rolling_.step.values() &&
                   one.step.rotation == rolling_.step.rotation &&
                   one.step.centre == rolling_.step.centre,
               one.loads_line, "the load or creepage");
        demand(one.step.offset == rolling_.step.offset, one.distance.data_line,
               "the place of the body");
        if (std::abs(one.step_length / one.spacing[0] - 1) > same_step)
            refuse_at(name_, one.rolling_line, fmt::format("DQ = {}", 1e3 * one.step_length),
                      fmt::format("is not DX = {}: a step is one cell", 1e3 * one.spacing[0]),
                      "give the same length");
    }

    /// The file's own cells, about the body's lowest point.
    Vector2 cell_shift() const {
        if (!is_beside_origin(rolling_)) return {};
        const Vector2 shift = origin_of_case(rolling_) - rolling_.step.offset;
        const bool line = is_line_contact(rolling_);
        return {sign_ * shift[0] / rolling_.spacing[0],
                line ? 0 : sign_ * shift[1] / rolling_.spacing[1]};
    }

    std::string load_text() const {
        std::string text = "[load]\n" + normal_text(rolling_);
        if (rolling_.step.is_forced(0))
            text += fmt::format("tangential_ratio = {}\n",
                                io::toml_number(0 + sign_ * rolling_.step.along[0].value));
        return text;
    }

    /// Of the indenter at its lowest point, about which it spins here, from those at the point
    /// SPINXO, SPINYO; along an axis with a force there is none.
    Vector2 creepage() const {
        const double ahead =
            (rolling_.spin_ahead - usual_spin_ahead) * rolling_.step_length * sign_;
        const Vector2 arm = rolling_.step.offset + Vector2{ahead, 0} - rolling_.step.centre;
        return rolling_.step.values() + rolling_.step.rotation * Vector2{-arm[1], arm[0]};
    }

    std::string drive_text() const {
        std::string text;
        const auto [along, aside] = creepage();
        if (!rolling_.step.is_forced(0))
            text +=
                fmt::format("longitudinal_creepage = {}\n", io::toml_number(sign_ * along + 0.));
        const double across = rolling_.step.is_forced(1) ? -rolling_.step.along[1].value : aside;
        const double spin = rolling_.step.rotation;
        if (rolling_.step.is_forced(1) && across != 0)
            refuse_at(name_, rolling_.loads_line, fmt::format("FY = {}", across),
                      "across the way a creepage is prescribed, or no force acts",
                      "give F = 1 and CETA, or FY = 0");
        if (!rolling_.step.is_forced(1) && (across != 0 || spin != 0))
            text += fmt::format("lateral_creepage = {}\n", io::toml_number(sign_ * across + 0.));
        if (spin != 0) text += fmt::format("spin = \"{} rad/m\"\n", spin);
        if (rolling_.friction_rate || has_heat(rolling_) ||
            (rolling_.digits.material == 1 && rolling_.creep_ratio[0] * rolling_.creep_time[0] > 0))
            text += fmt::format("speed = \"{} mm/s\"\n", 1e3 * rolling_.speed);
        return text;
    }

    ProgramSequence steps_;
    const std::string& name_;
    const ProgramCase& rolling_;
    double sign_ = 1;  // of x there
};

}  // namespace

std::string rolling_case(ProgramSequence steps, const std::string& name,
                         const std::string& heading) {
    return RollingReading(steps, name).text(heading);
}

}  // namespace tricontact::contact_program

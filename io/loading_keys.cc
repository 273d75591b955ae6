#include <numbers>

#include "io/key_declarations.h"

namespace tricontact::io {

namespace {

using contact::Case;
using Kind = Key::Kind;

constexpr double full_turn = 2 * std::numbers::pi;

template <class Member>
Field in_steps(Case& c, Case::Steps kind, Member Case::Rolling::*member) {
    return c.rolling && c.rolling->steps == kind ? Field(&(*c.rolling.*member)) : Field();
}

void add_load(std::vector<CaseKey>& keys) {
    keys.push_back({{.path = "load.normal_force",
                     .kind = Kind::quantity,
                     .dimension = Dimension::force,
                     .range = above_zero(1e15),
                     .alternative = normal_load,
                     .example = R"("21.1 N")",
                     .text = "normal force F_N, compression positive"},
                    [](Case& c) -> Field { return &c.load.normal_force; }});
    keys.push_back({{.path = "load.indentation",
                     .kind = Kind::quantity,
                     .dimension = Dimension::length,
                     .range = above_zero(1e6),
                     .alternative = normal_load,
                     .example = R"("0.5 mm")",
                     .text = "indentation depth d"},
                    [](Case& c) -> Field { return &c.load.indentation; }});
    keys.push_back({{.path = "load.tangential_ratio",
                     .kind = Kind::number,
                     .range = {-1, 1, false, false},
                     .alternative = tangential_load,
                     .example = "0.56",
                     .text = "F_T/(mu F_N), tangential force along x; below 0 with "
                             "[tractive_rolling] alone, where it drives"},
                    [](Case& c) -> Field { return &c.load.tangential_ratio; }});
    keys.push_back({{.path = "load.tangential_force",
                     .kind = Kind::quantity,
                     .dimension = Dimension::force,
                     .range = {-1e15, 1e15},
                     .alternative = tangential_load,
                     .example = R"("6.7 N")",
                     .text = "tangential force F_T along x; below 0 with [tractive_rolling] alone, "
                             "where it drives"},
                    [](Case& c) -> Field { return &c.load.tangential_force; }});
}

void add_oscillation(std::vector<CaseKey>& keys) {
    keys.push_back({{.path = "load.normal_amplitude_ratio",
                     .kind = Kind::number,
                     .range = {0, 1, true, false},
                     .default_value = "0.0",
                     .example = "0.2",
                     .text = "superposed triangular oscillation of the normal load over its mean"},
                    [](Case& c) -> Field { return &c.load.normal_amplitude_ratio; }});
    keys.push_back({{.path = "load.normal_phase",
                     .kind = Kind::quantity,
                     .dimension = Dimension::angle,
                     .range = {-full_turn, full_turn},
                     .default_value = R"("0 rad")",
                     .needs = "load.normal_amplitude_ratio",
                     .example = R"("90 deg")",
                     .text = "phase by which the normal oscillation leads the rolling"},
                    [](Case& c) -> Field { return &c.load.normal_phase; }});
    keys.push_back({{.path = "load.tangential_amplitude_ratio",
                     .kind = Kind::number,
                     .range = from_zero(1000),
                     .default_value = "0.0",
                     .example = "0.2",
                     .text = "superposed triangular oscillation of F_T over its mean"},
                    [](Case& c) -> Field { return &c.load.tangential_amplitude_ratio; }});
    keys.push_back({{.path = "load.tangential_phase",
                     .kind = Kind::quantity,
                     .dimension = Dimension::angle,
                     .range = {-full_turn, full_turn},
                     .default_value = R"("0 rad")",
                     .needs = "load.tangential_amplitude_ratio",
                     .example = R"("90 deg")",
                     .text = "phase by which the oscillation of F_T leads the rolling"},
                    [](Case& c) -> Field { return &c.load.tangential_phase; }});
}

void add_press(std::vector<CaseKey>& keys) {
    using Press = Case::Press;
    keys.push_back({{.path = "load.press",
                     .kind = Kind::choice,
                     .choices = {choice("friction", Press::friction),
                                 choice("frictionless", Press::frictionless)},
                     .default_value = R"("friction")",
                     .example = R"("friction")",
                     .text = "how coupled models are pressed before F_T acts: with friction in "
                             "press_steps steps, or in one step without friction"},
                    [](Case& c) -> Field { return &c.load.press; }});
    keys.push_back({{.path = "load.press_steps",
                     .kind = Kind::integer,
                     .range = {1, 1000},
                     .default_value = "20",
                     .example = "20",
                     .text = "equal steps in which coupled models and nominally flat contacts are "
                             "pressed with friction"},
                    [](Case& c) -> Field { return &c.load.press_steps; }});
}

void add_time(std::vector<CaseKey>& keys) {
    const auto waiting = [&](std::string_view path, std::string_view default_value,
                             std::string_view example, std::string_view text,
                             Field (*field)(Case&)) {
        keys.push_back({{.path = path,
                         .kind = Kind::quantity,
                         .dimension = Dimension::time,
                         .range = from_zero(1e9),
                         .reason = "time does not go backwards",
                         .default_value = default_value,
                         .needs = "substrate.relaxation",
                         .example = example,
                         .text = text},
                        field});
    };
    waiting("load.press_time", {}, R"("1 s")",
            "time in which F_N rises from 0, or d; without it slow enough for all to relax",
            [](Case& c) { return c.relaxation ? Field(&c.load.press_time) : Field(); });
    waiting("load.hold", R"("0 s")", R"("60 s")",
            "wait under F_N and F_T before the rolling begins",
            [](Case& c) { return c.relaxation ? Field(&c.load.hold) : Field(); });
}

void add_rolling_path(std::vector<CaseKey>& keys) {
    using Rolling = Case::Rolling;
    using Reference = Case::AmplitudeReference;
    keys.push_back({{.path = "rolling.amplitude_ratio",
                     .kind = Kind::number,
                     .range = from_zero(100),
                     .alternative = amplitude,
                     .example = "0.24",
                     .text = "w = W/a, rolling amplitude over a contact radius"},
                    [](Case& c) { return in(c.rolling, &Rolling::amplitude_ratio); }});
    keys.push_back({{.path = "rolling.amplitude",
                     .kind = Kind::quantity,
                     .dimension = Dimension::length,
                     .range = from_zero(1e6),
                     .alternative = amplitude,
                     .example = R"("1.1 mm")",
                     .text = "rolling amplitude W"},
                    [](Case& c) { return in(c.rolling, &Rolling::amplitude); }});
    keys.push_back(
        {{.path = "rolling.amplitude_reference",
          .kind = Kind::choice,
          .choices = {choice("hertz", Reference::hertz), choice("model", Reference::model)},
          .default_value = R"("hertz")",
          .needs = "rolling.amplitude_ratio",
          .example = R"("hertz")",
          .text = "contact radius of the ratio: Hertz' for this case, or the model's own"},
         [](Case& c) {
             const bool ratio = c.rolling && c.rolling->amplitude_ratio;
             return ratio ? Field(&c.rolling->amplitude_reference) : Field();
         }});
    keys.push_back({{.path = "rolling.angle",
                     .kind = Kind::quantity,
                     .dimension = Dimension::angle,
                     .range = {-full_turn, full_turn},
                     .default_value = R"("0 rad")",
                     .example = R"("90 deg")",
                     .text = "between rolling and tangential load; 90 deg: perpendicular"},
                    [](Case& c) { return in(c.rolling, &Rolling::angle); }});
}

void add_rolling_steps(std::vector<CaseKey>& keys) {
    using Rolling = Case::Rolling;
    using Steps = Case::Steps;
    keys.push_back({{.path = "rolling.periods",
                     .kind = Kind::integer,
                     .range = {1, 100000},
                     .default_value = "12",
                     .example = "12",
                     .text = "rolling periods at most; a run stops earlier at shakedown"},
                    [](Case& c) { return in(c.rolling, &Rolling::periods); }});
    keys.push_back({{.path = "rolling.run_all",
                     .kind = Kind::boolean,
                     .default_value = "false",
                     .example = "true",
                     .text = "run all periods, also after shakedown"},
                    [](Case& c) { return in(c.rolling, &Rolling::run_all); }});
    keys.push_back(
        {{.path = "rolling.steps_per_quarter",
          .kind = Kind::integer,
          .range = {1, 100000},
          .default_value = "6",
          .alternative = steps,
          .example = "6",
          .text = "steps in each quarter of a period"},
         [](Case& c) { return in_steps(c, Steps::per_quarter, &Rolling::steps_per_quarter); }});
    keys.push_back({{.path = "rolling.increment",
                     .kind = Kind::quantity,
                     .dimension = Dimension::length,
                     .range = above_zero(1e6),
                     .alternative = steps,
                     .example = R"("0.2 mm")",
                     .text = "rolling distance dW of one step"},
                    [](Case& c) { return in_steps(c, Steps::increment, &Rolling::increment); }});
    keys.push_back({{.path = "rolling.steps",
                     .kind = Kind::choice,
                     .choices = {choice("turning-points", Steps::turning_points)},
                     .alternative = steps,
                     .example = R"("turning-points")",
                     .text = "step from one turning point to the next only"},
                    [](Case& c) { return in_steps(c, Steps::turning_points, &Rolling::steps); }});
    keys.push_back(
        {{.path = "rolling.speed",
          .kind = Kind::quantity,
          .dimension = Dimension::velocity,
          .range = above_zero(1e9),
          .required = true,
          .needs = "substrate.relaxation",
          .example = R"("1 mm/s")",
          .text = "speed of the drive, the same all along the path"},
         [](Case& c) { return c.relaxation ? in(c.rolling, &Rolling::speed) : Field(); }});
}

}  // namespace

void add_loading_keys(std::vector<CaseKey>& keys) {
    add_load(keys);
    add_oscillation(keys);
    add_press(keys);
    add_time(keys);
    add_rolling_path(keys);
    add_rolling_steps(keys);
}

}  // namespace tricontact::io

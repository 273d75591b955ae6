#include "contact_program/material_reading.h"

namespace tricontact::contact_program {

namespace {

constexpr double a_millimetre = 1e-3;    // [m]
constexpr double n_per_square_mm = 1e6;  // 1 N/mm^2 in Pa

void demand_above_zero(const InputLines& lines, const InputNumber& number, const char* name) {
    if (!(number > 0)) lines.refuse(name, number, "must be positive", "correct it");
}

}  // namespace

void read_creep(InputLines& lines, ProgramCase& one) {
    const auto v = lines.numbers(4, "FG 1,2 and TC 1,2");
    for (const std::size_t k : {0, 1, 2, 3})
        if (!(v[k] >= 0))
            lines.refuse(k < 2 ? "FG" : "TC", v[k], "must not be negative", "correct it");
    one.creep_ratio = {v[0], v[1]};
    one.creep_time = {v[2], v[3]};
}

void read_third_body(InputLines& lines, ProgramCase& one) {
    const auto v = lines.numbers(4, "GG3, LAYTHK, TAU_C0 and K_TAU");
    demand_above_zero(lines, v[0], "GG3");
    if (!(v[1] >= 0)) lines.refuse("LAYTHK", v[1], "must not be negative", "correct it");
    one.third_body = {lines.line(), n_per_square_mm * v[0], a_millimetre * v[1],
                      n_per_square_mm * v[2], n_per_square_mm / a_millimetre * v[3]};
}

void read_heat(InputLines& lines, ProgramCase& one) {
    constexpr double cubic_mm = 1e-9;  // [m^3]
    one.heat.emplace();
    for (auto* body : {&one.heat->indenter, &one.heat->substrate}) {
        const auto v = lines.numbers(4, "BKTEMP, HEATCP, LAMBDA and DENS");
        demand_above_zero(lines, v[1], "HEATCP");
        demand_above_zero(lines, v[2], "LAMBDA");
        demand_above_zero(lines, v[3], "DENS");
        *body = {.conductivity = v[2] / a_millimetre,
                 .specific_heat = v[1],
                 .density = v[3] / cubic_mm,
                 .temperature = v[0]};
    }
    if (one.digits.material == 4) lines.skip_numbers(1, "BETAPL");
}

}  // namespace tricontact::contact_program

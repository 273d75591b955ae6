#include "contact_program/friction_reading.h"

#include <cmath>

namespace tricontact::contact_program {

namespace {

constexpr double one_mm = 1e-3;  // [m]
constexpr int by_temperature = 6;

void demand_positive(const InputLines& lines, const InputNumber& number, const char* name) {
    if (!(number > 0)) lines.refuse(name, number, "must be positive", "correct it");
}

void read_coulomb(InputLines& lines, ProgramCase& one) {
    constexpr double same = 1e-3;  // as CONTACT asks for
    const auto v = lines.numbers(2, "FSTAT and FKIN");
    // Without a tangential problem it has no effect: see check_known().
    if (!(v[0] >= 0)) lines.refuse("FSTAT", v[0], "must not be negative", "correct it");
    if (std::abs(v[1] - v[0]) > same * v[0])
        lines.refuse("FKIN", v[1], "must be FSTAT in Coulomb friction", "correct it");
    one.friction_coefficient = v[0];
}

/// FKIN, and what is added to it at rest, in two parts.
void read_falling(InputLines& lines, ProgramCase& one) {
    using Law = contact::FrictionRate::Law;
    const int law = one.friction_law;
    contact::FrictionRate rate{.law = law == 2   ? Law::linear
                                      : law == 3 ? Law::rational
                                                 : Law::exponential};
    const auto v = lines.numbers(5, "FKIN and the constants of falling friction");
    demand_positive(lines, v[0], "FKIN");
    one.friction_coefficient = v[0];
    for (const std::size_t k : {1, 3}) {
        if (!(v[k] >= 0))
            lines.refuse("a part of the friction", v[k], "must not be negative",
                         "friction that grows with the slip velocity is not computed");
        // Of the rational law the second part has a form of its own.
        if (v[k] == 0 && (law != 3 || k == 3)) continue;
        if (v[k] > 0) demand_positive(lines, v[k + 1], k == 1 ? "SABSH1" : "SABSH2");
        one.friction_coefficient += v[k];
        rate.drops.push_back(v[k]);
        rate.speeds.push_back(v[k + 1] > 0 ? one_mm * v[k + 1] : 1);
    }
    if (one.friction_coefficient > v[0]) one.friction_rate = rate;
}

/// FREF below TREF, and what is added to it by DTHEAT above.
void read_by_temperature(InputLines& lines, ProgramCase& one) {
    const auto v = lines.numbers(4, "FREF, TREF, DFHEAT and DTHEAT");
    demand_positive(lines, v[0], "FREF");
    demand_positive(lines, v[3], "DTHEAT");
    if (!(v[0] + v[2] > 0))
        lines.refuse("DFHEAT", v[2], "leaves nothing of FREF", "change it by less");
    one.friction_coefficient = v[0];
    if (v[2] != 0) one.friction_temperature = {.change = v[2], .from = v[1], .to = v[1] + v[3]};
}

void read_memory(InputLines& lines, ProgramCase& one) {
    const auto v = lines.numbers(2, "MEMDST and MEM_S0");
    for (const std::size_t k : {0, 1})
        if (!(v[k] >= 0))
            lines.refuse(k == 0 ? "MEMDST" : "MEM_S0", v[k], "must not be negative", "correct it");
    one.has_temperature_memory = one.friction_temperature && v[0] > 0;
    if (!one.friction_rate || v[0] == 0) return;
    one.friction_rate->memory_length = one_mm * v[0];
    one.friction_rate->memory_speed = one_mm * v[1];
}

}  // namespace

void read_friction(InputLines& lines, ProgramCase& one, int sets) {
    one.friction_law = one.digits.friction;
    one.friction_rate.reset();
    one.friction_temperature.reset();
    one.has_temperature_memory = false;
    for (int k = 0; k < sets; ++k) {
        if (one.friction_law == 0)
            read_coulomb(lines, one);
        else if (one.friction_law == by_temperature)
            read_by_temperature(lines, one);
        else
            read_falling(lines, one);
        one.friction_line = lines.line();
    }
    if (one.friction_law != 0) read_memory(lines, one);
}

}  // namespace tricontact::contact_program

#include "benchmarks/submissions/total_keys.h"

#include <algorithm>
#include <cmath>

#include "benchmarks/reference/reference.h"
#include "io/keys/messages.h"
#include "io/keys/number_text.h"

namespace tricontact::benchmarks {

std::span<const TotalKey> total_keys() {
    using enum io::Dimension;
    namespace q = quantity_keys;
    static const std::vector<TotalKey> keys{
        {q::normal_force,
         {force, stiffness},
         "16.7 N",
         "resultant of the pressures F_N, or the reaction; of the part that was modelled",
         {"F_N", "FN", "force"}},
        {q::tangential_force,
         {force, stiffness},
         "4.55 N",
         "F_T on the body along x",
         {"F_T", "FT"}},
        {q::indentation, {length}, "0.35 mm", "d", {"d", "depth"}},
        {q::shift, {length}, "0.1 mm", "tangential displacement U of the indenter", {"U"}},
        {q::contact_radius,
         {length},
         "4.33 mm",
         "a, half width of a plane contact",
         {"a", "half_width"}},
        {q::peak_pressure, {pressure}, "0.421 MPa", "greatest pressure p0", {"p0", "p_max"}},
        {q::contact_area, {area, length}, "58.3 mm2", "area in contact", {}},
        {q::stick_area, {area, length}, "33.7 mm2", "area that sticks", {}},
        {q::stored_energy, {energy, force}, "2.354 mJ", "elastic energy", {"energy"}},
        {q::dissipation, {energy, force}, "0.0169 mJ", "work lost to friction so far", {}},
        {q::normal_stiffness, {stiffness, pressure}, "110 N/mm", "dF_N/dd", {}},
        {q::tangential_stiffness, {stiffness, pressure}, "50 N/mm", "dF_T/dU", {}},
        {q::static_shift, {length}, "0.15 mm", "U before rolling", {}},
        {q::settled_shift, {length}, "0.28 mm", "U that stands after shakedown", {}},
        {q::shift_increment, {length}, "2 um", "growth of U per period where it ratchets", {}},
        {q::shakedown_limit, {none}, "0.65", "F_T/(mu F_N) at the limit of shakedown", {}},
        {q::torque, {energy, force}, "3 mN m", "about the normal, on the body", {}},
        {q::creepage, {none}, "0.001", "slid over rolled way along x", {}},
        {q::stick_ratio,
         {none},
         "0.746",
         "stick radius or half width over that of the contact",
         {}},
        {q::creepage_ratio, {none}, "0.337", "creepage over what the problem's target says", {}},
        {q::shift_ratio, {none}, "0.483", "shift over that of all slipping", {}},
        {q::settled_shift_ratio, {none}, "0.559", "settled shift over that of all slipping", {}},
        {q::increment_ratio, {none}, "0.154", "shift per cycle over that of all slipping", {}},
        {q::stiffness_ratio, {none}, "1.0986", "dF/dd over 4 G a", {}},
        {q::von_mises_ratio, {none}, "0.62", "largest von Mises stress over p0", {}},
        {q::von_mises_depth_ratio, {none}, "0.48", "its depth over a", {}},
        {q::c11, {none}, "4.12", "Kalker's coefficient, F_x over G a^2 and creepage", {"C11"}},
        {q::c22, {none}, "3.67", "F_y over G a^2 and lateral creepage", {"C22"}},
        {q::c23, {none}, "1.47", "F_y over G a^3 and spin", {"C23"}},
        {q::c33, {none}, "1.19", "M_z over G a^4 and spin", {"C33"}},
        {q::force_ratio, {none}, "0.412", "horizontal force over weight", {}},
        {q::displacement, {length}, "-50 mm", "of the interface, along its normal", {}},
        {q::pressure_at_axis, {pressure}, "0.127 MPa", "at r = 0", {}},
        {q::pressure_at_0_9, {pressure}, "0.292 MPa", "at r = 0.9 a", {}},
        {q::edge_exponent, {none}, "0.774", "s of p ~ r^(s - 1) at a sharp edge", {}},
        {"size", {length}, "1 mm", "of elements in the contact", {"h", "element_size"}},
        {"cpu_time", {time}, "12 s", "of the computation", {"cpu"}}};
    return keys;
}

const TotalKey* find_total_key(std::string_view name) {
    for (const TotalKey& key : total_keys())
        if (key.key == name || std::ranges::count(key.also, name) > 0) return &key;
    return nullptr;
}

double unit_factor(std::string_view unit, std::span<const io::Dimension> dimensions) {
    const std::string one = "1 " + std::string(unit);
    for (std::size_t i = 1; i < dimensions.size(); ++i) try {
            return io::parse_quantity(one, dimensions[i]);
        } catch (const io::QuantityError&) {
            continue;
        }
    return io::parse_quantity(one, dimensions.front());
}

double in_si(double value, double factor) {
    const double divisor = std::round(1 / factor);
    return factor < 1 && 1 / divisor == factor ? value / divisor : value * factor;
}

Total read_total(const TotalKey& key, std::string_view text, const std::string& place) {
    const auto refuse = [&](const std::string& rule, const std::string& remedy) {
        io::fail(place, std::string(key.key) + " = " + io::shortened(io::trimmed(text), 40), rule,
                 remedy);
    };
    const std::string_view all = io::trimmed(text);
    const std::size_t end = std::min(all.find_first_of(" \t"), all.size());
    std::string_view digits = all.substr(0, end), unit = io::trimmed(all.substr(end));
    if (!io::number_in(digits)) {  // "16.7N"
        const auto letter = all.find_first_not_of("+-.0123456789eE");
        if (letter != all.npos && letter > 0) {
            digits = all.substr(0, letter);
            unit = io::trimmed(all.substr(letter));
        }
    }
    const auto number = io::number_in(digits);
    const std::string example =
        "write for example " + std::string(key.key) + " = " + std::string(key.example);
    if (!number || !std::isfinite(*number)) refuse("a number with a unit is due", example);
    if (unit.size() > 1 && unit.front() == '[' && unit.back() == ']')
        unit = unit.substr(1, unit.size() - 2);
    Total total{*number, {}, place};
    if (unit.empty()) return total;
    try {
        total.value = in_si(*number, unit_factor(unit, key.dimensions));
        total.unit = std::string(unit);
    } catch (const io::QuantityError& error) {
        refuse(error.rule, error.remedy);
    }
    if (!std::isfinite(total.value) || (total.value == 0 && *number != 0))
        refuse("leaves the range of double precision in SI units", "correct it");
    return total;
}

}  // namespace tricontact::benchmarks

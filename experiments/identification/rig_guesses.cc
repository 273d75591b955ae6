// Where a search for the numbers of a rig begins, from its tables alone.

#include "experiments/identification/rig_guesses.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "experiments/identification/identification_checks.h"
#include "experiments/identification/law_parameters.h"
#include "experiments/identification/loop_parameters.h"
#include "io/keys/messages.h"

namespace tricontact::experiments {

using Input = IdentificationInput;
using Measurement = Input::Measurement;
using Table = Input::Table;

namespace {

double zero_of(const Table& table) {
    return table.has_free_zero ? zero_depth_guess(table) : 0;
}

/// Under a rigid paraboloid on an incompressible half-space [Pa].
double hertz_mean_pressure(double young, double radius, double normal_force) {
    const double a = std::cbrt(3. / 4 * guessed_plane_share * normal_force * radius / young);
    return normal_force / (std::numbers::pi * a * a);
}

}  // namespace

double guessed_young(const Table& table, double radius, double normal_force) {
    const auto row = std::ranges::max_element(table.observed) - table.observed.begin();
    const double x = table.given[row] - zero_of(table),
                 y = table.observed[row] + adhesive_pull(table);
    constexpr double shear_over_plane = 2. / 3;    // G*/E*
    double cube = 3. / 4 * radius * normal_force;  // a^3 E*
    const auto of_depth = [&](double force, double depth) {
        return guessed_plane_share * 3. / 4 * force / std::sqrt(radius * depth * depth * depth);
    };
    switch (table.measurement) {
        case Measurement::force_indentation:
            return of_depth(y, x);
        case Measurement::contact_radius:
            return guessed_plane_share * 3. / 4 * radius * x / std::pow(table.observed[row], 3);
        case Measurement::force_relaxation:
            return of_depth(std::ranges::min(table.observed), table.held);
        case Measurement::indentation_creep:
            return of_depth(table.held, y);
        case Measurement::friction_loop:
            return guessed_young_of_loops(table, radius, normal_force);
        default:
            break;
    }
    if (!table.normal_forces.empty()) cube *= table.normal_forces[row] / normal_force;
    return guessed_plane_share * std::pow(x / (2 * shear_over_plane * y * std::cbrt(cube)), 1.5);
}

double largest_force(const Table& table) {
    switch (table.measurement) {
        case Measurement::contact_radius:
        case Measurement::sliding_force:
            return std::ranges::max(table.given);
        case Measurement::indentation_creep:
            return table.held;
        default:
            return std::ranges::max(table.observed);
    }
}

double guessed_friction(const Input& input, double normal_force) {
    constexpr double over_held = 1.5;
    double guess = 0;
    for (const Table* shifts : input.all(Measurement::static_shift))
        for (std::size_t row = 0; row < shifts->given.size(); ++row)
            guess = std::max(
                guess,
                over_held * shifts->given[row] /
                    (shifts->normal_forces.empty() ? normal_force : shifts->normal_forces[row]));
    for (const Table* sliding : input.all(Measurement::sliding_force))
        for (std::size_t row = 0; row < sliding->given.size(); ++row)
            guess = std::max(
                guess, sliding->observed[row] / (sliding->given[row] + adhesive_pull(*sliding)));
    for (const Table* loops : input.all(Measurement::friction_loop))
        guess = std::max(guess, largest_ratio_of_loops(*loops, normal_force));
    return guess;
}

const Table& table_of_young(const Input& input) {
    return *std::ranges::find_if(input.tables,
                                 [](const Table& table) { return tells_young(table.measurement); });
}

std::vector<std::pair<std::string_view, io::Value>> guessed_law(
    const std::vector<std::string>& find, const io::Document& rig, double ratio, double young,
    double radius, double normal_force) {
    const auto is_free = [&](std::string_view key) { return std::ranges::count(find, key) > 0; };
    const auto known = [&](std::string_view key) {
        return is_free(key) || !rig.find(key) ? 0 : quantity_of(rig, key);
    };
    const auto in_pascal = [](double value) { return io::shortest(value) + " Pa"; };
    const double friction = ratio * hertz_mean_pressure(young, radius, normal_force);
    const double cap = known(strength_limit_key);
    const double strength = cap > 0 ? std::min(friction, cap / 2) : friction;
    std::vector<std::pair<std::string_view, io::Value>> guesses;
    if (is_free(strength_key)) guesses.emplace_back(strength_key, in_pascal(strength));
    if (is_free(strength_limit_key))
        guesses.emplace_back(strength_limit_key,
                             in_pascal(2 * std::max(strength, known(strength_key))));
    return guesses;
}

}  // namespace tricontact::experiments

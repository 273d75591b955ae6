#include "experiments/design/law_separation.h"

#include <algorithm>
#include <cmath>

#include "contact/base/error.h"
#include "contact/half_space_scales.h"
#include "experiments/identification/estimation/best_sum_of_squares.h"
#include "experiments/identification/friction_values.h"
#include "experiments/identification/identification_models.h"
#include "experiments/identification/law_parameters.h"
#include "io/case/case_reader.h"
#include "io/case/rig_keys.h"
#include "io/keys/key_checks.h"
#include "theory/rolling/body_rolling.h"

namespace tricontact::experiments {

namespace {

using contact::Case;
using Measurement = IdentificationInput::Measurement;

/// What is set: loads, and forces under each.
struct Settings {
    std::vector<double> loads;   // [N], decreasing
    std::vector<double> forces;  // F_T [N], two for each load
    bool has_limit = false;
};

Case under(Case c, double normal_force) {
    c.load.normal_force = normal_force;
    return c;
}

double load_ratio(const io::RigFile& file) {
    double ratio = 0;
    io::read_or_default(io::rig_key("design.load_ratio"), &ratio, file.document,
                        io::case_file_keys());
    return ratio;
}

Settings settings_of(const io::RigFile& file, const LawPlan& plan) {
    const contact::HalfSpaceScales hertz = contact::half_space_scales(file.c);
    const double f = file.c.load.tangential_force
                         ? *file.c.load.tangential_force / hertz.friction_limit
                         : file.c.load.tangential_ratio.value_or(0);
    if (!(f > 0 && f < 1))
        throw contact::InputError(
            "load.tangential_ratio: static shifts need a force between 0 and "
            "what friction carries");
    Settings set{.has_limit = plan.limit_error > 0};
    const double ratio = load_ratio(file);
    for (const double part : {1., std::sqrt(ratio), ratio})
        set.loads.push_back(hertz.normal_force / part);
    for (const double load : set.loads) {
        const double limit = sliding_forces(false, under(file.c, load), {load}).front();
        for (const double share : {f, f / 2}) set.forces.push_back(share * limit);
    }
    return set;
}

/// Where F_T > F_lim the contact slides, and no amplitude shakes down.
double limit_amplitude(const Case& c, double force) {
    const contact::HalfSpaceScales hertz = contact::half_space_scales(c);
    const double f = std::min(1., force / hertz.friction_limit);
    return theory::amplitude_limit(c, f).value() * hertz.contact_radius;
}

/// All rows in the order of the tables: sliding forces, shifts, the limit.
std::vector<double> rows_of(const Case& c, const Settings& set) {
    std::vector<double> rows = sliding_forces(false, c, set.loads);
    for (std::size_t i = 0; i < set.loads.size(); ++i)
        for (const double shift : theory_shifts(false, under(c, set.loads[i]),
                                                {set.forces[2 * i], set.forces[2 * i + 1]}))
            rows.push_back(shift);
    if (set.has_limit) rows.push_back(limit_amplitude(under(c, set.loads[0]), set.forces[0]));
    return rows;
}

std::vector<PlannedRow> planned_rows(const Case& c, const Settings& set, const LawPlan& plan) {
    const std::vector<double> values = rows_of(c, set);
    std::vector<PlannedRow> rows;
    const auto add = [&](const char* quantity, const char* unit, double load, double force,
                         double error) {
        const double value = values[rows.size()];
        rows.push_back({.quantity = quantity,
                        .normal_force = load,
                        .tangential_force = force,
                        .value = value,
                        .standard_error = error * value,
                        .unit = unit});
    };
    for (const double load : set.loads) add("sliding force", "N", load, 0, plan.sliding_error);
    for (std::size_t i = 0; i < set.forces.size(); ++i)
        add("static shift", "m", set.loads[i / 2], set.forces[i], plan.shift_error);
    if (set.has_limit)
        add("limit of shakedown", "m", set.loads[0], set.forces[0], plan.limit_error);
    return rows;
}

/// From which with_law() guesses where the search for its numbers begins.
IdentificationInput tables_of(const Case& c, const Settings& set,
                              const std::vector<PlannedRow>& rows) {
    IdentificationInput input{.rig = c};
    const std::size_t n = set.loads.size();
    IdentificationInput::Table sliding{.measurement = Measurement::sliding_force,
                                       .given = set.loads},
        shifts{.measurement = Measurement::static_shift, .given = set.forces};
    for (std::size_t i = 0; i < n; ++i) sliding.observed.push_back(rows[i].value);
    for (std::size_t i = n; i < 3 * n; ++i) {
        shifts.observed.push_back(rows[i].value);
        shifts.normal_forces.push_back(rows[i].normal_force);
    }
    input.tables = {std::move(shifts), std::move(sliding)};
    return input;
}

/// A number of the case that it states with its error.
struct StatedNumber {
    FreeParameter parameter;
    double value = 0, standard_error = 0;
};

std::vector<StatedNumber> stated_numbers(const io::RigFile& file) {
    constexpr double widest = 10;
    std::vector<StatedNumber> numbers;
    for (const io::UncertainKey& one : file.uncertain_of_case()) {
        const std::string key(one.key->path);
        const double value = one.number.value.value;
        if (!key.starts_with("substrate.") && !key.starts_with("indenter.")) continue;
        if (!(value > 0)) continue;
        FreeParameter p{.key = key, .low = value / widest, .high = widest * value, .start = value};
        if (key == "substrate.poisson") {
            p.scale = FreeParameter::Scale::linear;
            p.low = 0;
            p.high = one.key->range.high;
        }
        numbers.push_back({std::move(p), value, one.number.value.standard_error});
    }
    return numbers;
}

/// The residuals of a law at its best, in standard errors; the last ones are of stated numbers.
std::vector<double> residuals_under(const io::MeasurementLaw& law, const io::RigFile& file,
                                    const Settings& set, const std::vector<PlannedRow>& rows) {
    IdentificationInput input = with_law(tables_of(file.c, set, rows), law);
    ObservedTable planned{.name = "planned"}, stated{.name = "stated"};
    for (const PlannedRow& row : rows) {
        planned.observed.push_back(row.value);
        planned.standard_errors.push_back(row.standard_error);
    }
    const std::size_t n_of_law = input.parameters.size();
    for (const StatedNumber& one : stated_numbers(file)) {
        input.parameters.push_back(one.parameter);
        stated.observed.push_back(one.value);
        stated.standard_errors.push_back(one.standard_error);
    }
    IdentificationTask task{.parameters = input.parameters, .tables = {planned}};
    if (!stated.observed.empty()) task.tables.push_back(std::move(stated));
    task.model = [&](const std::vector<double>& numbers) {
        const Case c = rig_with(input, input.parameters, numbers).as_case;
        std::vector<double> values = rows_of(c, set);
        values.insert(values.end(), numbers.begin() + static_cast<std::ptrdiff_t>(n_of_law),
                      numbers.end());
        return values;
    };
    BestSumOfSquares squares(task);
    return squares.residuals(squares.best().x);
}

}  // namespace

const io::MeasurementLaw* law_of(const contact::Friction& friction) {
    for (const io::MeasurementLaw& law : io::measurement_laws())
        if (law.has_strength == friction.shear_strength.has_value() &&
            law.has_coefficient == friction.coefficient.has_value() &&
            law.has_exponent == (friction.pressure_exponent.value_or(1) != 1) &&
            law.has_limit == friction.strength_limit.has_value() && !friction.map)
            return &law;
    return nullptr;
}

LawSeparation law_separation(const io::RigFile& file, const LawPlan& plan,
                             const std::vector<double>& noise) {
    const Settings set = settings_of(file, plan);
    LawSeparation separation{.rows = planned_rows(file.c, set, plan)};
    for (std::size_t row = 0; row < noise.size(); ++row)
        separation.rows.at(row).value += noise[row] * separation.rows[row].standard_error;
    for (const std::string& name : plan.laws) {
        const auto residuals =
            residuals_under(io::measurement_law(name), file, set, separation.rows);
        double sum = 0;
        for (const double r : residuals) sum += r * r;
        separation.distances.push_back(std::sqrt(sum));
        for (std::size_t row = 0; row < separation.rows.size(); ++row)
            separation.rows[row].off.push_back(residuals[row]);
    }
    return separation;
}

}  // namespace tricontact::experiments

#include <fmt/format.h>

#include <functional>
#include <iostream>

#include "app/commands.h"
#include "app/models.h"
#include "comparisons/layer.h"
#include "comparisons/verification.h"
#include "contact/run.h"
#include "io/atomic_file.h"
#include "theory/cattaneo_mindlin.h"
#include "theory/layer_shakedown.h"
#include "theory/oscillating_rolling.h"

namespace tricontact::app {

namespace {

using comparisons::Verification;
using comparisons::VerificationRow;
using contact::Case;
using contact::History;

const std::string version = TRICONTACT_VERSION;

/// A paraboloid that rolls until it rests, all scales other than 1; no coupling, which no closed
/// form knows.
Case rolling_case(double poisson) {
    Case c;
    c.indenter.radius = 40e-3;
    c.substrate = {5.2e6, poisson};
    c.friction_coefficient = 0.57;
    c.contact.coupling = false;
    c.load.normal_force = 21.1;
    c.load.tangential_ratio = 0.56;
    c.rolling.emplace();
    c.rolling->amplitude_ratio = 0.24;
    c.rolling->steps = Case::Steps::turning_points;
    c.rolling->periods = 60;
    return c;
}

/// At nu = 0, for which alone Cattaneo and Mindlin are exact.
Case half_space_case() {
    return rolling_case(0);
}

Case layer_case() {
    Case c = rolling_case(0.5);
    c.layer.thickness = 8e-3;
    return c;
}

/// A model of the case on three levels.
struct Levels {
    std::string model;
    std::vector<double> sizes;  // over Hertz' radius
    std::vector<History> histories;
};

/// Sets the resolution that is finer by a factor.
using SetLevel = std::function<void(Case&, int)>;

Levels run_levels(const std::string& model, const Case& base, const SetLevel& set_level,
                  const std::function<double(const Case&)>& size, const Say& say) {
    Levels result{model, {}, {}};
    for (int factor = 1; factor <= 4; factor *= 2) {
        Case c = base;
        set_level(c, factor);
        say(fmt::format("{}, level {}", model, result.sizes.size() + 1));
        result.sizes.push_back(size(c));
        result.histories.push_back(contact::run(c, *make_model(model, c, 1, say)));
    }
    return result;
}

/// Rows from the histories of one model.
class Rows {
  public:
    Rows(const Levels& levels, Verification& verification)
        : levels_(levels), verification_(verification) {}

    void add(const char* problem, const char* quantity, const char* source, double reference,
             double tolerance, const std::function<double(const History&)>& value) {
        VerificationRow row{.problem = problem,
                            .quantity = quantity,
                            .model = levels_.model,
                            .source = source,
                            .reference = reference,
                            .sizes = levels_.sizes,
                            .values = {},
                            .tolerance = tolerance};
        for (const History& history : levels_.histories) row.values.push_back(value(history));
        verification_.rows.push_back(std::move(row));
    }

  private:
    const Levels& levels_;
    Verification& verification_;
};

double radius(const History& h) {
    return h.scales.contact_radius * 1e3;
}
double depth(const History& h) {
    return h.scales.indentation * 1e3;
}
double peak_pressure(const History& h) {
    return h.scales.peak_pressure * 1e-6;
}
double unit_shift(const History& h) {
    return h.scales.unit_shift * 1e3;
}
double limit(const History& h) {
    return h.limit_tangential_ratio;
}
double static_ratio(const History& h) {
    return h.static_shift / h.scales.unit_shift;
}
double settled_ratio(const History& h) {
    return h.shift_per_period.back() / h.scales.unit_shift;
}

/// What a model of the half-space may be wrong by on its finest level.
struct HalfSpaceTolerances {
    double radius, depth, pressure, shift, limit;
};

void add_half_space(const Levels& levels, const HalfSpaceTolerances& allowed, Verification& all) {
    const Case c = half_space_case();
    const contact::HertzScales hertz = contact::hertz_scales(c);
    const double f = *c.load.tangential_ratio, w = *c.rolling->amplitude_ratio;
    const char* const johnson = "Johnson, Contact Mechanics (1985), eq. 4.22 to 4.24 (Hertz)";
    Rows rows(levels, all);
    rows.add("Hertz", "a, mm", johnson, hertz.contact_radius * 1e3, allowed.radius, radius);
    rows.add("Hertz", "d, mm", johnson, hertz.indentation * 1e3, allowed.depth, depth);
    rows.add("Hertz", "p0, MPa", johnson, hertz.peak_pressure * 1e-6, allowed.pressure,
             peak_pressure);
    rows.add("Cattaneo and Mindlin", "u_stat",
             "Johnson, Contact Mechanics (1985), eq. 7.42b (exact for nu = 0)",
             theory::static_shift_ratio(f), allowed.shift, static_ratio);
    rows.add("Limit of shakedown", "f_T,lim, w = 0.24",
             "1 - 3/2 w + 1/2 w^3, the least pressures of Hertz' contact integrated "
             "(docs/limits.md)",
             theory::shakedown_limit(w), allowed.limit, limit);
}

void add_layer(const Levels& levels, double coarser, Verification& all) {
    const Case c = layer_case();
    const theory::LayerContact exact = comparisons::exact_layer_contact(c).value();
    const double amplitude = *c.rolling->amplitude_ratio * contact::hertz_scales(c).contact_radius;
    const char* const fredholm =
        "Lebedev and Ufliand (1958), Fredholm equation of the bonded layer";
    Rows rows(levels, all);
    rows.add("Layer b = 1.8 a", "a, mm", fredholm, exact.contact_radius * 1e3, 5e-4 * coarser,
             radius);
    rows.add("Layer b = 1.8 a", "d, mm", fredholm, exact.indentation * 1e3, 2e-4 * coarser, depth);
    rows.add("Layer b = 1.8 a", "p0, MPa", fredholm, exact.centre_pressure * 1e-6, 2e-4 * coarser,
             peak_pressure);
    rows.add("Layer b = 1.8 a", "U_max, mm",
             "displacement under the pressure of that equation along x",
             c.friction_coefficient * exact.unit_shift.value() * 1e3, 2e-4 * coarser, unit_shift);
    rows.add("Layer b = 1.8 a, limit of shakedown", "f_T,lim", "line load of that equation",
             theory::shakedown_limit(exact, amplitude / exact.contact_radius), 2e-4 * coarser,
             limit);
}

Verification verify(bool brief, const Say& say) {
    Verification all;
    const double hertz_radius = contact::hertz_scales(layer_case()).contact_radius;
    const int springs = brief ? 500 : 2500;
    // Of the bed: the contact and the path on both sides.
    const auto spring_size = [](const Case& c) {
        return 2 * (1 + *c.rolling->amplitude_ratio) / c.mdr.springs;
    };
    const Levels mdr = run_levels(
        "mdr", half_space_case(), [&](Case& c, int factor) { c.mdr.springs = springs * factor; },
        spring_size, say);
    const double spread = brief ? 25 : 1;  // of errors of the second order
    add_half_space(mdr, {1e-6 * spread, 1e-6 * spread, 1e-6 * spread, 1e-6 * spread, 1e-6 * spread},
                   all);
    const Case c = half_space_case();
    Rows(mdr, all).add(
        "Settled shift of MDR", "u_sd, w = 0.24, f_T = 0.56",
        "Wetter, thesis (TU Berlin 2016), eq. 3.2.16 with kappa = 3/2",
        theory::settled_shift_ratio(*c.rolling->amplitude_ratio, *c.load.tangential_ratio).value(),
        1e-6 * spread, settled_ratio);

    const double cells = brief ? 5 : 8, coarser = brief ? 4 : 1;
    const auto set_cells = [&](Case& at, int factor) { at.bem.cells_per_radius = cells * factor; };
    const auto cell_size = [](const Case& at) { return 1 / *at.bem.cells_per_radius; };
    add_half_space(run_levels("bem", half_space_case(), set_cells, cell_size, say),
                   {5e-4 * coarser, 2e-4 * coarser, 2e-4 * coarser, 2e-4 * coarser, 2e-4 * coarser},
                   all);
    const auto set_spacing = [&](Case& at, int factor) {
        at.bem.spacing = hertz_radius / (cells * factor);
    };
    const auto spacing_size = [&](const Case& at) { return *at.bem.spacing / hertz_radius; };
    add_layer(run_levels("bem-layer", layer_case(), set_spacing, spacing_size, say), coarser, all);
    return all;
}

}  // namespace

bool verify_command(const VerifyOptions& options) {
    const Say say = [&](const std::string& line) {
        if (!options.quiet) std::cerr << line << '\n';
    };
    if (!options.output.empty()) io::make_output_folder(options.output);
    const Verification result = verify(options.brief, say);
    const std::string text = comparisons::verification_markdown(result);
    std::cout << text;
    if (!options.output.empty()) {
        io::write_file(options.output + "/verification.md", text);
        io::write_file(options.output + "/verification.json",
                       comparisons::verification_json(version, result).dump(2) + "\n");
    }
    return result.passed();
}

}  // namespace tricontact::app

#include <cmath>
#include <filesystem>
#include <optional>

#include "app/case_run.h"
#include "app/commands/command.h"
#include "atlas/prediction.h"
#include "comparisons/quantities/quantities.h"
#include "experiments/assumptions/rig.h"
#include "experiments/assumptions/rig_report.h"

namespace tricontact::app {

namespace {

/// A rig's sphere, taken as a rigid paraboloid, on its layer under F_N and
/// experiments::coupling_tangential_ratio, pressed with friction in the usual steps.
Case case_of(const experiments::Rig& rig) {
    Case c;
    c.indenter.radius = rig["R"].value;
    c.substrate = {rig["E_2"].value, rig["nu_2"].value};
    c.layer.thickness = rig["b"].value;
    c.friction_coefficient = rig["mu"].value;
    c.load.normal_force = rig["F_N"].value;
    c.load.tangential_ratio = experiments::coupling_tangential_ratio;
    return c;
}

/// Its shift [m], with 22 cells in the contact radius.
double static_shift(const experiments::Rig& rig, bool coupled) {
    constexpr const char* model_name = "bem-layer";
    Case c = case_of(rig);
    c.models = {model_name};
    c.contact.coupling = coupled;
    c.bem.cells_per_radius = 22;
    return history_of(model_name, c, 1, silent).static_shift;
}

/// U_sd/U_stat with its standard error; empty where the maps do not reach.
std::optional<statistics::Estimate> growth_of(const atlas::Prediction& p) {
    namespace quantities = comparisons::quantities;
    const auto* at_rest = p.find(quantities::static_shift_ratio);
    const auto* settled = p.find(quantities::settled_shift_ratio);
    if (!at_rest || !settled) return {};
    const double growth = settled->value.value / at_rest->value.value;
    // Bars are those of 95 %.
    constexpr double standard_errors = 1.96;
    return statistics::Estimate{growth,
                                growth *
                                    std::hypot(settled->value.error / settled->value.value,
                                               at_rest->value.error / at_rest->value.value) /
                                    standard_errors};
}

/// From the maps of layer and half-space.
std::optional<experiments::Growth> rolled_growth(const experiments::Rig& rig) {
    namespace quantities = comparisons::quantities;
    const double amplitude = experiments::smallest_rolling_amplitude(rig);
    Case c = case_of(rig);
    c.rolling.emplace();
    c.rolling->amplitude = amplitude;
    c.load.tangential_ratio.reset();
    c.load.limit_fraction = .5;
    const atlas::Prediction layer = atlas::predict(c, "bem-layer");
    const auto* load = layer.find(quantities::tangential_ratio);
    if (!load) return {};
    c.load.set_tangential_ratio(load->value.value);
    c.layer = {};
    c.contact.coupling = false;
    const auto on_layer = growth_of(layer), on_half_space = growth_of(atlas::predict(c, "bem"));
    if (!on_layer || !on_half_space) return {};
    return experiments::Growth{amplitude, load->value.value, *on_half_space, *on_layer};
}

void print(const experiments::RigReport& report) {
    std::cout << report.title << '\n';
    for (const experiments::Assumption& one : report.assumptions) {
        std::cout << fmt::format("{}: {}\n", experiments::finding_of(one.standing()), one.claim);
        for (const experiments::Criterion& criterion : one.criteria)
            std::cout << fmt::format(
                "{:4}{} = {}, {}: {}\n", "", criterion.calculation.symbol,
                experiments::text_of(criterion.calculation.result, criterion.calculation.unit),
                experiments::threshold_text(criterion), experiments::word_of(criterion.standing()));
        for (const std::string& missing : one.missing)
            std::cout << fmt::format("{:4}not given: {}\n", "", missing);
        if (!one.consequence.empty()) std::cout << fmt::format("{:4}{}\n", "", one.consequence);
    }
    if (!report.printed.empty()) std::cout << "printed numbers\n";
    for (const experiments::PrintedCheck& check : report.printed) {
        std::cout << fmt::format("{:<17} {} = {} {}\n", experiments::word_of(check.agreement),
                                 check.printed.name, check.printed.text, check.printed.source);
        if (const std::string error = experiments::error_text(check); !error.empty())
            std::cout << fmt::format("{:18}{}\n", "", error);
        if (!check.calculation || check.agreement == experiments::PrintedCheck::Agreement::agrees)
            continue;
        std::cout << fmt::format("{:18}{}\n", "", experiments::arithmetic(*check.calculation));
        if (!check.substitutes.empty())
            std::cout << fmt::format("{:18}follows from {}\n", "",
                                     experiments::substitutes_text(check));
    }
}

/// Assumptions that are violated are a finding, no error.
void check_assumptions(CommandOptions options) {
    const std::string stem = std::filesystem::path(options.file).stem().string();
    options.choose_folder();
    const auto given = experiments::read_rig(options.file);
    experiments::RigReport report;
    options.fill({{"rig.json", "report.html"}}, [&] {
        report = experiments::check_rig(given, static_shift, rolled_growth);
        options.write("rig.json", experiments::rig_json(report));
        options.write_report(experiments::rig_document(report), "tricontact rig " + stem + ".toml");
    });
    print(report);
}

}  // namespace

Command rig_command() {
    return Declared<CommandOptions>("rig", "Check the assumptions of an experiment",
                                    check_assumptions)
        .on_file("rig", "Rig file (TOML)", "RIG.toml")
        .output("Folder (results/<rig>)");
}

}  // namespace tricontact::app

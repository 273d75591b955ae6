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

/// A rig's sphere, taken as a rigid paraboloid, on its layer: under F_N, pressed with friction in
/// the usual steps, and experiments::coupling_tangential_ratio.
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

/// Its shift [m] by the maps; empty where they do not reach.
std::optional<double> mapped_shift(const Case& c) {
    const auto prediction = atlas::predict(c, "bem-layer");
    const auto* shift = prediction.find(comparisons::quantities::static_shift);
    return shift ? std::optional(shift->value.value) : std::nullopt;
}

/// Its shift [m]. Coupled by the maps or, where they do not reach, by boundary elements of 22 cells
/// in the contact radius; uncoupled by the springs of a layer, which are exact but for their
/// elements.
double static_shift(const experiments::Rig& rig, bool coupled) {
    Case c = case_of(rig);
    if (coupled)
        if (const auto shift = mapped_shift(c)) return *shift;
    const std::string model = coupled ? "bem-layer" : "mdr-layer";
    c.models = {model};
    c.contact.coupling = coupled;
    c.bem.cells_per_radius = 22;
    return history_of(model, c, 1, silent).static_shift;
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
        report = experiments::check_rig(given, static_shift);
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

#include <fmt/format.h>

#include <filesystem>
#include <iostream>

#include "app/commands/commands.h"
#include "app/rig_static_shift.h"
#include "experiments/assumptions/check_rig.h"
#include "experiments/assumptions/rig_reader.h"
#include "experiments/assumptions/rig_report.h"
#include "io/results/atomic_file.h"
#include "io/results/output_folder.h"

namespace tricontact::app {

namespace {

struct Check {
    experiments::RigReport operator()(const experiments::RollingRig& rig) const {
        if (rig.roller.shape == experiments::RollingRig::Shape::cylinder)
            return experiments::check_rig(rig);
        return experiments::check_rig(rig, app::static_shift);
    }
    experiments::RigReport operator()(const experiments::WalkingRig& rig) const {
        return experiments::check_rig(rig);
    }
};

void print(const experiments::RigReport& report) {
    std::cout << report.title << '\n';
    for (const experiments::Assumption& one : report.assumptions) {
        std::cout << fmt::format("{:<12} {}\n", experiments::word_of(one.standing()), one.claim);
        for (const experiments::Criterion& criterion : one.criteria)
            std::cout << fmt::format(
                "{:13}{} = {}, {}: {}\n", "", criterion.calculation.symbol,
                experiments::text_of(criterion.calculation.result, criterion.calculation.unit),
                experiments::threshold_text(criterion), experiments::word_of(criterion.standing()));
        for (const std::string& missing : one.missing)
            std::cout << fmt::format("{:13}not given: {}\n", "", missing);
        if (!one.consequence.empty()) std::cout << fmt::format("{:13}{}\n", "", one.consequence);
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

}  // namespace

void rig_command(const RigOptions& options) {
    const std::string stem = std::filesystem::path(options.rig_file).stem().string();
    const std::string folder = io::output_folder(options.output, options.rig_file);
    const auto given = experiments::read_rig(options.rig_file);
    io::OutputFolder output(folder, {{"rig.json", "report.html"}});
    experiments::RigReport report;
    output.fill([&] {
        report = std::visit(Check{}, given);
        io::write_file(folder + "/rig.json", experiments::rig_json(report));
        io::write_file(folder + "/report.html", report::document_html(experiments::rig_document(
                                                    report, "tricontact rig " + stem + ".toml")));
    });
    print(report);
}

}  // namespace tricontact::app

#include <fmt/format.h>

#include <filesystem>
#include <iostream>

#include "app/commands.h"
#include "app/rig_report.h"
#include "io/atomic_file.h"
#include "io/output_folder.h"
#include "io/rig_reader.h"
#include "rig/check_rig.h"

namespace tricontact::app {

namespace {

struct Check {
    rig::RigReport operator()(const contact::RollingRig& rig) const {
        if (rig.roller.shape == contact::RollingRig::Shape::cylinder) return rig::check_rig(rig);
        return rig::check_rig(rig, static_shift);
    }
    rig::RigReport operator()(const contact::WalkingRig& rig) const { return rig::check_rig(rig); }
};

void print(const rig::RigReport& report) {
    std::cout << report.title << '\n';
    for (const rig::Assumption& one : report.assumptions) {
        std::cout << fmt::format("{:<12} {}\n", word_of(one.standing()), one.claim);
        for (const rig::Criterion& criterion : one.criteria)
            std::cout << fmt::format(
                "{:13}{} = {}, {}: {}\n", "", criterion.calculation.symbol,
                text_of(criterion.calculation.result, criterion.calculation.unit),
                threshold_text(criterion), word_of(criterion.standing()));
        for (const std::string& missing : one.missing)
            std::cout << fmt::format("{:13}not given: {}\n", "", missing);
        if (!one.consequence.empty()) std::cout << fmt::format("{:13}{}\n", "", one.consequence);
    }
    if (!report.printed.empty()) std::cout << "printed numbers\n";
    for (const rig::PrintedCheck& check : report.printed) {
        std::cout << fmt::format("{:<17} {} = {} {}\n", word_of(check.agreement),
                                 check.printed.name, check.printed.text, check.printed.source);
        if (const std::string error = error_text(check); !error.empty())
            std::cout << fmt::format("{:18}{}\n", "", error);
        if (!check.calculation || check.agreement == rig::PrintedCheck::Agreement::agrees) continue;
        std::cout << fmt::format("{:18}{}\n", "", arithmetic(*check.calculation));
        if (!check.substitutes.empty())
            std::cout << fmt::format("{:18}follows from {}\n", "", substitutes_text(check));
    }
}

}  // namespace

void rig_command(const RigOptions& options) {
    const std::string stem = std::filesystem::path(options.rig_file).stem().string();
    const std::string folder = io::output_folder(options.output, options.rig_file);
    const auto given = io::read_rig(options.rig_file);
    io::OutputFolder output(folder, {{"rig.json", "report.html"}});
    rig::RigReport report;
    output.fill([&] {
        report = std::visit(Check{}, given);
        io::write_file(folder + "/rig.json", rig_json(report));
        io::write_file(folder + "/report.html", comparisons::document_html(rig_document(
                                                    report, "tricontact rig " + stem + ".toml")));
    });
    print(report);
}

}  // namespace tricontact::app

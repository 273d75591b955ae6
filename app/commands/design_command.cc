#include <filesystem>
#include <nlohmann/json.hpp>

#include "app/commands/command.h"
#include "comparisons/quantities/left_out.h"
#include "contact/models/model_kind.h"
#include "experiments/design/rig_design.h"
#include "io/case/rig_file.h"

namespace tricontact::app {

namespace {

struct DesignOptions : CommandOptions {};

/// That nothing within the bounds does it is a finding, no error.
void design_rig(DesignOptions options) {
    const auto input = experiments::read_design(io::read_rig_file(options.file, options.overrides));
    input.rig.c.refuse_extras("designs");
    options.choose_folder("_design");
    experiments::DesignStudy study;
    const std::string name = std::filesystem::path(options.file).filename().string();
    options.fill({{"design.json", "report.html"}}, [&] {
        study = options.told_of_file(
            [&] { return experiments::design_study(input, options.runner()); });
        options.write("design.json", experiments::design_json(study));
        options.write_report(experiments::design_document(study), "tricontact design " + name);
    });
    Answer answer([&] { return experiments::design_json(study); });
    for (const std::string& one : comparisons::left_out(input.rig.c, contact::models::bem_layer))
        answer.note("design leaves out " + one + '\n');
    if (input.rig.c.load.hold > 0)
        answer.note("design leaves out load.hold: assumptions are checked without it\n");
    for (const report::Verdict& verdict : experiments::design_verdicts(study))
        answer.add(verdict.sentence + '\n');
    // The check of rigs is about layers under Coulomb's law.
    const bool has_check = input.rig.c.layer.thickness && input.rig.c.friction.is_coulomb();
    options.answer(
        answer.add(fmt::format("look closer: tricontact {} {}{}\n{}\n", has_check ? "rig" : "run",
                               options.file, experiments::best_overrides(study), options.where())));
}

}  // namespace

Command design_command() {
    return Declared<DesignOptions>(
               Group::rigs, "design",
               "Find values of a rig that make assumptions hold and deviations visible", design_rig)
        .on_case({"[rig]", "[record]", "[design]", io::uncertainty_mark})
        .output("Folder (results/<case>_design)")
        .exports()
        .json();
}

}  // namespace tricontact::app

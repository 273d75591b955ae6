#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <sstream>

#include "app/commands/command.h"
#include "experiments/identification/identification_checks.h"
#include "experiments/identification/identification_models.h"
#include "experiments/identification/identification_study.h"
#include "experiments/identification/report/loop_report.h"
#include "io/case/rig_file.h"
#include "report/format.h"

namespace tricontact::app {

namespace {

using experiments::IdentificationInput;
using experiments::IdentificationStudy;
using experiments::IdentifiedModel;

struct IdentifyOptions : CommandOptions {
    bool posterior = false;
};

void print(const IdentificationStudy& study, std::ostream& out) {
    for (const auto& table : study.input.tables)
        if (!table.reading.empty())
            out << std::filesystem::path(table.data_file).filename().string() << ": "
                << table.reading << '\n';
    const auto& parameters = study.input.parameters;
    out << fmt::format("{:<11}", "model");
    for (const auto& p : parameters) out << fmt::format(" {:<32}", p.symbol);
    out << fmt::format(" {:>8}  {}\n", "R^2", "chi^2");
    for (const IdentifiedModel& model : study.models) {
        const auto& found = model.found;
        out << fmt::format("{:<11}", model.name);
        for (const auto& p : parameters) {
            const auto k = found.find(p.key, p.index);
            out << fmt::format(" {:<32}", k ? experiments::shown(model, *k) : "none");
        }
        const auto [squares, degrees] = experiments::chi_squared(model);
        out << fmt::format(
            " {:>8}  {}\n",
            std::isfinite(found.r_squared) ? fmt::format("{:.5f}", found.r_squared) : "undefined",
            found.goodness ? fmt::format("{}, {:.4g} degrees of freedom",
                                         report::significant(squares, 3), degrees)
                           : "errors estimated");
    }
    if (study.laws) out << experiments::law_lines(*study.laws);
    if (study.interfaces) out << experiments::interface_lines(*study.interfaces);
    for (const IdentifiedModel& model : study.models)
        if (model.posterior) out << experiments::posterior_sentence(model) << '\n';
    for (const auto& verdict : experiments::identification_verdicts(study))
        out << verdict.sentence << '\n';
}

void identify_properties(IdentifyOptions options) {
    const IdentificationInput input =
        experiments::read_identification(options.file, options.overrides);
    experiments::check_lengths_scale(input);
    options.choose_folder();
    IdentificationStudy study;
    options.fill({{"identify.json", "report.html", "posterior.csv", "loops.csv"}}, [&] {
        study = experiments::identification_study(input, options.posterior, options.runner(),
                                                  options.sayer());
        study.command =
            "tricontact identify " + std::filesystem::path(input.name).filename().string();
        study.version = files::version;
        if (options.posterior) options.write("posterior.csv", experiments::posterior_csv(study));
        if (study.loops) options.write("loops.csv", experiments::loops_csv(study));
        options.write("identify.json", experiments::identification_json(study).dump(2) + '\n');
        options.write_report(experiments::identification_document(study), study.command);
    });
    Answer answer([&] { return experiments::identification_json(study).dump(2); });
    for (const std::string& line : experiments::left_out_lines(input)) answer.note(line + '\n');
    std::ostringstream text;
    print(study, text);
    options.answer(answer.add(text.str()));
}

}  // namespace

Command identify_command() {
    return Declared<IdentifyOptions>(
               Group::rigs, "identify",
               "Find E, nu, mu, lengths, Prony terms and friction loops' regimes from measurements",
               identify_properties)
        .on_case({"[measurement]", "[rig]", io::uncertainty_mark})
        .flag("--posterior", &IdentifyOptions::posterior,
              "Draw from the posterior density of what is found and the uncertain inputs "
              "(posterior.csv)")
        .output("Folder (results/<case>)")
        .exports()
        .threads()
        .json()
        .quiet("No progress");
}

}  // namespace tricontact::app

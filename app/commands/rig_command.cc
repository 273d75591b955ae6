#include <filesystem>
#include <nlohmann/json.hpp>
#include <sstream>

#include "app/commands/command.h"
#include "comparisons/quantities/left_out.h"
#include "comparisons/quantities/quantities.h"
#include "comparisons/run/input_reading.h"
#include "contact/cells.h"
#include "contact/models/model_kind.h"
#include "experiments/assumptions/rig.h"
#include "experiments/predictions/rig_body.h"
#include "experiments/predictions/rig_growth.h"
#include "experiments/predictions/rig_indenter.h"
#include "experiments/rig_report/rig_report.h"
#include "io/case/rig_file.h"
#include "io/keys/input_file.h"
#include "report/format.h"
#include "walking/input/walk_keys.h"
#include "walking/input/walk_reader.h"

namespace tricontact::app {

namespace {

struct RigOptions : CommandOptions {
    int samples = 0;  ///< of the uncertain quantities; 0: none
};

/// Shift [m] of a rig's sphere, see sphere_on_layer(), with 22 cells in the contact radius.
double static_shift(const experiments::Rig& rig, bool coupled, const contact::ModelRunner& runner) {
    constexpr const char* model_name = contact::models::bem_layer;
    Case c = experiments::sphere_on_layer(rig);
    c.models = {model_name};
    c.contact.coupling = coupled;
    c.of<contact::Cells>().per_radius = 22;
    return runner.history_of(model_name, c).static_shift;
}

void print(const experiments::RigReport& report, std::ostream& out) {
    out << report.title << '\n';
    for (const experiments::Assumption& one : report.assumptions) {
        out << fmt::format("{}: {}\n", report::word_of(one.standing()), one.claim);
        for (const experiments::Criterion& criterion : one.criteria)
            out << fmt::format(
                "{:4}{} = {}, {}: {}{}\n", "", criterion.calculation.symbol,
                experiments::text_of(criterion.calculation.result, criterion.calculation.unit),
                experiments::threshold_text(criterion), report::word_of(criterion.standing()),
                criterion.probability_violated
                    ? fmt::format("; violated in {} % of the samples",
                                  report::significant(100 * *criterion.probability_violated, 3))
                    : "");
        if (const std::string effects = experiments::effects_text(report, one.name);
            !effects.empty())
            out << fmt::format("{:4}effect of the assumption: {}\n", "", effects);
        for (const std::string& missing : one.missing)
            out << fmt::format("{:4}not given: {}\n", "", missing);
        if (!one.consequence.empty()) out << fmt::format("{:4}{}\n", "", one.consequence);
    }
    if (!report.printed.empty()) out << "printed numbers\n";
    for (const experiments::PrintedCheck& check : report.printed) {
        out << fmt::format("{:<17} {} = {} {}\n", experiments::word_of(check.agreement),
                           check.printed.name, check.printed.text, check.printed.source);
        if (const std::string error = experiments::error_text(check); !error.empty())
            out << fmt::format("{:18}{}\n", "", error);
        if (!check.calculation || check.agreement == experiments::PrintedCheck::Agreement::agrees)
            continue;
        out << fmt::format("{:18}{}\n", "", experiments::arithmetic(*check.calculation));
        if (!check.substitutes.empty())
            out << fmt::format("{:18}follows from {}\n", "", experiments::substitutes_text(check));
    }
}

experiments::Rig read_rig(const CommandOptions& options) {
    const std::string text = io::read_input_file(options.file);
    io::Document document = io::parse_document(text, options.file);
    if (!io::is_walk_case(document)) {
        const io::RigFile file = io::parse_rig_file(text, options.file, options.overrides);
        file.c.refuse_extras("assumptions of rigs", {contact::Case::Extra::bulk_stress});
        for (const std::string& sentence : comparisons::input_sentences(file.c))
            options.say(sentence);
        experiments::Rig rig = experiments::rig_with_body(file, options.runner());
        // By the model of its checks that leaves out least; the width and the body of an indenter
        // that deforms are assumptions of their own.
        for (const std::string& one : comparisons::left_out(file.c, contact::models::bem_layer))
            if (!one.starts_with("substrate.width") &&
                !(one.starts_with("indenter.body") && experiments::has_soft_indenter(rig)))
                options.say("rig leaves out " + one);
        if (file.c.load.hold > 0)
            options.say("rig leaves out load.hold: assumptions are checked without it");
        return rig;
    }
    walking::parse_walk_case(text, options.file, options.overrides);  // checked
    io::apply_overrides(document, options.overrides, walking::walk_file_keys());
    return experiments::walking_rig(document, walking::walk_file_keys());
}

/// Where the body is a height map that contact reaches the border of.
std::string border_warning(const experiments::Rig& rig) {
    if (!rig.body) return {};
    comparisons::Results results;
    results.model = contact::models::bem_layer;
    results.set(comparisons::quantities::border_force_share, rig.body->layer.border_force_share);
    return comparisons::border_warning(results);
}

/// Assumptions that are violated are a finding, no error.
void check_assumptions(RigOptions options) {
    const std::string stem = std::filesystem::path(options.file).stem().string();
    options.choose_folder();
    const experiments::Rig given = read_rig(options);
    experiments::RigReport report;
    options.fill({{"rig.json", "report.html"}}, [&] {
        const auto shift = [runner = options.runner()](const experiments::Rig& rig, bool coupled) {
            return static_shift(rig, coupled, runner);
        };
        const auto indenter = [&](const experiments::Rig& rig) {
            // Sections have no body of a file.
            return options.makers->has(experiments::model_of_indenter(rig)) &&
                           rig.c.indenter.body->form != contact::ElasticBody::Form::mesh
                       ? std::optional(experiments::indenter_contacts(rig, options.runner()))
                       : std::nullopt;
        };
        report = experiments::check_rig(given, shift, experiments::rolled_growth, indenter);
        if (options.samples > 0)
            for (experiments::Assumption& one : report.assumptions)
                for (experiments::Criterion& criterion : one.criteria)
                    criterion.probability_violated =
                        experiments::probability_of_violation(criterion, options.samples);
        options.write("rig.json", experiments::rig_json(report));
        options.write_report(experiments::rig_document(given, report),
                             "tricontact rig " + stem + ".toml");
    });
    std::ostringstream text;
    print(report, text);
    Answer answer([&] { return experiments::rig_json(report); }, text.str());
    if (const std::string warning = border_warning(given); !warning.empty())
        answer.note("warning: " + warning + '\n');
    options.answer(answer);
}

}  // namespace

Command rig_command() {
    return Declared<RigOptions>(Group::rigs, "rig", "Check what the evaluation of a rig assumes",
                                check_assumptions)
        .on_case({"[rig]", "[printed]", io::uncertainty_mark})
        .number("--samples", &RigOptions::samples,
                "Points of the uncertain quantities, for the chance that an assumption is violated",
                2, 1'000'000)
        .output("Folder (results/<case>)")
        .exports()
        .json();
}

}  // namespace tricontact::app

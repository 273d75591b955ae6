#include "app/commands/strain_deviation.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "app/commands/command.h"
#include "comparisons/finite_strain/strain_output.h"
#include "comparisons/quantities/left_out.h"
#include "contact/models/model_kind.h"
#include "fem/settings.h"
#include "io/case/rolling_on.h"
#include "report/table_text.h"
#include "studies/deviation_runs.h"

namespace tricontact::app {

namespace {

using comparisons::StrainContact;
using comparisons::StrainDeviation;

/// Two by two: by the linear law, at finite strains.
studies::StudyPoints points_of(const StrainContact& contact, const std::string& file) {
    studies::StudyPoints points;
    for (const auto& point : comparisons::strain_points(contact))
        for (const bool finite : {false, true}) {
            const Case c = comparisons::strain_case(contact, point, finite);
            points.push_back(studies::deviation_point(c, point.level, file));
        }
    return points;
}

void write(const CommandOptions& options, const StrainDeviation& deviation, double elements) {
    options.write("finite_strain.csv", strain_csv(deviation));
    options.write("finite_strain.json",
                  strain_json(files::version, io::write_case(deviation.contact.c), deviation));
    std::string command = studies::deviation_command(options) + " --finite-strain";
    if (elements != StrainContact{}.elements) command += fmt::format(" --elements {}", elements);
    options.write_report(strain_document(deviation), command);
}

}  // namespace

void compare_with_finite_strains(CommandOptions options, double elements) {
    options.choose_folder("_finite_strain");
    const Case c = io::read_case(options.file, options.overrides);
    io::refuse_rolling_on(c, options.file);
    if (!options.makers->has(contact::models::fem))
        options.refuse("--finite-strain: this program was built without the model fem");
    // Before anything is removed.
    const StrainContact contact =
        options.told_of_file([&] { return comparisons::strain_contact(c, elements); });
    const studies::StudyPoints points = points_of(contact, options.file);
    StrainDeviation deviation;
    options.fill(
        {{"finite_strain.csv", "finite_strain.json", "report.html"}, io::result_store_files()},
        [&] {
            deviation =
                comparisons::strain_deviation(contact, studies::deviation_results(options, points));
            write(options, deviation, elements);
        });
    Answer answer(
        [&] { return strain_json(files::version, io::write_case(deviation.contact.c), deviation); },
        report::table_text(strain_table(deviation)));
    answer.note(comparisons::left_out_lines(c, {contact::models::fem}));
    if (c.of<fem::Settings>().mesh)
        answer.note(
            "fem leaves out fem.mesh: at each force and thickness it has a mesh of its own\n");
    for (const auto& verdict : strain_verdicts(deviation)) answer.add(verdict.sentence + '\n');
    options.answer(answer);
    options.say(options.where());
}

}  // namespace tricontact::app

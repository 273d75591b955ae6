#include "app/commands/body_size.h"

#include <nlohmann/json.hpp>

#include "app/commands/command.h"
#include "comparisons/bodies/size_output.h"
#include "comparisons/quantities/left_out.h"
#include "io/case/rolling_on.h"
#include "report/table_text.h"
#include "studies/study_kind.h"

namespace tricontact::app {

namespace {

using comparisons::SizeContact;
using comparisons::SizeDeviation;

SizeDeviation computed(const CommandOptions& options, const SizeContact& contact) {
    studies::StudyPoints points;
    for (const comparisons::SizeRun& run : comparisons::size_runs(contact)) {
        const Case c = comparisons::size_case(contact, run);
        // Whatever the user's case passes, that of a run is checked by itself.
        const Case checked = io::parse_case(io::write_case(c), options.file);
        points.push_back(studies::make_point(checked, checked.models.front(), 0, options.file));
    }
    io::ResultStore store = studies::open_results(options.output);
    studies::compute_missing(studies::contact_kind(), points, store,
                             {.name = "deviation", .options = options});
    std::vector<std::optional<comparisons::Results>> results;
    for (const studies::StudyPoint& point : points)
        results.push_back(studies::results_of(store.find(point.key)));
    return comparisons::size_deviation(contact, results);
}

}  // namespace

void compare_body_sizes(CommandOptions options) {
    options.choose_folder("_body_size");
    const Case c = io::read_case(options.file, options.overrides);
    io::refuse_rolling_on(c, options.file);
    // Before anything is removed.
    const SizeContact contact = options.told_of_file([&] { return comparisons::size_contact(c); });
    if (!options.makers->has(contact.model()))
        options.refuse(std::string("--body: this program was built without the model ") +
                       contact.model());
    SizeDeviation deviation;
    const auto json = [&] { return size_json(files::version, io::write_case(c), deviation); };
    options.fill({{"body_size.csv", "body_size.json", "report.html"}, io::result_store_files()},
                 [&] {
                     deviation = computed(options, contact);
                     options.write("body_size.csv", size_csv(deviation));
                     options.write("body_size.json", json());
                     std::string command = "tricontact deviation " + options.file;
                     for (const std::string& text : options.overrides)
                         command += fmt::format(" --set \"{}\"", text);
                     options.write_report(size_document(deviation), command + " --body");
                 });
    Answer answer(json, report::table_text(size_table(deviation)));
    answer.note(comparisons::left_out_lines(c, {contact.model()}));
    if (c.rolling) answer.note("[rolling] is left out: sizes are compared under pressing alone\n");
    for (const auto& verdict : size_verdicts(deviation)) answer.add(verdict.sentence + '\n');
    options.answer(answer);
    options.say(options.where());
}

}  // namespace tricontact::app

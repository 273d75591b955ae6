#include <algorithm>

#include "experiments/records/experiment.h"
#include "io/keys/field_reader.h"
#include "io/keys/input_file.h"
#include "io/keys/key.h"
#include "io/keys/key_checks.h"
#include "io/keys/messages.h"
#include "io/tables/csv_table.h"

namespace tricontact::experiments {

namespace {

const std::vector<io::PlacedKey<ExperimentInput>>& keys() {
    using enum io::Dimension;
    using enum Experiment::Kind;
    using Input = ExperimentInput;
    constexpr double longest = 1e9;  // [s], as in cases
    static const std::vector<io::PlacedKey<Input>> keys{
        {io::text_key("title", R"("title")", "what was measured"),
         io::at<&Input::experiment, &Experiment::title>},
        {io::choice_key("kind",
                        {io::choice("shakedown", shakedown), io::choice("ratcheting", ratcheting),
                         io::choice("limit", limit)},
                        R"("shakedown")", "procedure"),
         io::at<&Input::experiment, &Experiment::kind>},
        {io::text_key("case", R"("case.toml")", "the case file"), io::at<&Input::case_file>},
        {io::text_key("runs", R"(["run_1.csv"])", "the records")},
        {io::number_key("confidence", {0.5, 0.999}, "0.683", "level of the intervals"),
         io::at<&Input::experiment, &Experiment::confidence>},
        {io::quantity_key("record.resolution", length, io::above_zero(1), R"("80 nm")",
                          "step of the recorded shift"),
         io::at<&Input::experiment, &Experiment::resolution>},
        {io::quantity_key("record.loading", time, {-longest, longest}, R"("10 s")",
                          "when the tangential load was applied"),
         io::at<&Input::experiment, &Experiment::loading>},
        {io::quantity_key("drive.start", time, {-longest, longest}, R"("60 s")",
                          "when rolling began"),
         [](Input& i) -> io::Field { return &i.experiment.drive.start; }},
        {io::quantity_key("drive.period", time, io::above_zero(longest), R"("4.5 s")",
                          "of the rolling"),
         [](Input& i) -> io::Field { return &i.experiment.drive.period; }},
        {io::quantity_key("drive.amplitude", length, io::above_zero(1), R"("1.1 mm")",
                          "rolling amplitude"),
         [](Input& i) -> io::Field { return &i.experiment.drive.amplitude; }},
        {io::quantity_key("drive.speed", velocity, io::above_zero(1e9), R"("1 mm/s")",
                          "speed of the drive"),
         [](Input& i) -> io::Field { return &i.experiment.drive.speed; }},
        {io::integer_key("drive.periods", {1, 100'000}, "12", "rolling periods"),
         [](Input& i) -> io::Field { return &i.experiment.drive.periods.emplace(); }}};
    return keys;
}

bool is_nested_in_experiment(std::string_view path) {
    return path.starts_with("errors.");
}

Record read_record(const std::string& path) {
    // Up to a day of three columns at 20 samples per second.
    const io::CsvTable table =
        io::read_csv_table(path, {"record", "time [s], shift [um], drive [mm]", 2'000'000,
                                  "leave out every second row", 100});
    Record record{.name = table.name(),
                  .time = table.values("time", io::Dimension::time),
                  .shift = table.values("shift", io::Dimension::length),
                  .drive = {}};
    if (table.has("drive")) record.drive = table.values("drive", io::Dimension::length);
    table.check_names({"time", "shift", "drive"});
    table.check_increasing("time", "times must increase from row to row",
                           "sort the table, or remove the row");
    return record;
}

std::vector<Record> read_records(const io::Document& document) {
    const std::string remedy = R"(write for example runs = ["run_1.csv", "run_2.csv"])";
    const io::Entry& entry = document.required("runs", remedy);
    const auto* files = std::get_if<std::vector<std::string>>(&entry.value);
    if (!files || files->empty())
        io::fail(entry.place, entry.subject(), "must be a list of files", remedy);
    std::vector<Record> records;
    for (auto file = files->begin(); file != files->end(); ++file) {
        if (std::find(files->begin(), file, *file) != file)
            io::fail(entry.place, entry.subject(), io::toml_string(*file) + " stands twice",
                     "a record counts once");
        records.push_back(read_record(document.path_of(*file)));
    }
    return records;
}

std::vector<ExperimentInput::CaseError> read_errors(const io::Document& document) {
    std::vector<ExperimentInput::CaseError> errors;
    for (const io::Entry& entry : document.entries) {
        if (!is_nested_in_experiment(entry.path)) continue;
        const std::string path = entry.path.substr(std::string_view("errors.").size());
        const io::CaseKey* key = io::find_key(path);
        if (!key || (key->kind != io::Key::Kind::quantity && key->kind != io::Key::Kind::number)) {
            io::fail(entry.key_place, "",
                     "unknown key " + entry.path + ": the case has no number " + path,
                     io::did_you_mean(key ? "" : io::likely_path(path, io::case_key_list().paths()),
                                      "docs/case-file.md lists the keys"));
        }
        double error = 0;
        io::read_field(*key, entry, io::Field(&error));
        if (!(error > 0))
            io::fail(entry.place, entry.subject(), "a standard error must be positive",
                     "omit what is exact");
        errors.push_back({key, error, entry.place});
    }
    if (!errors.empty() && !document.find("case"))
        io::fail(document.find_section("errors") ? document.find_section("errors")->place
                                                 : errors.front().place,
                 "", "[errors] are those of a case, but there is none", "add case = \"case.toml\"");
    return errors;
}

// What the drive did, if no column says it.
void check_drive(const Experiment& e, const io::Document& document) {
    const auto n_recorded =
        std::ranges::count_if(e.records, [](const Record& r) { return !r.drive.empty(); });
    const bool all = n_recorded == std::ssize(e.records);
    const std::string place = document.place_of("drive.start");
    if (!all && n_recorded > 0)
        io::fail(place, "", "some runs have a column drive, others have not",
                 "add it to all, or evaluate them in two files");
    if (all && document.find_section("drive"))
        io::fail(document.find_section("drive")->place, "",
                 "[drive] and the column drive of the runs say it twice", "omit one of the two");
    if (all) return;
    if (e.kind == Experiment::Kind::limit)
        io::fail(place, "", "amplitudes that rise in steps need the column drive",
                 "record the drive: time [s], shift [um], drive [mm]");
    if (!e.drive.start || !e.drive.periods)
        io::fail(place, "", "without a column drive its start and number of periods must be known",
                 "add start = \"60 s\" and periods = 12 below [drive]");
    if (e.drive.period && e.drive.speed)
        io::fail(document.place_of("drive.speed"), "drive.speed", "period and speed say the same",
                 "omit one of the two");
    if (e.drive.speed && !e.drive.amplitude)
        io::fail(document.place_of("drive.speed"), "drive.speed",
                 "gives the period only together with drive.amplitude",
                 "add amplitude = \"1.1 mm\"");
}

}  // namespace

ExperimentInput read_experiment(const std::string& path) {
    const io::Document document = io::parse_document(io::read_input_file(path, "experiment file"),
                                                     path, is_nested_in_experiment);
    io::require_kind(io::FileKind::experiment, document);
    io::check_names(document, io::KeyList(keys(), {}),
                    {.sections = {"errors"},
                     .is_open = is_nested_in_experiment,
                     .remedy = "docs/experiment.md lists the keys"});
    document.required("kind", R"(add kind = "shakedown", "ratcheting" or "limit")");
    ExperimentInput input;
    Experiment& e = input.experiment;
    io::read_given(keys(), input, document);
    if (input.case_file) input.case_file = document.path_of(*input.case_file);
    input.errors = read_errors(document);
    e.records = read_records(document);
    check_drive(e, document);
    return input;
}

}  // namespace tricontact::experiments

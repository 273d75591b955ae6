#include <algorithm>

#include "experiments/records/experiment.h"
#include "io/case/case_reader.h"
#include "io/case/rig_file.h"
#include "io/case/rig_keys.h"
#include "io/keys/field_reader.h"
#include "io/keys/input_file.h"
#include "io/keys/key_checks.h"
#include "io/keys/messages.h"
#include "io/tables/csv_table.h"

namespace tricontact::experiments {

namespace {

// What [record] says but for its runs.
void read_keys(Experiment& e, const io::Document& document) {
    const auto read = [&](std::string_view path, const io::Field& field) {
        io::read_or_default(io::rig_key(path), field, document, io::case_file_keys());
    };
    read("record.kind", &e.kind);
    read("record.confidence", &e.confidence);
    read("record.resolution", &e.resolution);
    read("record.loading", &e.loading);
    read("record.drive.start", &e.drive.start);
    read("record.drive.period", &e.drive.period);
    read("record.drive.amplitude", &e.drive.amplitude);
    read("record.drive.speed", &e.drive.speed);
    if (document.find("record.drive.periods"))
        read("record.drive.periods", &e.drive.periods.emplace());
}

Record read_record(const std::string& path) {
    // Up to a day of three columns at 20 samples per second.
    const io::CsvTable table =
        io::read_csv_table(path, {"record", "time [s], shift [um], drive [mm]", 2'000'000,
                                  "leave out every second row", 100});
    if (table.has("cycle"))
        io::fail(table.name(), "",
                 "has a column cycle, as friction loops have, and records are those of rolling",
                 "name the table in measurement.friction_loop in place of [record]");
    Record record{.name = table.name(),
                  .time = table.values("time", io::Dimension::time),
                  .shift = table.values("shift", io::Dimension::length),
                  .drive = {}};
    if (table.has("drive")) record.drive = table.values("drive", io::Dimension::length);
    if (table.has("normal_force")) {
        record.normal_force = table.values("normal_force", io::Dimension::force);
        table.check_positive("normal_force");
    }
    if (table.has("tangential_force"))
        record.tangential_force = table.values("tangential_force", io::Dimension::force);
    table.check_names({"time", "shift", "drive", "normal_force", "tangential_force"});
    table.check_increasing("time", "times must increase from row to row",
                           "sort the table, or remove the row");
    return record;
}

std::vector<Record> read_records(const io::Document& document) {
    const io::Key& key = io::rig_key("record.runs");
    const io::Entry& entry = io::required(key, document, io::case_file_keys());
    std::vector<std::string> files;
    io::read_field(key, entry, &files);
    std::vector<Record> records;
    for (const std::string& file : files) records.push_back(read_record(document.path_of(file)));
    return records;
}

/// The same columns in all runs: means are taken of them.
void check_forces(const Experiment& e, const io::Document& document) {
    for (const auto column : {&Record::normal_force, &Record::tangential_force})
        for (const Record& record : e.records)
            if ((record.*column).empty() != (e.records.front().*column).empty())
                io::fail(document.place_of("record.runs"), "",
                         "some runs have a column of forces that others have not",
                         "add it to all, or evaluate them in two files");
}

// What the drive did, if no column says it.
void check_drive(const Experiment& e, const io::Document& document) {
    const auto n_recorded =
        std::ranges::count_if(e.records, [](const Record& r) { return !r.drive.empty(); });
    const bool all = n_recorded == std::ssize(e.records);
    const std::string place = document.place_of("record.drive.start");
    if (!all && n_recorded > 0)
        io::fail(place, "", "some runs have a column drive, others have not",
                 "add it to all, or evaluate them in two files");
    if (all && document.find_section("record.drive"))
        io::fail(document.find_section("record.drive")->place, "",
                 "[record.drive] and the column drive of the runs both give it",
                 "omit one of the two");
    if (all) return;
    if (e.kind == Experiment::Kind::limit)
        io::fail(place, "", "amplitudes that rise in steps need the column drive",
                 "record the drive: time [s], shift [um], drive [mm]");
    if (!e.drive.start || !e.drive.periods)
        io::fail(place, "", "without a column drive its start and number of periods must be known",
                 "add start = \"60 s\" and periods = 12 below [record.drive]");
    if (e.drive.period && e.drive.speed)
        io::fail(document.place_of("record.drive.speed"), "record.drive.speed",
                 "period and speed determine each other", "omit one of the two");
    if (e.drive.speed && !e.drive.amplitude)
        io::fail(document.place_of("record.drive.speed"), "record.drive.speed",
                 "gives the period only together with record.drive.amplitude",
                 "add amplitude = \"1.1 mm\"");
}

}  // namespace

ExperimentInput read_experiment(const std::string& path,
                                const std::vector<std::string>& overrides) {
    const io::Document document =
        io::read_rig_document(path, overrides, "record", "nothing was recorded",
                              "add one with kind = \"shakedown\" and runs = [\"run_1.csv\"], or "
                              "friction loops as measurement.friction_loop; other tables of "
                              "[measurement] are evaluated by tricontact identify");
    ExperimentInput input;
    Experiment& e = input.experiment;
    read_keys(e, document);
    if (const io::Entry* title = document.find("title"))
        io::read_field(*io::find_key("title"), *title, &e.title);
    input.has_laws = document.find("measurement.laws") != nullptr;
    if (input.has_laws) {
        if (!document.find("models"))
            io::refuse(document, "measurement.laws",
                       "records are held against models under each law, and the file names none",
                       "add models = [\"mdr\", \"bem\"]");
        input.case_file = path;
    } else if (document.find("models")) {
        const auto c = io::resolve_case(document, {});  // checked before the records are read
        input.case_file = path;
        input.uncertain = io::uncertain_numbers(document, c);
        std::erase_if(input.uncertain,
                      [](const auto& one) { return !io::find_key(one.key->path); });
        input.correlations =
            io::correlations(document, io::uncertain_keys(document, io::case_file_keys()));
    }
    e.records = read_records(document);
    check_drive(e, document);
    check_forces(e, document);
    return input;
}

}  // namespace tricontact::experiments

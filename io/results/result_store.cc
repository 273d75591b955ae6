#include "io/results/result_store.h"

#include <filesystem>
#include <nlohmann/json.hpp>

#include "files/digest.h"
#include "io/keys/json_text.h"
#include "io/keys/messages.h"
#include "io/results/atomic_file.h"

namespace tricontact::io {

namespace {

constexpr const char* journal_suffix = "-journal";  // SQLite's

// "Tric", so that the file says whose it is; and the number of its form.
constexpr std::int64_t application_id = 0x54726963;
constexpr std::int64_t form = 2;

// One result per point, any number of failures. Times differ from run to run: a table of their own.
// Each row has a digest of all that the program reads of it.
constexpr const char* tables = R"(
CREATE TABLE points (
    id INTEGER PRIMARY KEY,
    key TEXT NOT NULL,
    version TEXT NOT NULL,
    model TEXT NOT NULL,
    resolved_case TEXT NOT NULL,
    results TEXT,
    error TEXT,
    digest TEXT NOT NULL,
    CHECK ((results IS NULL) <> (error IS NULL))
);
CREATE UNIQUE INDEX one_result ON points (key) WHERE results IS NOT NULL;
CREATE INDEX points_by_key ON points (key);
CREATE TABLE times (
    point INTEGER PRIMARY KEY REFERENCES points (id),
    cpu_s REAL NOT NULL,
    wall_s REAL NOT NULL,
    finished TEXT NOT NULL DEFAULT (datetime('now')),
    digest TEXT NOT NULL
);
)";

// A row whose times have gone is there all the same, and damaged.
constexpr const char* selection =
    "SELECT key, version, model, resolved_case, results, error, cpu_s, wall_s, points.digest, "
    "times.digest, id FROM points LEFT JOIN times ON point = id ";
constexpr int first_digest = 8, id_column = 10;

std::int64_t pragma(const SqliteFile& file, const std::string& name) {
    auto statement = file.prepare("PRAGMA " + name);
    return statement.step() ? statement.integer(0) : 0;
}

PointOutcome outcome_of(const SqliteFile::Statement& row) {
    return {.key = row.text(0).value_or(""),
            .version = row.text(1).value_or(""),
            .model = row.text(2).value_or(""),
            .resolved = row.text(3).value_or(""),
            .results = row.text(4),
            .error = row.text(5),
            .cpu_s = row.number(6),
            .wall_s = row.number(7)};
}

void add_optional(files::Digest& digest, const std::optional<std::string>& text) {
    digest << (text ? "there" : "none") << text.value_or("");
}

std::string content_digest(const PointOutcome& outcome) {
    files::Digest digest;
    digest << outcome.key << outcome.version << outcome.model << outcome.resolved;
    add_optional(digest, outcome.results);
    add_optional(digest, outcome.error);
    return digest.text();
}

std::string times_digest(const PointOutcome& outcome) {
    files::Digest digest;
    digest << outcome.key;
    digest.add(&outcome.cpu_s, sizeof outcome.cpu_s).add(&outcome.wall_s, sizeof outcome.wall_s);
    return digest.text();
}

bool is_whole(const SqliteFile::Statement& row) {
    const PointOutcome outcome = outcome_of(row);
    return row.text(first_digest) == content_digest(outcome) &&
           row.text(first_digest + 1) == times_digest(outcome) &&
           (!outcome.results || is_sound_json(*outcome.results));
}

void insert(SqliteFile& file, const PointOutcome& outcome) {
    file.prepare(
            "INSERT INTO points (key, version, model, resolved_case, results, error, digest) "
            "VALUES (?, ?, ?, ?, ?, ?, ?)")
        .bind(outcome.key, outcome.version, outcome.model, outcome.resolved, outcome.results,
              outcome.error, content_digest(outcome))
        .step();
    file.prepare(
            "INSERT INTO times (point, cpu_s, wall_s, digest) "
            "VALUES (last_insert_rowid(), ?, ?, ?)")
        .bind(outcome.cpu_s, outcome.wall_s, times_digest(outcome))
        .step();
}

// All of the work, or nothing.
template <class Work>
void in_transaction(SqliteFile& file, const Work& work) {
    file.execute("BEGIN IMMEDIATE");
    try {
        work();
        file.execute("COMMIT");
    } catch (...) {
        try {
            file.execute("ROLLBACK");
        } catch (...) {  // SQLite has rolled back by itself
        }
        throw;
    }
}

}  // namespace

ResultStore::ResultStore(const std::string& path, Mode mode)
    : file_(path, mode == Mode::write ? SqliteFile::Open::create : SqliteFile::Open::existing) {
    if (mode == Mode::write) {
        if (file_.is_read_only())
            fail(path, "", "cannot be written (the file is read-only)",
                 "give yourself the permission, or choose another output folder");
        file_.execute("PRAGMA journal_mode = DELETE");
        file_.execute("PRAGMA synchronous = EXTRA");
        if (pragma(file_, "schema_version") != 0) remove_ended_journal();
        file_.execute("PRAGMA locking_mode = EXCLUSIVE");
        file_.execute("BEGIN EXCLUSIVE; COMMIT");  // from now on nobody else
        if (pragma(file_, "schema_version") == 0) make_tables();
    }
    check_kind();
    file_.check_integrity();
    if (mode == Mode::write) remove_damaged();
}

// A process that was killed between two transactions leaves a journal that has ended, which SQLite
// lets lie. That of an unfinished transaction has been rolled back, and is gone, once the file was
// read; without a file to roll back SQLite removes it, too. Nobody writes meanwhile.
void ResultStore::remove_ended_journal() {
    file_.execute("BEGIN EXCLUSIVE");
    std::filesystem::remove(file_.path() + journal_suffix);
    file_.execute("COMMIT");
}

void ResultStore::check_kind() const {
    if (pragma(file_, "application_id") != application_id)
        fail(file_.path(), "", "is no file of results", "name another, or move it away");
    if (pragma(file_, "user_version") != form)
        fail(file_.path(), "",
             "was written by another version of the program, whose rows this one does not trust",
             "move it away, and its points are computed again; or choose another output folder");
}

// What is removed is computed again.
void ResultStore::remove_damaged() {
    std::vector<std::int64_t> damaged;
    auto rows = file_.prepare(selection);
    while (rows.step())
        if (!is_whole(rows)) damaged.push_back(rows.integer(id_column));
    if (damaged.empty()) return;
    in_transaction(file_, [&] {
        for (const std::int64_t id : damaged) {
            file_.prepare("DELETE FROM times WHERE point = ?").bind(id).step();
            file_.prepare("DELETE FROM points WHERE id = ?").bind(id).step();
        }
    });
    n_damaged_ = damaged.size();
}

void ResultStore::make_tables() {
    in_transaction(file_, [&] {
        file_.execute(tables);
        file_.execute("PRAGMA application_id = " + std::to_string(application_id));
        file_.execute("PRAGMA user_version = " + std::to_string(form));
    });
}

std::optional<PointOutcome> ResultStore::find(const std::string& key) const {
    auto row = file_.prepare(std::string(selection) +
                             "WHERE key = ? ORDER BY results IS NULL, id DESC LIMIT 1");
    row.bind(key);
    if (!row.step()) return {};
    const PointOutcome outcome = outcome_of(row);
    if (outcome.key != key || !is_whole(row))
        fail(
            file_.path(), "point " + key, "its row is damaged",
            "call `tricontact sweep` again, which removes such rows and computes the points again");
    return outcome;
}

void ResultStore::add(std::span<const PointOutcome> outcomes) {
    in_transaction(file_, [&] {
        for (const PointOutcome& outcome : outcomes) {
            const auto found = find(outcome.key);
            if (!found || !found->results) insert(file_, outcome);
        }
    });
}

ResultStore::Merged ResultStore::merge(const ResultStore& other) {
    Merged merged;
    const auto take_over = [&](const PointOutcome& outcome) {
        const auto here = find(outcome.key);
        if (here && here->results) {
            merged.different += outcome.results && *outcome.results != *here->results;
        } else if (!here || here->error != outcome.error) {
            insert(file_, outcome);
            ++(outcome.results ? merged.points : merged.failures);
        }
    };
    in_transaction(file_, [&] {
        auto rows = other.file_.prepare(std::string(selection) + "ORDER BY id");
        while (rows.step())
            if (is_whole(rows))
                take_over(outcome_of(rows));
            else
                ++merged.damaged;
    });
    return merged;
}

bool is_result_store(const std::string& path) {
    // SQLite's file format, section 1.3: the application's number, big-endian, from byte 68.
    constexpr std::string_view magic("SQLite format 3\0", 16);
    constexpr std::size_t start = 68;
    const std::string head = first_bytes(path, start + 4);
    if (head.size() < start + 4) return false;
    std::int64_t number = 0;
    for (std::size_t i = start; i < head.size(); ++i)
        number = 256 * number + static_cast<unsigned char>(head[i]);
    return head.starts_with(magic) && number == application_id;
}

std::vector<std::string> result_store_files() {
    return {result_store_name, std::string(result_store_name) + journal_suffix};
}

}  // namespace tricontact::io

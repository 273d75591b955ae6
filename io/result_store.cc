#include "io/result_store.h"

#include "io/messages.h"

namespace tricontact::io {

namespace {

// "Tric", so that the file says whose it is; and the number of its form.
constexpr std::int64_t application_id = 0x54726963;
constexpr std::int64_t form = 1;

// One result per point, any number of failures. Times differ from run to run: a table of their own.
constexpr const char* tables = R"(
CREATE TABLE points (
    id INTEGER PRIMARY KEY,
    key TEXT NOT NULL,
    version TEXT NOT NULL,
    model TEXT NOT NULL,
    resolved_case TEXT NOT NULL,
    results TEXT,
    error TEXT,
    CHECK ((results IS NULL) <> (error IS NULL))
);
CREATE UNIQUE INDEX one_result ON points (key) WHERE results IS NOT NULL;
CREATE INDEX points_by_key ON points (key);
CREATE TABLE times (
    point INTEGER PRIMARY KEY REFERENCES points (id),
    cpu_s REAL NOT NULL,
    wall_s REAL NOT NULL,
    finished TEXT NOT NULL DEFAULT (datetime('now'))
);
)";

constexpr const char* columns = "key, version, model, resolved_case, results, error, cpu_s, wall_s";

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

void insert(SqliteFile& file, const PointOutcome& outcome) {
    file.prepare(
            "INSERT INTO points (key, version, model, resolved_case, results, error) "
            "VALUES (?, ?, ?, ?, ?, ?)")
        .bind(0, std::string_view(outcome.key))
        .bind(1, std::string_view(outcome.version))
        .bind(2, std::string_view(outcome.model))
        .bind(3, std::string_view(outcome.resolved))
        .bind(4, outcome.results)
        .bind(5, outcome.error)
        .step();
    file.prepare("INSERT INTO times (point, cpu_s, wall_s) VALUES (last_insert_rowid(), ?, ?)")
        .bind(0, outcome.cpu_s)
        .bind(1, outcome.wall_s)
        .step();
}

// Everything between construction and `commit`, or nothing.
class Transaction {
  public:
    explicit Transaction(SqliteFile& file) : file_(file) { file_.execute("BEGIN IMMEDIATE"); }
    ~Transaction() {
        if (committed_) return;
        try {
            file_.execute("ROLLBACK");
        } catch (...) {  // SQLite has rolled back by itself
        }
    }
    Transaction(const Transaction&) = delete;
    Transaction& operator=(const Transaction&) = delete;
    void commit() {
        file_.execute("COMMIT");
        committed_ = true;
    }

  private:
    SqliteFile& file_;
    bool committed_ = false;
};

}  // namespace

ResultStore::ResultStore(const std::string& path, Mode mode)
    : file_(path, mode == Mode::write ? SqliteFile::Open::create : SqliteFile::Open::existing) {
    if (mode == Mode::write) {
        if (file_.is_read_only())
            fail(path, "", "cannot be written (the file is read-only)",
                 "give yourself the permission, or choose another output folder");
        file_.execute("PRAGMA journal_mode = DELETE");
        file_.execute("PRAGMA synchronous = EXTRA");
        file_.execute("PRAGMA locking_mode = EXCLUSIVE");
        file_.execute("BEGIN EXCLUSIVE; COMMIT");  // from now on nobody else
        if (pragma(file_, "schema_version") == 0) make_tables();
    }
    check_kind();
}

void ResultStore::check_kind() const {
    if (pragma(file_, "application_id") != application_id)
        fail(file_.path(), "", "is no file of results", "name another, or move it away");
    if (pragma(file_, "user_version") != form)
        fail(file_.path(), "", "was written by another version of the program",
             "use that version, or another output folder");
}

void ResultStore::make_tables() {
    Transaction transaction(file_);
    file_.execute(tables);
    file_.execute("PRAGMA application_id = " + std::to_string(application_id));
    file_.execute("PRAGMA user_version = " + std::to_string(form));
    transaction.commit();
}

std::optional<PointOutcome> ResultStore::find(const std::string& key) const {
    auto row = file_.prepare(std::string("SELECT ") + columns +
                             " FROM points JOIN times ON point = id WHERE key = ? "
                             "ORDER BY results IS NULL, id DESC LIMIT 1");
    row.bind(0, std::string_view(key));
    if (!row.step()) return {};
    return outcome_of(row);
}

void ResultStore::add(std::span<const PointOutcome> outcomes) {
    Transaction transaction(file_);
    for (const PointOutcome& outcome : outcomes) {
        const auto found = find(outcome.key);
        if (!found || !found->results) insert(file_, outcome);
    }
    transaction.commit();
}

ResultStore::Merged ResultStore::merge(const ResultStore& other) {
    Merged merged;
    Transaction transaction(file_);
    auto rows = other.file_.prepare(std::string("SELECT ") + columns +
                                    " FROM points JOIN times ON point = id ORDER BY id");
    while (rows.step()) {
        const PointOutcome outcome = outcome_of(rows);
        const auto here = find(outcome.key);
        if (here && here->results) {
            merged.different += outcome.results && *outcome.results != *here->results;
            continue;
        }
        if (here && here->error == outcome.error) continue;
        insert(file_, outcome);
        ++(outcome.results ? merged.points : merged.failures);
    }
    transaction.commit();
    return merged;
}

}  // namespace tricontact::io

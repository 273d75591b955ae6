#include "io/results/sqlite_file.h"

#include <sqlite3.h>

#include <filesystem>
#include <system_error>

#include "io/keys/messages.h"

namespace tricontact::io {

namespace {

namespace fs = std::filesystem;

constexpr const char* damaged_remedy =
    "move it away, and what it held is computed again; `sqlite3 FILE .recover` may save it";
constexpr int patience = 2000;  // ms for another program to let go of the file

struct Refusal {
    const char* rule;
    const char* remedy;
};

// `code` is an extended one. A limit on the size of files or on the user's share of the disk makes
// writes fail, which SQLite does not tell from a broken disk.
Refusal refusal_of(int code) {
    if (code == SQLITE_FULL || code == SQLITE_IOERR_WRITE)
        return {"cannot be written",
                "free space on the disk and call again: what is stored stays, the rest goes on"};
    code &= 0xff;
    if (code == SQLITE_BUSY || code == SQLITE_LOCKED)
        return {"is in use by another program",
                "wait until that has ended, or choose another output folder"};
    if (code == SQLITE_READONLY || code == SQLITE_PERM || code == SQLITE_AUTH)
        return {"cannot be written", "choose an output folder in which you may write"};
    if (code == SQLITE_CANTOPEN) return {"cannot be opened", "check path and permissions"};
    if (code == SQLITE_NOTADB) return {"is no file of results", "name another, or move it away"};
    // All statements are ours: what is wrong with one is wrong with the tables.
    if (code == SQLITE_CORRUPT || code == SQLITE_ERROR || code == SQLITE_CONSTRAINT ||
        code == SQLITE_MISMATCH || code == SQLITE_SCHEMA || code == SQLITE_FORMAT)
        return {"is damaged", damaged_remedy};
    return {"failed", "check the disk, and call again"};
}

}  // namespace

SqliteFile::SqliteFile(const std::string& path, Open how) : path_(path) {
    std::error_code ignored;
    if (fs::exists(path, ignored) && !fs::is_regular_file(path, ignored))
        fail(path, "", "is not a regular file", "name another, or move it away");
    const int create = how == Open::create ? SQLITE_OPEN_CREATE : 0;
    sqlite3* database = nullptr;
    const int code =
        sqlite3_open_v2(path.c_str(), &database, SQLITE_OPEN_READWRITE | create, nullptr);
    database_ = {database, sqlite3_close};
    check(code);
    sqlite3_busy_timeout(database, patience);
}

void SqliteFile::execute(const std::string& sql) {
    check(sqlite3_exec(database_.get(), sql.c_str(), nullptr, nullptr, nullptr));
}

SqliteFile::Statement SqliteFile::prepare(std::string_view sql) const {
    sqlite3_stmt* prepared = nullptr;
    check(sqlite3_prepare_v2(database_.get(), sql.data(), static_cast<int>(sql.size()), &prepared,
                             nullptr));
    Statement statement;
    statement.file_ = this;
    statement.statement_ = {prepared, sqlite3_finalize};
    return statement;
}

bool SqliteFile::is_read_only() const {
    return sqlite3_db_readonly(database_.get(), "main") == 1;
}

void SqliteFile::check_integrity() const {
    auto statement = prepare("PRAGMA integrity_check(1)");
    const std::string found = statement.step() ? statement.text(0).value_or("") : "";
    if (found != "ok")
        fail(path_, "", "is damaged (" + shortened(found, 200) + ')', damaged_remedy);
}

void SqliteFile::check(int code) const {
    if (code == SQLITE_OK || code == SQLITE_ROW || code == SQLITE_DONE) return;
    if (!database_) fail(path_, "", "not enough memory to open it", "");
    const Refusal refusal = refusal_of(sqlite3_extended_errcode(database_.get()));
    fail(path_, "", std::string(refusal.rule) + " (" + sqlite3_errmsg(database_.get()) + ')',
         refusal.remedy);
}

void SqliteFile::Statement::set(int parameter, const std::optional<std::string>& text) {
    file_->check(text ? sqlite3_bind_text(statement_.get(), parameter, text->data(),
                                          static_cast<int>(text->size()), SQLITE_TRANSIENT)
                      : sqlite3_bind_null(statement_.get(), parameter));
}

void SqliteFile::Statement::set(int parameter, double value) {
    file_->check(sqlite3_bind_double(statement_.get(), parameter, value));
}

void SqliteFile::Statement::set(int parameter, std::int64_t value) {
    file_->check(sqlite3_bind_int64(statement_.get(), parameter, value));
}

bool SqliteFile::Statement::step() {
    const int code = sqlite3_step(statement_.get());
    file_->check(code);
    return code == SQLITE_ROW;
}

std::optional<std::string> SqliteFile::Statement::text(int column) const {
    const unsigned char* text = sqlite3_column_text(statement_.get(), column);
    if (!text) return {};
    const auto size = static_cast<std::size_t>(sqlite3_column_bytes(statement_.get(), column));
    return std::string(reinterpret_cast<const char*>(text), size);
}

double SqliteFile::Statement::number(int column) const {
    return sqlite3_column_double(statement_.get(), column);
}

std::int64_t SqliteFile::Statement::integer(int column) const {
    return sqlite3_column_int64(statement_.get(), column);
}

}  // namespace tricontact::io

#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

struct sqlite3;
struct sqlite3_stmt;

namespace tricontact::io {

/// An SQLite database file. Every member throws contact::InputError with the path, SQLite's reason
/// and a remedy where SQLite or the system refuses: no space, no permission, in use, no database.
/// Not for use on both sides of a fork.
class SqliteFile {
  public:
    /// A statement that is being carried out: columns count from 0.
    class Statement {
      public:
        template <class... Values>
        Statement& bind(const Values&... values) {
            int parameter = 0;
            (set(++parameter, values), ...);
            return *this;
        }
        /// Goes on to the next row; false after the last one.
        bool step();
        std::optional<std::string> text(int column) const;
        double number(int column) const;
        std::int64_t integer(int column) const;

      private:
        friend class SqliteFile;
        void set(int parameter, const std::optional<std::string>& text);  // from 1
        void set(int parameter, double value);
        void set(int parameter, std::int64_t value);

        const SqliteFile* file_ = nullptr;
        std::unique_ptr<sqlite3_stmt, int (*)(sqlite3_stmt*)> statement_{nullptr, nullptr};
    };

    enum class Open { existing, create };

    SqliteFile(const std::string& path, Open how);

    void execute(const std::string& sql);
    Statement prepare(std::string_view sql) const;
    bool is_read_only() const;
    /// Throws if the file's pages, tables and indices do not fit together.
    void check_integrity() const;
    const std::string& path() const { return path_; }

  private:
    void check(int code) const;

    std::string path_;
    std::unique_ptr<sqlite3, int (*)(sqlite3*)> database_{nullptr, nullptr};
};

}  // namespace tricontact::io

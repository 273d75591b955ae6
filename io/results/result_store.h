#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "io/results/sqlite_file.h"

namespace tricontact::io {

/// What became of one point of a study.
struct PointOutcome {
    std::string key;      ///< of everything that the results depend on
    std::string version;  ///< of the program
    std::string model;
    std::string resolved;                     ///< text of the case
    std::optional<std::string> results = {};  ///< JSON object of numbers and words; empty: failed
    std::optional<std::string> error = {};    ///< of a point that failed
    double cpu_s = 0, wall_s = 0;
};

/// The results of studies in one SQLite file: rows are only ever appended, a point has one result
/// at most. Each row carries digests of what it holds: no number is taken from one that does not
/// fit them. What `add` has written survives kill -9 and power loss: a rollback journal, synced
/// with its folder at each commit. No write-ahead log: that needs memory shared by the file's
/// users, which the network file systems of clusters lack, and points end too seldom for its speed
/// to count. All members throw contact::InputError with path, reason and remedy.
class ResultStore {
  public:
    enum class Mode { read, write };

    /// Mode::write makes the file if it is missing and keeps others out until the store is gone.
    explicit ResultStore(const std::string& path, Mode mode = Mode::write);

    /// Rows that were damaged when the store was opened for writing, and have been removed: their
    /// points are to be computed again.
    std::size_t n_damaged() const { return n_damaged_; }

    /// The result of a point, else its last failure, else nothing. Throws also if its row is
    /// damaged.
    std::optional<PointOutcome> find(const std::string& key) const;

    /// Durable when it returns, all or nothing. A second result of a point is left out.
    void add(std::span<const PointOutcome> outcomes);
    void add(const PointOutcome& outcome) { add(std::span(&outcome, 1)); }

    struct Merged {
        std::int64_t points = 0;     ///< taken over
        std::int64_t failures = 0;   ///< of points without a result here, taken over
        std::int64_t different = 0;  ///< points with other results here: these stay
        std::int64_t damaged = 0;    ///< rows of `other` that are left out
    };
    /// Takes over what `other` has and this store has not, all or nothing.
    Merged merge(const ResultStore& other);

  private:
    void remove_ended_journal();
    void check_kind() const;
    void make_tables();
    void remove_damaged();

    SqliteFile file_;
    std::size_t n_damaged_ = 0;
};

/// Name of the store in the folder of a sweep.
inline constexpr const char* result_store_name = "results.sqlite";

/// Whether a file is such a store, by its first bytes.
bool is_result_store(const std::string& path);

/// The names that a store takes in its folder: its own, and that of SQLite's journal.
std::vector<std::string> result_store_files();

}  // namespace tricontact::io

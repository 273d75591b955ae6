#include "benchmarks/submissions/table_field.h"

#include <algorithm>
#include <functional>

#include "benchmarks/submissions/columns.h"
#include "benchmarks/submissions/total_keys.h"
#include "io/keys/key_checks.h"
#include "io/keys/messages.h"
#include "io/tables/csv_table.h"

namespace tricontact::benchmarks {

namespace {

bool is_word(std::string_view text) {
    return !text.empty() && text.size() <= 40 && std::ranges::all_of(text, [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
               c == '_' || c == '-' || c == '.';
    });
}

[[noreturn]] void refuse_key(std::string_view key, const std::string& place) {
    std::vector<std::string_view> known;
    for (const TotalKey& one : total_keys()) known.push_back(one.key);
    io::fail(place, "", "unknown key " + std::string(key),
             io::did_you_mean(io::nearest(key, known),
                              "known are " + io::joined(known) +
                                  "; a comment has several words, or none, before ="));
}

/// Adds what a line "key = value unit" states; a line of another form is free text.
void read_line(std::string_view line, const std::string& place,
               std::map<std::string, Total>& totals) {
    const auto equal = line.find('=');
    const auto colon = line.find(':');
    std::string_view key = io::trimmed(line.substr(0, equal));
    std::string_view value = equal == line.npos ? "" : line.substr(equal + 1);
    const TotalKey* found = equal == line.npos ? nullptr : find_total_key(key);
    if (!found && colon != line.npos) {
        found = find_total_key(io::trimmed(line.substr(0, colon)));
        if (found) value = line.substr(colon + 1);
    }
    if (!found) {
        if (equal != line.npos && is_word(key)) refuse_key(key, place);
        return;
    }
    const auto [at, is_new] = totals.emplace(found->key, Total{});
    if (!is_new)
        io::fail(place, std::string(found->key), "stands twice; first " + at->second.place,
                 "keep one");
    at->second = read_total(*found, value, place);
}

/// Lines that the predicate wants, without their marks.
void for_lines(std::string_view text, const std::function<void(std::string_view, int)>& each) {
    for (int number = 1; !text.empty(); ++number) {
        const auto end = std::min(text.find('\n'), text.size());
        each(text.substr(0, end), number);
        text.remove_prefix(std::min(end + 1, text.size()));
    }
}

std::string_view without_mark(std::string_view line) {
    line = io::trimmed(line);
    return io::trimmed(line.substr(std::min(line.find_first_not_of('#'), line.size())));
}

std::map<std::string, Total> totals_in_comments(std::string_view text, const std::string& name) {
    std::map<std::string, Total> totals;
    for_lines(text, [&](std::string_view line, int number) {
        const auto first = line.find_first_not_of(" \t");
        if (first == line.npos || line[first] != '#') return;
        read_line(without_mark(line), name + ':' + std::to_string(number), totals);
    });
    return totals;
}

/// Rows, if any, are more than lines with the mark of a comment.
bool has_rows(std::string_view text) {
    bool found = false;
    for_lines(text, [&](std::string_view line, int) {
        line = io::trimmed(line);
        found = found || (!line.empty() && line.front() != '#');
    });
    return found;
}

}  // namespace

MeshField parse_table(std::string_view text, const std::string& name) {
    constexpr std::string_view mark = "\xEF\xBB\xBF";
    if (text.starts_with(mark)) text.remove_prefix(mark.size());
    MeshField field{.file = name, .format = "table of columns"};
    field.totals = totals_in_comments(text, name);
    if (!field.totals.empty() && !has_rows(text)) {
        field.format = "numbers alone";
        return field;
    }
    const io::CsvTable table(text, name,
                             {.kind = "table of a contact's field",
                              .header = "r [mm], p [MPa]",
                              .most_rows = most_points,
                              .thinning = "write the surface alone",
                              .most_mb = most_megabytes});
    if (table.n_rows() == 0)
        io::fail(name, "", "the table has no rows", "write for example r [mm], p [MPa]");
    std::vector<RawColumn> columns;
    for (const auto& column : table.columns())
        columns.push_back({column.heading, column.name, column.unit, column.values});
    add_columns(field, std::move(columns), name);
    check_field(field, name);
    return field;
}

std::map<std::string, Total> parse_totals(std::string_view text, const std::string& name) {
    std::map<std::string, Total> totals;
    for_lines(text, [&](std::string_view line, int number) {
        read_line(without_mark(line), name + ':' + std::to_string(number), totals);
    });
    if (totals.empty())
        io::fail(name, "", "holds no resultants", "write lines such as normal_force = 16.7 N");
    return totals;
}

}  // namespace tricontact::benchmarks

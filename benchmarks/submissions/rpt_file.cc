#include "benchmarks/submissions/rpt_file.h"

#include <algorithm>
#include <cmath>

#include "benchmarks/reference/reference.h"
#include "benchmarks/submissions/column_names.h"
#include "benchmarks/submissions/columns.h"
#include "benchmarks/submissions/fixed_columns.h"
#include "benchmarks/submissions/table_field.h"
#include "io/keys/messages.h"
#include "io/keys/number_text.h"

namespace tricontact::benchmarks {

namespace {

constexpr std::string_view report_mark = "Field Output reported at";

struct ReportTable {
    std::string part, place;
    std::vector<std::string> headings;         ///< "Node", "CPRESS"
    std::vector<std::vector<double>> columns;  ///< of them
    std::vector<double> totals;                ///< of the last columns; empty: none stated
};

/// Parts of a line that two blanks divide.
std::vector<std::string> wide_cells(std::string_view text) {
    std::vector<std::string> cells;
    while (true) {
        text = io::trimmed(text);
        if (text.empty()) return cells;
        const auto end = std::min(text.find("  "), text.size());
        cells.emplace_back(text.substr(0, end));
        text.remove_prefix(end);
    }
}

/// "Label  @Loc 1": the second line of headings.
bool is_second_line(std::string_view text) {
    const auto words = io::words_of(text);
    return !words.empty() && std::ranges::all_of(words, [](std::string_view word) {
        return word == "Label" || word == "Pt" || word.starts_with("@Loc") || word == "Node" ||
               io::number_in(word).has_value();
    });
}

std::vector<double> row_of(std::string_view text) {
    std::vector<double> row;
    for (const auto word : io::words_of(text)) {
        const auto value = fortran_number(word);
        if (!value) return {};
        row.push_back(*value);
    }
    return row;
}

/// "COORD.COOR1" is COOR1 of COORD.
std::string component_of(const std::string& heading) {
    const auto dot = heading.find('.');
    return dot == std::string::npos || heading.find(' ') < dot ? heading : heading.substr(dot + 1);
}

class ReportParser {
  public:
    ReportParser(std::string_view text, const std::string& name) : lines_(text), name_(name) {}

    std::vector<ReportTable> parse() {
        std::string part;
        while (lines_.next()) {
            const std::string_view text = io::trimmed(lines_.line());
            if (text.starts_with(report_mark)) {
                const auto colon = text.find(':');
                part = colon == text.npos ? "" : std::string(io::trimmed(text.substr(colon + 1)));
                before_.clear();
            } else if (text.size() > 20 && text.find_first_not_of('-') == text.npos) {
                read_table(part);
            } else if (!text.empty()) {
                if (before_.size() > 1) before_.erase(before_.begin());
                before_.emplace_back(text);
            }
        }
        return std::move(tables_);
    }

  private:
    void read_table(const std::string& part) {
        if (before_.empty()) return;
        ReportTable table{.part = part,
                          .place = name_ + ':' + std::to_string(lines_.number()),
                          .headings = {},
                          .columns = {},
                          .totals = {}};
        const std::string names =
            before_.size() == 2 && is_second_line(before_[1]) ? before_[0] : before_.back();
        before_.clear();
        while (lines_.next()) {
            const std::string_view text = io::trimmed(lines_.line());
            const std::vector<double> row = row_of(text);
            if (row.empty()) break;
            if (table.columns.empty()) begin(table, names, row.size());
            if (row.size() != table.columns.size())
                io::fail(name_ + ':' + std::to_string(lines_.number()), "",
                         "has " + std::to_string(row.size()) + " columns instead of " +
                             std::to_string(table.columns.size()),
                         "write the report again");
            for (std::size_t j = 0; j < row.size(); ++j) {
                if (!std::isfinite(row[j]))
                    io::fail(name_ + ':' + std::to_string(lines_.number()), table.headings[j],
                             "must be a finite number", "write the report again");
                table.columns[j].push_back(row[j]);
            }
            if (table.columns[0].size() > most_points)
                io::fail(name_, "", "has too many rows", "write the surface alone");
        }
        if (!table.columns.empty()) read_totals(std::move(table));
    }

    void begin(ReportTable& table, const std::string& names, std::size_t n) const {
        table.headings = wide_cells(names);
        if (table.headings.size() != n) {
            table.headings.clear();
            for (const auto word : io::words_of(names)) table.headings.emplace_back(word);
        }
        if (table.headings.size() != n || n > 1000)
            io::fail(table.place, io::shortened(names, 40),
                     "names " + std::to_string(table.headings.size()) + " columns, but rows have " +
                         std::to_string(n),
                     "write fewer variables into the report");
        table.columns.resize(n);
    }

    /// Minimum, Maximum and Total stand below; ends at the next part.
    void read_totals(ReportTable table) {
        LineReader ahead = lines_;
        for (int i = 0; i < 20 && ahead.next(); ++i) {
            std::string_view text = io::trimmed(ahead.line());
            if (text.starts_with(report_mark)) break;
            if (!text.starts_with("Total")) continue;
            table.totals = row_of(text.substr(5));
            if (table.totals.size() > table.columns.size()) table.totals.clear();
            break;
        }
        tables_.push_back(std::move(table));
    }

    LineReader lines_;
    std::string name_;
    std::vector<std::string> before_;  // the last two lines that say something
    std::vector<ReportTable> tables_;
};

/// Of tables with the same headings the last one of each part.
std::vector<ReportTable> last_tables(std::vector<ReportTable> tables) {
    std::vector<ReportTable> last;
    for (ReportTable& table : tables) {
        std::erase_if(last, [&](const ReportTable& old) {
            return old.part == table.part && old.headings == table.headings;
        });
        last.push_back(std::move(table));
    }
    return last;
}

MeshField field_of(const std::vector<const ReportTable*>& tables, const std::string& name) {
    MeshField field{.file = name, .format = "Abaqus report"};
    std::vector<RawColumn> columns;
    const ReportTable& first = *tables.front();
    for (const ReportTable* table : tables) {
        if (table->columns.front() != first.columns.front()) {
            field.notes.push_back("the table of " + io::shortened(table->place, 200) +
                                  " is not used: it has other nodes");
            continue;
        }
        for (std::size_t j = table == &first ? 0 : 1; j < table->headings.size(); ++j)
            columns.push_back(
                {table->headings[j], component_of(table->headings[j]), {}, table->columns[j]});
    }
    add_columns(field, std::move(columns), first.place, Twice::specific_first);
    return field;
}

}  // namespace

bool is_field_report(std::string_view text) {
    return text.find(report_mark) != text.npos;
}

MeshField parse_rpt(std::string_view text, const std::string& name, const std::string& set) {
    const std::vector<ReportTable> tables = last_tables(ReportParser(text, name).parse());
    if (tables.empty())
        io::fail(name, "", "the report has no table", "write columns such as COORD and CPRESS");
    std::vector<std::string> parts;
    for (const ReportTable& table : tables)
        if (std::ranges::count(parts, table.part) == 0) parts.push_back(table.part);
    std::vector<MeshField> fields;
    for (const std::string& part : parts) {
        if (!set.empty() && part != set) continue;
        std::vector<const ReportTable*> own;
        for (const ReportTable& table : tables)
            if (table.part == part) own.push_back(&table);
        MeshField field = field_of(own, name);
        if (parts.size() > 1) field.notes.push_back("part " + io::toml_string(part) + " is read");
        if (has_contact(field) || parts.size() == 1) fields.push_back(std::move(field));
    }
    if (fields.empty())
        io::fail(
            name, "",
            set.empty() ? "no part has a contact pressure" : "has no part " + io::toml_string(set),
            "known are " + io::joined(parts));
    if (fields.size() > 1)
        io::fail(name, "", "several parts have contact values: " + io::joined(parts),
                 "name one: set = " + io::toml_string(parts.front()));
    check_field(fields.front(), name);
    return std::move(fields.front());
}

std::map<std::string, Total> parse_rpt_totals(std::string_view text, const std::string& name) {
    std::map<Meaning, Total> sums;
    for (const ReportTable& table : last_tables(ReportParser(text, name).parse())) {
        const std::size_t skipped = table.headings.size() - table.totals.size();
        for (std::size_t j = 0; j < table.totals.size(); ++j) {
            const std::string heading = component_of(table.headings[skipped + j]);
            if (!heading.starts_with("RF")) continue;
            const Meaning meaning = recognised(heading.substr(1)).meaning;
            if (meaning < Meaning::force_x || meaning > Meaning::force_z) continue;
            if (!sums.emplace(meaning, Total{table.totals[j], {}, table.place}).second)
                io::fail(table.place, "", "reaction forces of several parts",
                         "report one part alone");
        }
    }
    const bool has_z = sums.contains(Meaning::force_z);
    const auto normal = sums.find(has_z ? Meaning::force_z : Meaning::force_y);
    if (normal == sums.end())
        io::fail(name, "", "states no total of reaction forces",
                 "report RF with column totals, or write lines such as normal_force = 16.7 N");
    std::map<std::string, Total> totals{{quantity_keys::normal_force, normal->second}};
    if (const auto along = sums.find(Meaning::force_x); along != sums.end() && has_z)
        totals.emplace(quantity_keys::tangential_force, along->second);
    return totals;
}

}  // namespace tricontact::benchmarks

#pragma once

#include <cstddef>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "io/keys/units.h"
#include "io/tables/csv_header.h"

namespace tricontact::io {

/// What a kind of table is like.
struct CsvForm {
    std::string kind;         ///< "DMA table", in messages about the file
    std::string header;       ///< an example: "time [s], shift [um]", in remedies
    std::size_t most_rows;    ///< without the header
    std::string thinning;     ///< what to do about more rows
    std::size_t most_mb = 1;  ///< megabytes of the file
};

/// A table of numbers in a text file: columns divided by commas, semicolons, tabs or blanks, a line
/// above them naming them with their units in brackets: `time [s], shift [um]`, or in a row of
/// units below (see find_header). Pure numbers need no unit. Numbers have a decimal point, or a
/// decimal comma where something else divides. Cells may be quoted; an unnamed first column that
/// counts the rows, empty lines and lines that begin with # are left out.
class CsvTable {
  public:
    struct Column {
        std::string heading;              ///< "shift [um]"
        std::string name;                 ///< "shift"
        std::optional<std::string> unit;  ///< "um"; empty without brackets
        std::vector<double> values;       ///< as they stand in the file, all finite
    };

    /// Throws contact::InputError `file:line: rule; remedy`. `name` stands for the file in
    /// messages.
    CsvTable(std::string_view text, std::string name, CsvForm form);

    const std::string& name() const { return name_; }
    const std::vector<Column>& columns() const { return columns_; }
    std::size_t n_rows() const { return lines_.size(); }

    bool has(std::string_view column) const { return find(column) != nullptr; }
    /// Values of a column in SI units. Throws contact::InputError if it is missing ("did you
    /// mean"), has no unit, or one of another dimension.
    std::vector<double> values(std::string_view column, Dimension dimension) const;

    /// Throws contact::InputError at a column of another name.
    void check_names(std::initializer_list<std::string_view> known) const;
    /// Throws contact::InputError at a value that is zero or negative.
    void check_positive(std::string_view column) const;
    /// Throws contact::InputError `rule; remedy` at a value that does not exceed the one above.
    void check_increasing(std::string_view column, const std::string& rule,
                          const std::string& remedy) const;

    /// Throws contact::InputError about the header line.
    [[noreturn]] void refuse_header(const std::string& rule) const;
    /// Throws contact::InputError about one value: `file:line: column = value: rule; remedy`.
    [[noreturn]] void refuse_value(std::size_t row, std::string_view column,
                                   const std::string& rule, const std::string& remedy) const;

  private:
    void name_columns(const CsvHeader& header, const CsvLines& found);
    void read_rows(const CsvHeader& header, const CsvLines& found);
    std::string place_of(std::size_t line) const { return name_ + ':' + std::to_string(line); }
    const Column* find(std::string_view column) const;
    const Column& at(std::string_view column) const;

    std::string name_;
    CsvForm form_;
    std::string header_place_;        // file:line
    std::vector<std::size_t> lines_;  // of the rows, in the file
    bool counts_rows_ = false;        // a first column without a name does
    bool has_trailing_divider_ = false;
    std::vector<Column> columns_;
};

/// Reads a table from a file, which is named without its folder in messages about the table. Throws
/// contact::InputError.
CsvTable read_csv_table(const std::string& path, const CsvForm& form);

}  // namespace tricontact::io

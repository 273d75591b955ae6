#pragma once

#include <optional>
#include <string_view>
#include <vector>

namespace tricontact::benchmarks {

/// A number as Fortran and C write it in a field: "1.00000E+00", "-1.00000-100", "1.0D+02". Empty
/// if the field holds something else.
std::optional<double> fortran_number(std::string_view field);

/// Up to `most` numbers from the column `begin` on, in fields of twelve characters; where numbers
/// overflow their fields, one after the other. Fewer where the line ends or holds something else.
std::vector<double> numbers_of_twelve(std::string_view line, std::size_t begin, std::size_t most);

/// A field as a whole number; empty if it is none.
std::optional<int> whole_number(std::string_view line, std::size_t begin, std::size_t width);

/// Lines one after the other, without their ends.
class LineReader {
  public:
    explicit LineReader(std::string_view text) : rest_(text) {}
    /// False at the end.
    bool next();
    std::string_view line() const { return line_; }
    std::size_t number() const { return number_; }  ///< from 1

  private:
    std::string_view rest_, line_;
    std::size_t number_ = 0;
};

}  // namespace tricontact::benchmarks

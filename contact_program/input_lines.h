#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace tricontact::contact_program {

/// A number where it stands.
struct InputNumber {
    double value = 0;
    int line = 0, column = 0;

    operator double() const { return value; }
};

/// The values of an input file of CONTACT as its own reader takes them: what follows % is comment,
/// words are parted by blanks, tabs, commas and =, and what a line holds beyond the values that are
/// due is comment, too. Values may go on in further lines. Throws contact::InputError, naming file,
/// line and column.
class InputLines {
  public:
    /// `name` stands for the file in messages.
    InputLines(std::string text, std::string name)
        : text_(std::move(text)), name_(std::move(name)) {}

    /// Nothing but comments is left.
    bool at_end();
    /// The next `n` numbers; `what` they are, for messages. As many as `further` more where the
    /// same line has them.
    std::vector<InputNumber> numbers(std::size_t n, std::string_view what, std::size_t further = 0);
    /// Reads as many numbers and forgets them.
    void skip_numbers(std::size_t n, std::string_view what);
    /// The next `n` numbers, of which the first is an angle [rad]: 90d are degrees. As many as
    /// `further` more where the same line has them.
    std::vector<InputNumber> angle_and_numbers(std::size_t n, std::string_view what,
                                               std::size_t further = 0);
    /// The next word, or what stands between two apostrophes.
    std::string text(std::string_view what);
    /// The next whole number.
    int whole_number(std::string_view what);
    /// `n` digits in one word; a shorter word lacks zeros in front.
    std::vector<int> digits(std::size_t n, std::string_view what);

    /// Line of the last value [1, ...].
    int line() const { return line_; }
    /// At the last value.
    [[noreturn]] void refuse(std::string_view subject, std::string_view rule,
                             std::string_view remedy) const;
    /// "name = number" there.
    [[noreturn]] void refuse(std::string_view name, const InputNumber& number,
                             std::string_view rule, std::string_view remedy) const;
    /// In a line read before.
    [[noreturn]] void refuse_line(int line, std::string_view subject, std::string_view rule,
                                  std::string_view remedy) const;

  private:
    /// Reads the next line that holds words; false at the end.
    bool advance();
    std::string_view next_word(std::string_view what);
    InputNumber next_number(std::string_view what);
    void end_of_values() { next_ = words_.size(); }
    std::string place(int line, int column) const;

    std::string text_, name_;
    std::size_t at_ = 0;  // in the text
    int line_ = 0;
    std::string_view current_;             // line
    std::vector<std::string_view> words_;  // of it
    std::size_t next_ = 0;                 // of them
    int column_ = 0;                       // of the last value
};

/// Throws contact::InputError about a line of the file called `name` that was read before.
[[noreturn]] void refuse_at(const std::string& name, int line, const std::string& subject,
                            std::string_view rule, std::string_view remedy);

}  // namespace tricontact::contact_program

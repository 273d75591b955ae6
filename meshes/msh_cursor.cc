#include "meshes/msh_cursor.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cstring>

#include "meshes/messages.h"

namespace tricontact::meshes {

namespace {

constexpr std::string_view between_numbers = " \t\r\n";
constexpr const char* again = "save or copy the mesh again";

}  // namespace

MshCursor::MshCursor(const MshFile& file, std::string_view part, bool binary)
    : file_(file), rest_(part), binary_(binary) {}

template <class Number>
Number MshCursor::next(const char* what) {
    Number number{};
    if (binary_) {
        if (rest_.size() < sizeof number) refuse(std::string(what) + " is missing", again);
        std::memcpy(&number, rest_.data(), sizeof number);
        rest_.remove_prefix(sizeof number);
        return number;
    }
    rest_.remove_prefix(std::min(rest_.find_first_not_of(between_numbers), rest_.size()));
    const std::string_view word =
        rest_.substr(0, std::min(rest_.find_first_of(between_numbers), rest_.size()));
    if (word.empty()) refuse(std::string(what) + " is missing", again);
    const char* const end = word.data() + word.size();
    const auto [after, error] = std::from_chars(word.data(), end, number);
    if (error != std::errc() || after != end)
        refuse(fmt::format("{} is {}, which is no number or none that it may be", what,
                           in_quotes(word)),
               again);
    rest_.remove_prefix(word.size());
    return number;
}

template int MshCursor::next(const char*);
template std::size_t MshCursor::next(const char*);
template double MshCursor::next(const char*);

std::size_t MshCursor::next_count(const char* what) {
    const auto n = next<std::size_t>(what);
    if (n > rest_.size())
        refuse(fmt::format("{} is {}, of which the file holds fewer", what, n), again);
    return n;
}

std::string_view MshCursor::rest_of_line() {
    const std::string_view line = rest_.substr(0, std::min(rest_.find('\n'), rest_.size()));
    rest_.remove_prefix(line.size());
    return line;
}

MshCursor MshCursor::after_line() const {
    const std::size_t end = std::min(rest_.find('\n'), rest_.size());
    return {file_, rest_.substr(std::min(end + 1, rest_.size()))};
}

void MshCursor::expect_end(const char* what) const {
    if (rest_.find_first_not_of(between_numbers) != rest_.npos)
        refuse(std::string("more follows than ") + what + " that are announced", again);
}

void MshCursor::refuse(const std::string& what, const std::string& remedy) const {
    const auto offset = static_cast<std::size_t>(rest_.data() - file_.bytes.data());
    const auto line = 1 + std::count(file_.bytes.begin(), file_.bytes.begin() + offset, '\n');
    fail(file_.name,
         file_.binary ? fmt::format("byte {}: {}", offset, what)
                      : fmt::format("line {}: {}", line, what),
         remedy);
}

}  // namespace tricontact::meshes

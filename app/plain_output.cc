#include "app/plain_output.h"

#include <algorithm>
#include <string_view>

#include "contact/base/plain_text.h"

namespace tricontact::app {

namespace {

constexpr std::size_t most_waiting = 65536;
constexpr std::string_view erase_line = "\x1b[K";  // of progress bars

/// Bytes at the end that may begin a character of UTF-8, or that command, of which more comes.
std::size_t unfinished(std::string_view text) {
    for (std::size_t n = 1; n <= std::min<std::size_t>(3, text.size()); ++n) {
        const auto byte = static_cast<unsigned char>(text[text.size() - n]);
        const std::size_t length = byte >= 0xF0 ? 4 : byte >= 0xE0 ? 3 : byte >= 0xC0 ? 2 : 1;
        if (length > n) return n;
        if ((byte & 0xC0) != 0x80) break;
    }
    return 0;
}

}  // namespace

PlainOutput::PlainOutput(std::ostream& stream) : stream_(stream), target_(stream.rdbuf(this)) {}

PlainOutput::~PlainOutput() {
    pass_on();
    const std::string rest = contact::plain_text(waiting_);
    target_->sputn(rest.data(), static_cast<std::streamsize>(rest.size()));
    target_->pubsync();
    stream_.rdbuf(target_);
}

bool PlainOutput::pass_on() {
    const std::size_t n = waiting_.size() - unfinished(waiting_);
    std::string plain;
    for (std::size_t at = 0; at < n;) {
        const std::size_t end = std::min(waiting_.find(erase_line, at), n);
        plain += contact::plain_text(std::string_view(waiting_).substr(at, end - at), "\n\t\r");
        if (end < n) plain += erase_line;
        at = end < n ? end + erase_line.size() : n;
    }
    waiting_.erase(0, n);
    const auto size = static_cast<std::streamsize>(plain.size());
    return target_->sputn(plain.data(), size) == size;
}

PlainOutput::int_type PlainOutput::overflow(int_type c) {
    if (traits_type::eq_int_type(c, traits_type::eof())) return traits_type::not_eof(c);
    const char one = traits_type::to_char_type(c);
    return xsputn(&one, 1) == 1 ? c : traits_type::eof();
}

std::streamsize PlainOutput::xsputn(const char* text, std::streamsize n) {
    waiting_.append(text, static_cast<std::size_t>(n));
    const bool has_line =
        std::string_view(text, static_cast<std::size_t>(n)).find('\n') != std::string_view::npos;
    if ((has_line || waiting_.size() > most_waiting) && !pass_on()) return 0;
    return n;
}

int PlainOutput::sync() {
    const bool passed = pass_on();
    return target_->pubsync() == 0 && passed ? 0 : -1;
}

}  // namespace tricontact::app

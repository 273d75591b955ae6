#include "files/line_reader.h"

#include <algorithm>

namespace tricontact::files {

bool LineReader::fill() {
    begin_ = 0;
    end_ = file_.read(buffer_.data(), buffer_.size());
    return end_ > 0;
}

bool LineReader::next(std::string& line, std::size_t longest) {
    line.clear();
    bool any = false;
    while (begin_ < end_ || fill()) {
        any = true;
        const char* const from = buffer_.data() + begin_;
        const char* const to = buffer_.data() + end_;
        const char* const at = std::find(from, to, '\n');
        line.append(from, at);
        begin_ = static_cast<std::size_t>(at - buffer_.data()) + (at != to);
        if (line.size() > longest)
            throw Unreadable("has a line of more than " + std::to_string(longest) + " bytes");
        if (at != to) return true;
    }
    return any;
}

}  // namespace tricontact::files

#include "runs/answer.h"

#include <nlohmann/json.hpp>
#include <sstream>

namespace tricontact::runs {

Answer& Answer::add(const std::string& text) {
    text_ += text;
    return *this;
}

Answer& Answer::note(const std::string& lines, const std::string& of) {
    text_ += lines;
    std::istringstream all(lines);
    for (std::string line; std::getline(all, line);) {
        line.erase(0, line.find_first_not_of(' '));
        notes_.push_back(of + line);
    }
    return *this;
}

std::string Answer::printed(bool as_json) const {
    if (!as_json) return text_;
    const std::string json = json_();
    if (notes_.empty()) return json + (json.ends_with('\n') ? "" : "\n");
    auto data = nlohmann::ordered_json::parse(json);
    data["notes"] = notes_;
    return data.dump(2) + '\n';
}

}  // namespace tricontact::runs

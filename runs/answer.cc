#include "runs/answer.h"

#include <nlohmann/json.hpp>
#include <sstream>

namespace tricontact::runs {

std::string printed(const Answer& answer, bool as_json) {
    if (!as_json) return answer.text;
    if (answer.notes.empty()) return answer.json + (answer.json.ends_with('\n') ? "" : "\n");
    auto data = nlohmann::ordered_json::parse(answer.json);
    std::istringstream lines(answer.notes);
    for (std::string line; std::getline(lines, line);) data["notes"].push_back(line);
    return data.dump(2) + '\n';
}

}  // namespace tricontact::runs

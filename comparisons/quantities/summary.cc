#include "comparisons/quantities/summary.h"

namespace tricontact::comparisons {

using json = nlohmann::ordered_json;

std::string summary_json(const std::string& version, const json& resolved_case,
                         const std::vector<Results>& results, const json& sections) {
    json models = json::object();
    for (const Results& of_model : results) models[of_model.model] = results_json(of_model);
    json document{{"version", version}, {"case", resolved_case}, {"models", models}};
    for (const auto& [name, section] : sections.items())
        if (!section.empty()) document[name] = section;
    return document.dump(2) + "\n";
}

}  // namespace tricontact::comparisons

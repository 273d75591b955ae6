#include "atlas/prediction_json.h"

#include <nlohmann/json.hpp>

#include "report/json_number.h"

namespace tricontact::atlas {

nlohmann::ordered_json json_of(const Prediction& p) {
    auto json = nlohmann::ordered_json::object();
    for (const auto& [quantity, value] : p.entries) {
        json[quantity->key] = report::number(value.value);
        json[std::string(quantity->key) + "_error"] = report::number(value.error);
    }
    if (p.state != contact::State::undecided) json["state"] = contact::name_of(p.state);
    json["rests_on"] = p.rests_on;
    json["gaps"] = p.gaps;
    json["left_out"] = p.left_out;
    json["limitations"] = p.limitations;
    return json;
}

}  // namespace tricontact::atlas

#include "app/case_run.h"
#include "app/commands/command.h"
#include "app/roll_models.h"
#include "atlas/page/atlas_page.h"
#include "atlas/prediction_json.h"
#include "report/format.h"

namespace tricontact::app {

namespace {

using atlas::Prediction;
using Json = nlohmann::ordered_json;

constexpr const char* page_name = "atlas.html";
constexpr const char* json_name = "prediction.json";

struct PredictOptions : CommandOptions {
    bool json = false;
};

std::string text_of(const Prediction& p) {
    std::string text = p.model;
    if (p.state != contact::State::undecided)
        text += fmt::format(": {}", contact::name_of(p.state));
    text += '\n';
    for (const auto& [quantity, value] : p.entries) {
        const bool is_exact = value.error == 0;
        text += fmt::format("  {:<44} {}{}\n", comparisons::label_of(*quantity),
                            is_exact ? report::significant(value.value, 6)
                                     : report::with_error(value.value, value.error),
                            *quantity->unit ? std::string(" ") + quantity->unit : "");
    }
    for (const std::string& gap : p.gaps) text += "  not said: " + gap + '\n';
    return text + fmt::format("  rests on {}\n", fmt::join(p.rests_on, ", "));
}

/// All models, as JSON: a version, the resolved case and what is predicted of each.
std::string json_text(const Case& c, const std::vector<Prediction>& predictions) {
    Json models = Json::object();
    for (const Prediction& p : predictions) models[p.model] = atlas::json_of(p);
    return Json{{"version", files::version},
                {"case", io::case_json(io::write_case(c))},
                {"models", models}}
               .dump(2) +
           '\n';
}

/// The page is about spheres.
bool has_page(const Case& c) {
    return !c.is_line_contact();
}

void write_files(const PredictOptions& options, const Case& c, const std::string& json) {
    if (!has_page(c)) {
        options.fill({{json_name}}, [&] { options.write(json_name, json); });
        return;
    }
    std::string command = "tricontact predict " + options.file;
    for (const std::string& one : options.overrides) command += fmt::format(" --set \"{}\"", one);
    options.fill({{page_name, json_name}}, [&] {
        options.write(json_name, json);
        options.write(page_name,
                      atlas::atlas_page({.title = c.title.empty() ? options.file : c.title,
                                         .version = files::version,
                                         .command = command + " --output " + options.output,
                                         .c = c}));
    });
}

/// What atlases say of a case, without a run; with a folder also as files.
void predict_case(const PredictOptions& options) {
    const Case c = io::read_case(options.file, options.overrides);
    const std::vector<std::string> models =
        options.models.empty() ? options.told_of_file([&] { return atlas::predictable_models(c); })
                               : options.models;
    std::vector<Prediction> predictions;
    for (const std::string& model : models)
        predictions.push_back(options.told_of_file([&] { return atlas::predict(c, model); }));
    const std::string json = json_text(c, predictions);
    if (options.json)
        std::cout << json;
    else
        for (const Prediction& p : predictions) std::cout << text_of(p);
    if (options.output.empty()) return;
    write_files(options, c, json);
    if (options.json) return;
    std::cout << (has_page(c) ? "page: " + options.output + '/' + page_name
                              : std::string("no page: it is about spheres"))
              << '\n';
}

}  // namespace

Command predict_command() {
    return Declared<PredictOptions>("predict", "What the atlases say of a case, without a run",
                                    predict_case)
        .on_case()
        .models("Models (those that an atlas is about)")
        .output("Folder for prediction.json and, of spheres, atlas.html, a page to play with")
        .flag("--json", &PredictOptions::json, "As JSON, keys as in summary.json");
}

}  // namespace tricontact::app

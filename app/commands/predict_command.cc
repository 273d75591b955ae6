#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "app/commands/command.h"
#include "atlas/page/atlas_page.h"
#include "atlas/prediction_json.h"
#include "experiments/predictions/uncertain_prediction.h"
#include "io/case/rig_file.h"
#include "report/format.h"

namespace tricontact::app {

namespace {

using atlas::Prediction;
using Json = nlohmann::ordered_json;

constexpr const char* page_name = "atlas.html";
constexpr const char* json_name = "prediction.json";

struct PredictOptions : CommandOptions {
    int samples = 0;  ///< of the uncertain numbers; 0: none
};

/// As people write it: 4.503 mm. Pure numbers have none.
report::Unit unit_of(const comparisons::Quantity& quantity, double magnitude) {
    return *quantity.unit ? report::fitting_unit(magnitude, quantity.unit) : report::Unit{};
}

std::string text_of(const Prediction& p) {
    std::string text = p.model;
    if (p.state != contact::State::undecided)
        text += fmt::format(": {}", contact::name_of(p.state));
    text += '\n';
    // Before any number: a half-space is not taken for the case's layer.
    for (const std::string& sentence : p.limitations) text += "  " + sentence + '\n';
    for (const auto& [quantity, value] : p.entries) {
        const report::Unit unit = unit_of(*quantity, value.value);
        const double number = value.value / unit.factor;
        text +=
            fmt::format("  {:<44} {}{}{}\n", comparisons::label_of(*quantity),
                        value.error == 0 ? report::significant(number)
                                         : report::with_error(number, value.error / unit.factor),
                        unit.symbol.empty() ? "" : " ", unit.symbol);
    }
    for (const std::string& gap : p.gaps) text += "  no value: " + gap + '\n';
    for (const std::string& one : p.left_out) text += "  leaves out " + one + '\n';
    return text + fmt::format("  rests on {}\n", fmt::join(p.rests_on, ", "));
}

/// Shares of the variance, the largest first, as far as they are a percent.
std::string contributors(const experiments::SampledQuantity& sampled,
                         const std::vector<std::string>& numbers) {
    if (!sampled.indices) return "";
    std::vector<std::pair<double, std::string>> shares;
    for (std::size_t i = 0; i < numbers.size(); ++i)
        if (const double share = 100 * sampled.indices->total[i]; share >= 1)
            shares.emplace_back(share, fmt::format("{} {:.0f} %", numbers[i], share));
    std::ranges::sort(shares, std::greater());
    std::vector<std::string> words;
    for (auto& [share, word] : shares) words.push_back(std::move(word));
    return "; by " + fmt::format("{}", fmt::join(words, ", "));
}

std::string text_of(const experiments::SampledPrediction& p) {
    std::string text =
        fmt::format("{}: {} samples of {}\n", p.model, p.n_samples, fmt::join(p.numbers, ", "));
    if (!p.quantities.empty() && !p.quantities.front().indices)
        text += "  numbers are correlated: the variance has no shares that add up\n";
    if (p.ratchets) text += fmt::format("  ratchets in {:.3g} % of them\n", 100 * *p.ratchets);
    if (p.outside > 0) text += fmt::format("  beyond the maps in {:.3g} %\n", 100 * p.outside);
    for (const experiments::SampledQuantity& one : p.quantities) {
        if (!(one.standard_deviation > 0)) continue;
        const report::Unit unit =
            unit_of(*one.quantity, std::max(std::abs(one.low), std::abs(one.high)));
        text += fmt::format(
            "  {:<44} {} to {}{}{} (95 %){}\n", comparisons::label_of(*one.quantity),
            report::significant(one.low / unit.factor), report::significant(one.high / unit.factor),
            unit.symbol.empty() ? "" : " ", unit.symbol, contributors(one, p.numbers));
    }
    return text;
}

Json json_of(const experiments::SampledPrediction& p) {
    Json quantities = Json::object();
    for (const experiments::SampledQuantity& one : p.quantities)
        quantities[one.quantity->key] = {
            {"mean", one.mean},
            {"standard_deviation", one.standard_deviation},
            {"quantile_2.5_percent", one.low},
            {"quantile_97.5_percent", one.high},
            {"first_order_indices", one.indices ? Json(one.indices->first) : Json()},
            {"total_indices", one.indices ? Json(one.indices->total) : Json()}};
    return {{"numbers", p.numbers},
            {"samples", p.n_samples},
            {"share_beyond_the_maps", p.outside},
            {"share_that_ratchets", p.ratchets ? Json(*p.ratchets) : Json()},
            {"quantities", quantities}};
}

/// All models, as JSON: a version, the resolved case and what is predicted of each.
std::string json_text(const Case& c, const std::vector<Prediction>& predictions,
                      const std::vector<experiments::SampledPrediction>& samples) {
    Json models = Json::object();
    for (const Prediction& p : predictions) models[p.model] = atlas::json_of(p);
    for (const experiments::SampledPrediction& p : samples)
        models[p.model]["over_uncertainties"] = json_of(p);
    return Json{{"version", files::version},
                {"case", io::case_json(io::write_case(c))},
                {"models", models}}
               .dump(2) +
           '\n';
}

/// The page is about spheres and Coulomb's law.
bool has_page(const Case& c) {
    return !c.is_line_contact() && c.friction.is_coulomb() && !c.adhesion;
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
void predict_case(PredictOptions& options) {
    const io::RigFile rig = io::read_rig_file(options.file, options.overrides);
    const Case& c = rig.c;
    if (options.samples > 0) options.reads->emplace_back(io::uncertainty_mark);
    if (options.samples > 0 && rig.uncertain_of_case().empty())
        options.refuse(
            "no number of the case states an uncertainty; write for example thickness = "
            "\"8 ± 0.1 mm\", or leave out --samples");
    const std::vector<std::string> models =
        options.models.empty() ? options.told_of_file([&] { return atlas::predictable_models(c); })
                               : options.models;
    std::vector<Prediction> predictions;
    for (const std::string& model : models)
        predictions.push_back(options.told_of_file([&] { return atlas::predict(c, model); }));
    std::vector<experiments::SampledPrediction> samples;
    if (options.samples > 0)
        for (const std::string& model : models)
            samples.push_back(options.told_of_file([&] {
                return experiments::sampled_prediction(c, model, rig.uncertain_of_case(),
                                                       rig.correlations, options.samples);
            }));
    const std::string json = json_text(c, predictions, samples);
    std::string text;
    for (const Prediction& p : predictions) text += text_of(p);
    for (const experiments::SampledPrediction& p : samples) text += text_of(p);
    options.answer(Answer([&] { return json; }, text));
    if (options.output.empty()) return;
    write_files(options, c, json);
    if (options.json) return;
    options.out() << (has_page(c) ? "page: " + options.output + '/' + page_name
                                  : std::string("no page: it is about spheres under Coulomb's law"))
                  << '\n';
}

}  // namespace

Command predict_command() {
    return Declared<PredictOptions>(Group::compute, "predict",
                                    "Predict a case from the atlases, without a run", predict_case)
        .on_case()
        .models("Models (those that an atlas is about)")
        .output("Folder for prediction.json and, of spheres, atlas.html, an interactive page")
        .number("--samples", &PredictOptions::samples,
                "Points of the uncertain numbers of the case, for distributions and Sobol' indices",
                2, 1'000'000)
        .json("As JSON, keys as in summary.json");
}

}  // namespace tricontact::app

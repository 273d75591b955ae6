#include <nlohmann/json.hpp>

#include "app/commands/command.h"
#include "app/models/roll_models.h"
#include "verification/verification_rows.h"

namespace tricontact::app {

namespace {

struct VerifyOptions : CommandOptions {
    bool brief = false;  ///< on coarse levels, in seconds
};

/// Runs the models on problems whose solution is known and prints the table of their errors
/// (docs/reference/verification.md). False if a row fails.
bool verify_models(const VerifyOptions& options) {
    const auto roll_on = [](const std::string& model, const Case& c) {
        return roll(model, c, {.points = 0});
    };
    comparisons::Verification result;
    const auto print = [&] {
        result = verification::verify(options.brief, {*options.makers, roll_on, options.sayer()});
        const std::string text = comparisons::verification_markdown(result);
        options.answer(Answer(
            [&] { return comparisons::verification_json(files::version, result).dump(2); }, text));
        return text;
    };
    if (options.output.empty())
        print();
    else
        options.fill({{"verification.md", "verification.json"}}, [&] {
            options.write("verification.md", print());
            options.write("verification.json",
                          comparisons::verification_json(files::version, result).dump(2) + "\n");
        });
    return result.passed();
}

}  // namespace

Command verify_command() {
    return Declared<VerifyOptions>(Group::trust, "verify",
                                   "Compare the models with exact solutions", verify_models)
        .flag("--short", &VerifyOptions::brief, "On coarse levels, in seconds")
        .output("Folder for verification.md and .json")
        .json()
        .quiet("No progress");
}

}  // namespace tricontact::app

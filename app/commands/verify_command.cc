#include "app/commands/command.h"
#include "verification/verification_rows.h"

namespace tricontact::app {

namespace {

Verification verify(bool brief, const Say& say) {
    Verification all;
    verify_half_space(brief, say, all);
    verify_layer(brief, say, all);
    verify_cylinder(brief, say, all);
    verify_creep(brief, say, all);
    verify_subsurface(brief, say, all);
    verify_rolling(brief, say, all);
    if (brief) return all;
    verify_friction_pressing(say, all);
    verify_peer_shifts(say, all);
    verify_fem(say, all);
    verify_walking(say, all);
    return all;
}

struct VerifyOptions : CommandOptions {
    bool brief = false;  ///< on coarse levels, in seconds
};

/// Runs the models on problems whose solution is known and prints the table of their errors
/// (docs/reference/verification.md). False if a row fails.
bool verify_models(const VerifyOptions& options) {
    Verification result;
    const auto print = [&] {
        result = verify(options.brief, options.sayer());
        const std::string text = comparisons::verification_markdown(result);
        std::cout << text;
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
        .quiet("No progress");
}

}  // namespace tricontact::app

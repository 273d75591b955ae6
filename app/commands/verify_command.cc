#include <functional>
#include <iostream>

#include "app/commands/commands.h"
#include "app/models.h"
#include "app/verification/verification_problems.h"
#include "files/version.h"
#include "io/results/atomic_file.h"
#include "io/results/output_folder.h"

namespace tricontact::app {

namespace {

using comparisons::Verification;

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

}  // namespace

bool verify_command(const VerifyOptions& options) {
    const Say say = [&](const std::string& line) {
        if (!options.quiet) std::cerr << line << '\n';
    };
    if (options.output.empty()) {
        const Verification result = verify(options.brief, say);
        std::cout << comparisons::verification_markdown(result);
        return result.passed();
    }
    io::OutputFolder folder(options.output, {{"verification.md", "verification.json"}});
    Verification result;
    folder.fill([&] {
        result = verify(options.brief, say);
        const std::string text = comparisons::verification_markdown(result);
        std::cout << text;
        io::write_file(options.output + "/verification.md", text);
        io::write_file(options.output + "/verification.json",
                       comparisons::verification_json(files::version, result).dump(2) + "\n");
    });
    return result.passed();
}

}  // namespace tricontact::app

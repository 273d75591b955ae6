#include "runs/point_key.h"

#include <array>

#include "bem/settings.h"
#include "contact/base/error.h"
#include "fem/settings.h"
#include "files/digest.h"
#include "files/regular_file.h"
#include "files/version.h"

namespace tricontact::runs {

namespace {

std::string digest_of_file(const std::string& path) {
    try {
        files::RegularFile file(path);
        files::Digest digest;
        std::array<char, 65536> buffer{};
        while (const std::size_t n = file.read(buffer.data(), buffer.size()))
            digest.add(buffer.data(), n);
        return digest.text();
    } catch (const files::Unreadable& why) {
        throw contact::InputError(path + ": " + why.what() + "; name a readable file");
    }
}

}  // namespace

std::string program_identity() {
    return std::string(files::version) + '\n' + std::string(numerics_digest());
}

std::string point_key(const std::string& resolved) {
    return files::digest_of(program_identity() + '\n' + resolved);
}

std::string file_digests(const contact::Case& c) {
    std::string digests;
    for (const auto* name :
         {&c.indenter.file, &c.of<bem::Settings>().influence, &c.of<fem::Settings>().mesh})
        if (*name) digests += digest_of_file(**name) + '\n';
    if (c.indenter.body && c.indenter.body->mesh)
        digests += digest_of_file(*c.indenter.body->mesh) + '\n';
    return digests;
}

}  // namespace tricontact::runs

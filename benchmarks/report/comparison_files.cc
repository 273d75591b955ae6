#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "benchmarks/report/comparison_output.h"
#include "benchmarks/report/comparison_words.h"

namespace tricontact::benchmarks {

namespace {

constexpr int most_meshes = 8;  // of a submission

std::string field_name(std::size_t k, const std::string& extension) {
    return fmt::format("field_{}{}", k + 1, extension);
}

}  // namespace

std::vector<OutputFile> comparison_files(const Comparison& comparison,
                                         const io::Provenance& provenance) {
    std::vector<OutputFile> files{
        {"comparison.json", comparison_json(provenance.program_version, comparison).dump(2) + '\n'},
        {"comparison.csv", comparison_csv(comparison)},
        {"junit.xml", junit_xml(comparison)}};
    if (const std::string text = case_text(comparison); !text.empty())
        files.push_back({"case.toml", text});
    for (std::size_t k = 0; k < comparison.meshes.size(); ++k) {
        io::VtkFile file = comparison_vtk(comparison, comparison.meshes[k], provenance);
        files.push_back({field_name(k, file.extension), std::move(file.bytes)});
    }
    return files;
}

std::vector<std::string> comparison_file_names() {
    std::vector<std::string> names{"comparison.json", "comparison.csv", "junit.xml", "case.toml",
                                   "report.html"};
    for (std::size_t k = 0; k < most_meshes; ++k)
        for (const char* extension : {".vtp", ".vtu"}) names.push_back(field_name(k, extension));
    return names;
}

}  // namespace tricontact::benchmarks

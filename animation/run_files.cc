#include "animation/run_files.h"

#include <fmt/format.h>
#include <vtkLogger.h>
#include <vtkXMLDataElement.h>
#include <vtkXMLUtilities.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <optional>
#include <sstream>

#include "animation/surface_file.h"
#include "comparisons/quantities/resample.h"
#include "contact/error.h"
#include "io/case/case_reader.h"

namespace tricontact::animation {

namespace {

namespace fs = std::filesystem;
using comparisons::Shot;
using contact::InputError;
using contact::StepRecord;

double number_of(std::string_view text, const std::string& place) {
    double value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size())
        throw InputError(
            fmt::format("{}: \"{}\" is no number; run the case again", place, text.substr(0, 40)));
    return value;
}

std::vector<std::string_view> divided(std::string_view line) {
    std::vector<std::string_view> parts;
    for (std::size_t begin = 0;;) {
        const std::size_t end = line.find(',', begin);
        parts.push_back(line.substr(begin, end - begin));
        if (end == std::string_view::npos) return parts;
        begin = end + 1;
    }
}

/// history.csv, of whose columns a picture needs these.
std::vector<StepRecord> read_steps(const std::string& path) {
    std::istringstream lines(content_of(path));
    std::string line;
    std::getline(lines, line);
    const std::vector<std::string> wanted{"phase",     "offset_x_m", "offset_y_m",
                                          "shift_x_m", "shift_y_m",  "tangential_force_x_N"};
    std::vector<std::size_t> places;
    const auto headings = divided(line);
    for (const std::string& name : wanted) {
        const auto found = std::ranges::find(headings, name);
        if (found == headings.end())
            throw InputError(path + ": has no column " + name + "; run the case again");
        places.push_back(static_cast<std::size_t>(found - headings.begin()));
    }
    const std::size_t n_columns = headings.size();
    std::vector<StepRecord> steps;
    for (int n = 2; std::getline(lines, line); ++n) {
        const auto parts = divided(line);
        const std::string place = fmt::format("{}:{}", path, n);
        if (parts.size() != n_columns)
            throw InputError(place + ": not as many values as columns; run the case again");
        std::vector<double> values;
        for (const std::size_t k : places) values.push_back(number_of(parts[k], place));
        StepRecord& step = steps.emplace_back();
        step.phase = values[0];
        step.offset = {values[1], values[2]};
        step.shift = {values[3], values[4]};
        step.tangential_force = {values[5], 0};
    }
    if (steps.empty()) throw InputError(path + ": has no steps; run the case again");
    return steps;
}

/// Phases and files of a collection, in its order; files stand beside it.
std::vector<std::pair<double, std::string>> read_series(const std::string& path) {
    const std::string text = content_of(path);
    const auto bad = [&] {
        return InputError(path + ": is no collection of VTK's; run the case again");
    };
    vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_OFF);
    const auto* root = vtkXMLUtilities::ReadElementFromString(text.c_str());
    if (!root) throw bad();
    auto& owned = const_cast<vtkXMLDataElement&>(*root);
    std::vector<std::pair<double, std::string>> series;
    if (auto* collection = owned.FindNestedElementWithName("Collection"))
        for (int k = 0; k < collection->GetNumberOfNestedElements(); ++k) {
            vtkXMLDataElement* element = collection->GetNestedElement(k);
            const char *phase = element->GetAttribute("timestep"),
                       *file = element->GetAttribute("file");
            if (phase && file && fs::path(file).filename() == file)
                series.emplace_back(number_of(phase, path), file);
        }
    owned.Delete();
    if (series.empty()) throw bad();
    return series;
}

/// The step nearest to that phase, of equal ones the last.
const StepRecord& step_at(const std::vector<StepRecord>& steps, double phase) {
    return *std::min_element(steps.rbegin(), steps.rend(),
                             [phase](const StepRecord& a, const StepRecord& b) {
                                 return std::abs(a.phase - phase) < std::abs(b.phase - phase);
                             });
}

std::string chosen_model(const contact::Case& c, const std::string& folder,
                         const std::string& model) {
    if (model.empty()) return c.models.back();
    if (std::ranges::find(c.models, model) != c.models.end()) return model;
    throw InputError(
        fmt::format("{}: has no model \"{}\", but {}", folder, model, fmt::join(c.models, ", ")));
}

}  // namespace

RunFiles read_run(const std::string& folder, std::string model) {
    const std::string case_path = folder + "/case.toml";
    if (!fs::is_directory(folder))
        throw InputError(folder + ": is no folder of a run; name what tricontact run wrote into");
    if (!fs::exists(case_path))
        throw InputError(folder +
                         ": has no case.toml: name the folder that tricontact run wrote into");
    RunFiles run{.c = io::read_case(case_path), .model = {}, .shots = {}, .steps = {}};
    run.model = chosen_model(run.c, folder, model);
    const std::string place = folder + '/' + run.model;
    if (!fs::exists(place + "/surface.pvd"))
        throw InputError(place +
                         ": has no surface.pvd: run the case with output.vtk = \"quarters\" or "
                         "\"all\"");
    run.steps = read_steps(place + "/history.csv");
    std::optional<comparisons::Resampling> resampling;
    for (const auto& [phase, file] : read_series(place + "/surface.pvd")) {
        contact::Surface surface = read_surface(place + '/' + file);
        if (surface.layout == contact::Surface::Layout::nodes) {
            if (!resampling) resampling.emplace(surface);
            surface = (*resampling)(surface);
        }
        Shot& shot = run.shots.emplace_back(surface);
        shot.record = step_at(run.steps, phase);
        shot.record.phase = phase;
    }
    return run;
}

}  // namespace tricontact::animation

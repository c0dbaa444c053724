#include "app/measuring/study.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <stdexcept>

#include "app/cli/options/option_text.h"
#include "io/output/atomic_file.h"
#include "processing/adaptive/adaptive_otf.h"

namespace echolucent::cli {

namespace {

Result<void> makeFolder(const std::string& path) {
    std::error_code error;
    std::filesystem::create_directories(path, error);
    if (!error && std::filesystem::is_directory(path)) return {};
    return fail(FailureKind::unwritable, path, "",
                error ? "could not be made a folder: " + error.message() : "is not a folder", "Choose another name.");
}

}  // namespace

void StudyCommand::add(const std::shared_ptr<StudyCommand>& own, CLI::App& study, Action& action) {
    CLI::App& command = *study.add_subcommand(own->m_words.name, own->m_words.meaning);
    own->addOptions(command);
    command.footer("Example: echolucent-cli study " + own->m_words.example);
    command.callback([own, &action] { action = [own] { return own->run(); }; });
}

void StudyCommand::addVolume(CLI::App& command) {
    volume.addTo(command);
    command.get_option("VOLUME")->required(false);
}

void StudyCommand::addFolder(CLI::App& command, const std::string& meaning) {
    const bool isNamed = !folder.empty();
    CLI::Option& option = *command.add_option("-o,--output", folder, meaning)->type_name("DIR")->required(!isNamed);
    if (isNamed) option.capture_default_str();
}

void StudyCommand::addCount(CLI::App& command, const std::string& name, int& value, int least, int most,
                            const std::string& meaning) {
    command.add_option(name, value, meaning)->check(CLI::Range(least, most))->capture_default_str();
}

void StudyCommand::addOtf(CLI::App& command) {
    command
        .add_option("--otf", otf, "linear (eq. 1), parabolic, quartic, manual:FILE or adaptive (for the rendered view)")
        ->type_name("NAME")
        ->capture_default_str();
}

Result<Viewpoint> StudyCommand::viewOf(const Volume& shown) const {
    return view.get(shown, volume.path.empty() ? view.beam() : view.beamOf(shown));
}

OpacityCurve StudyCommand::curveFor(const Volume& shown, const Viewpoint& from) const {
    if (m_curve) return *m_curve;
    const auto adapted = adaptOpacity(shown, from, config);
    sayNote(adapted->message);
    return adapted->curve;
}

std::string StudyCommand::pathOf(const std::string& file) const {
    return (std::filesystem::path(folder) / file).string();
}

Result<void> StudyCommand::run() {
    if (const auto checked = view.get(); !checked) return tl::unexpected<Failure>(checked.error());
    const auto chosen = method.get();
    if (!chosen) return tl::unexpected<Failure>(chosen.error());
    config = *chosen;
    const auto named = namedCurve(otf, method.opacityScale);
    if (!named) return tl::unexpected<Failure>(named.error());
    m_curve = *named;
    const auto scans = phantoms.bases();
    if (!scans) return tl::unexpected<Failure>(scans.error());
    bases = *scans;
    if (auto checked = check(); !checked) return checked;
    const std::vector<std::string> names = files();
    if (!names.empty()) {
        if (auto made = makeFolder(folder); !made) return made;
        for (const std::string& name : names) m_outputs.push_back(pathOf(name));
        if (auto checked = checkOutputs(m_outputs, {otf, method.initial}); !checked) return checked;
    }
    const auto found = measure();
    if (!found) return tl::unexpected<Failure>(found.error());
    for (const auto& [name, contents] : found->files) {
        if (std::ranges::find(names, name) == names.end())
            throw std::invalid_argument("StudyCommand: " + name + " was not announced");
        if (auto done = writeFileAtomically(pathOf(name), contents); !done) return done;
    }
    return found->summary.empty() ? Result<void>{} : writeFileAtomically("-", found->summary);
}

}  // namespace echolucent::cli

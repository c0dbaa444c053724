// The frame of the studies (`echolucent-cli study ...`): shared options, reading and writing.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/cli/command.h"
#include "app/cli/options/method_options.h"
#include "app/cli/options/view_options.h"
#include "app/cli/options/volume_options.h"
#include "app/measuring/study_output.h"
#include "app/measuring/study_phantoms.h"
#include "processing/opacity_curve.h"
#include "processing/result.h"
#include "processing/volume/volume.h"

namespace echolucent::cli {

/// The commands of echolucent-study. echolucent-cli starts them.
void addBenchCommand(CLI::App& program, Action& action);
void addStudyCommand(CLI::App& program, Action& action);

/// Name and help of a study. `example` stands after "echolucent-cli study ".
struct StudyWords {
    std::string name, meaning, example;
};

/// The result of a study.
struct StudyFindings {
    std::vector<std::pair<std::string, std::string>> files;  ///< name and contents
    std::string summary;                                     ///< for the standard output
};

/// The command of a study. A study provides only its own parts. This class does the rest: options that studies share,
/// checks before anything long begins, and files that are written whole or not at all.
class StudyCommand {
public:
    explicit StudyCommand(StudyWords words) : m_words(std::move(words)) {}
    virtual ~StudyCommand() = default;
    StudyCommand(const StudyCommand&) = delete;
    StudyCommand& operator=(const StudyCommand&) = delete;

    /// Adds the command of `own` to `study`. If a person chooses that command, `action` runs the study.
    static void add(const std::shared_ptr<StudyCommand>& own, CLI::App& study, Action& action);

protected:
    virtual void addOptions(CLI::App& command) = 0;
    /// The names of all files that measure() may return.
    [[nodiscard]] virtual std::vector<std::string> files() const { return {}; }
    /// Fails if one of the study's own options is wrong. Runs before the folder is made.
    [[nodiscard]] virtual Result<void> check() { return {}; }
    /// Measures. If measure() returns a file that is not among files(), std::invalid_argument is thrown.
    [[nodiscard]] virtual Result<StudyFindings> measure() = 0;

    /// Adds VOLUME and its options. A person may leave it out.
    void addVolume(CLI::App& command);
    /// Adds -o. A person may leave it out if `folder` names one.
    void addFolder(CLI::App& command, const std::string& meaning);
    /// Adds a whole number from `least` to `most`. The help names its default.
    static void addCount(CLI::App& command, const std::string& name, int& value, int least, int most,
                         const std::string& meaning);
    /// Adds --otf.
    void addOtf(CLI::App& command);

    /// Reads the phase of VOLUME that --phase names. Fails (wrong usage) if an output is one of its files.
    [[nodiscard]] Result<std::shared_ptr<const Volume>> readVolume() const { return volume.readPhase(m_outputs); }
    /// Reads all phases of VOLUME. Fails as readVolume() does.
    [[nodiscard]] Result<Study> readPhases() const { return volume.readAll(m_outputs); }
    /// The view of the options. If no volume was named, the scan is simulated, and its beam is that of the options.
    [[nodiscard]] Result<Viewpoint> viewOf(const Volume& shown) const;
    /// The curve of --otf. If the adaptive curve is only the initial function, stderr says why.
    [[nodiscard]] OpacityCurve curveFor(const Volume& shown, const Viewpoint& from) const;
    [[nodiscard]] std::string pathOf(const std::string& file) const;

    VolumeOptions volume;
    PhantomChoice phantoms;
    ViewOptions view;
    MethodOptions method;
    AdaptiveOtfConfig config;          ///< what `method` gives, from check() on
    std::vector<PhantomConfig> bases;  ///< the phantoms of the options, from check() on; at least one
    std::string otf = "adaptive";
    std::string folder;  ///< the folder for files(); if it is empty before addFolder(), -o is required

private:
    [[nodiscard]] Result<void> run();

    StudyWords m_words;
    std::vector<std::string> m_outputs;
    std::optional<OpacityCurve> m_curve;
};

[[nodiscard]] std::shared_ptr<StudyCommand> otfStudy();
[[nodiscard]] std::shared_ptr<StudyCommand> contrastStudy();
[[nodiscard]] std::shared_ptr<StudyCommand> motionStudy();
[[nodiscard]] std::shared_ptr<StudyCommand> stabilityStudy();
[[nodiscard]] std::shared_ptr<StudyCommand> renderStudy();
[[nodiscard]] std::shared_ptr<StudyCommand> lightStudy();
[[nodiscard]] std::shared_ptr<StudyCommand> quietStudy();
[[nodiscard]] std::shared_ptr<StudyCommand> cutStudy();
[[nodiscard]] std::shared_ptr<StudyCommand> sidesStudy();
[[nodiscard]] std::shared_ptr<StudyCommand> designersStudy();
[[nodiscard]] std::shared_ptr<StudyCommand> aimStudy();
[[nodiscard]] std::shared_ptr<StudyCommand> theoryStudy();

}  // namespace echolucent::cli

// The frame of the studies (`echolucent-cli study ...`): options that many take, what is read, what is written.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/cli/command.h"
#include "app/measuring/study_output.h"
#include "app/measuring/study_phantoms.h"
#include "processing/opacity_curve.h"
#include "processing/result.h"
#include "processing/volume/volume.h"

namespace echolucent::cli {

/// The commands of echolucent-study, which echolucent-cli starts.
void addBenchCommand(CLI::App& program, Action& action);
void addStudyCommand(CLI::App& program, Action& action);

/// What a study is called, and what its help says; `example` stands after "echolucent-cli study ".
struct StudyWords {
    std::string name, meaning, example;
};

/// What a study found, as it leaves it.
struct StudyFindings {
    std::vector<std::pair<std::string, std::string>> files;  ///< name and contents
    std::string summary;                                     ///< for the standard output
};

/// The command of a study. A study states what is its own; this does the rest: options that others take too, checks
/// before anything long begins, files that are written whole or not at all.
class StudyCommand {
public:
    explicit StudyCommand(StudyWords words) : m_words(std::move(words)) {}
    virtual ~StudyCommand() = default;
    StudyCommand(const StudyCommand&) = delete;
    StudyCommand& operator=(const StudyCommand&) = delete;

    /// Adds the study's command to `study`, which sets `action` when it was chosen.
    static void add(const std::shared_ptr<StudyCommand>& own, CLI::App& study, Action& action);

protected:
    virtual void addOptions(CLI::App& command) = 0;
    /// The names of all files that measure() may return.
    [[nodiscard]] virtual std::vector<std::string> files() const { return {}; }
    /// What is wrong with options of its own; asked before the folder is made.
    [[nodiscard]] virtual Result<void> check() { return {}; }
    /// A file that is not among files() is a broken contract (std::invalid_argument).
    [[nodiscard]] virtual Result<StudyFindings> measure() = 0;

    /// Adds VOLUME and its options; it may be left out.
    void addVolume(CLI::App& command);
    /// Adds -o. It may be left out if `folder` names one.
    void addFolder(CLI::App& command, const std::string& meaning);
    /// Adds a whole number from `least` to `most`, whose default the help names.
    static void addCount(CLI::App& command, const std::string& name, int& value, int least, int most,
                         const std::string& meaning);
    /// Adds --otf.
    void addOtf(CLI::App& command);

    /// The volume that was asked for, whose files no output may be.
    [[nodiscard]] Result<std::shared_ptr<const Volume>> readVolume() const { return volume.readPhase(m_outputs); }
    [[nodiscard]] Result<Study> readPhases() const { return volume.readAll(m_outputs); }
    /// The view that the options ask for. If no volume was named, the scan is simulated, and its beam is the options'
    /// own.
    [[nodiscard]] Result<Viewpoint> viewOf(const Volume& shown) const;
    /// The curve of --otf; the adaptive one says on stderr why it is the initial function.
    [[nodiscard]] OpacityCurve curveFor(const Volume& shown, const Viewpoint& from) const;
    [[nodiscard]] std::string pathOf(const std::string& file) const;

    VolumeOptions volume;
    PhantomChoice phantoms;
    ViewOptions view;
    MethodOptions method;
    AdaptiveOtfConfig config;          ///< the method's, from check() on
    std::vector<PhantomConfig> bases;  ///< of the phantoms' options, from check() on; at least one
    std::string otf = "adaptive";
    std::string folder;  ///< of the files; without a name before addFolder(), -o is required

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
[[nodiscard]] std::shared_ptr<StudyCommand> designersStudy();

}  // namespace echolucent::cli

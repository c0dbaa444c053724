// The parts every command of echolucent-cli shares.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "app/cli/options/option_text.h"
#include "app/cli/options/parameter_options.h"
#include "app/cli/options/polar_options.h"
#include "io/study/series_list.h"
#include "io/study/study.h"
#include "processing/adaptive/adaptive_otf_config.h"
#include "processing/document/opening_finds.h"
#include "processing/document/study_reference.h"
#include "processing/result.h"
#include "processing/viewpoint.h"

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace echolucent::cli {

/// Exit statuses: 0 done, 2 wrong usage, 3 an input could not be read, 4 an output could not be written.
[[nodiscard]] int exitStatus(const Failure& failure);

/// What a command does once its options are parsed; a failure becomes one sentence on stderr and an exit status.
using Action = std::function<Result<void>()>;

/// How the program was called.
struct Invocation {
    std::string program;                 ///< name and version
    std::vector<std::string> arguments;  ///< as they were given
};

/// Each adds one subcommand with its options, help and example, and sets `action` when it was chosen.
void addInfoCommand(CLI::App& program, Action& action);
void addFilesCommand(CLI::App& program, Action& action);
void addOtfCommand(CLI::App& program, Action& action, const Invocation& invocation);
void addParametersCommand(CLI::App& program, Action& action);
void addRenderCommand(CLI::App& program, Action& action);
void addCompareCommand(CLI::App& program, Action& action);
void addPhantomCommand(CLI::App& program, Action& action);
void addQuietCommand(CLI::App& program, Action& action);
void addSweepCommand(CLI::App& program, Action& action, const Invocation& invocation);

/// Options of commands that read a volume: VOLUME, --series, --phase, raw layout, --conversion-memory,
/// --frames-as-slices, --all-voxels.
struct VolumeOptions {
    std::string path;
    int phase = 0;
    ReadOptions read;
    std::string series;  ///< UID or number in the list of a folder's series, from 1; empty where it is not given
    std::string rawSize, rawSpacing, rawType, rawByteOrder;
    std::int64_t rawHeaderBytes = 0;
    PolarOptions rawPolar;

    void addTo(CLI::App& command);
    /// Reads the study. Fails (wrong usage) where --phase is out of range, or where one of the `outputs` of the command
    /// is a file of the study: an input is never overwritten.
    [[nodiscard]] Result<Study> readAll(const std::vector<std::string>& outputs) const;
    /// The series of a folder or DICOMDIR; no value for other files, of which --series is wrong usage.
    [[nodiscard]] Result<std::optional<SeriesList>> listedSeries() const;
    /// The series that --series names, else the first. Fails (wrong usage) where there is no such series.
    [[nodiscard]] Result<const SeriesEntry*> chosenSeries(const SeriesList& list) const;
    /// Reads the study as readAll() does, from what listedSeries() has found.
    [[nodiscard]] Result<Study> readListed(const std::optional<SeriesList>& list,
                                           const std::vector<std::string>& outputs) const;
    /// Reads the study as readAll() does, and says what a document names it by.
    struct Named {
        Study study;
        StudyFile reference;
    };
    [[nodiscard]] Result<Named> readNamed(const std::vector<std::string>& outputs) const;
    /// Reads the study as readAll() does, and gives the volume of the phase that --phase names.
    [[nodiscard]] Result<std::shared_ptr<const Volume>> readPhase(const std::vector<std::string>& outputs) const;
};

/// The beam axis of a command, and where it is from.
struct ChosenBeam {
    BeamAxis axis = BeamAxis::plusZ;
    std::string source = "assumed";    ///< "option", "file", "sector shape", "echo" or "assumed"
    std::optional<double> confidence;  ///< [0,1] of a guess; no value if nothing was guessed
    std::string sentence;              ///< of a guess; else it is empty
};

/// What is looked at.
enum class ViewOf {
    file,           ///< a volume that was read; its front is chosen by the option alone
    openedStudy,    ///< the same, with the front found on opening
    simulatedScan,  ///< a scan that the command simulates: beam and front are known, nothing is guessed
};

/// --beam-axis, --view-azimuth, --view-elevation, --near.
struct ViewOptions {
    Viewpoint view;
    std::string beamAxis;  ///< empty: not given
    std::string near;      ///< empty: not given
    /// Adds the options to a command. They must stay where they are from here to get().
    void addTo(CLI::App& command, ViewOf of = ViewOf::file);
    [[nodiscard]] bool nearCutSuggested() const { return near == "auto"; }
    /// The view. It has a cut only if --near says how deep. Fails (wrong usage) if an option is out of range.
    [[nodiscard]] Result<Viewpoint> get() const;
    /// The same for a simulated scan. Fails (wrong usage) if --near is auto.
    [[nodiscard]] Result<Viewpoint> getOfSimulatedScan() const;
    /// What the options say of a study that is opened. An option that is out of range counts as not given.
    [[nodiscard]] SaidOnOpening said() const;
    /// The axis of --beam-axis, else +z: that of simulated scans. An option that is out of range counts as not given.
    [[nodiscard]] ChosenBeam beam() const;
    /// The axis of --beam-axis, else the guess for a volume that was read from a file; +z where that is not sure.
    [[nodiscard]] ChosenBeam beamOf(const Volume& volume) const;
    /// The view of a volume with that beam, the near cut suggested where that was asked for. A sure guess and
    /// a suggestion are said on stderr.
    [[nodiscard]] Result<Viewpoint> get(const Volume& volume, const ChosenBeam& beam) const;
    /// The same with the beam of beamOf().
    [[nodiscard]] Result<Viewpoint> get(const Volume& volume) const;

private:
    /// Whether the command line says how the view is turned, be it by 0 degrees.
    [[nodiscard]] bool isTurned() const;
    const CLI::Option* m_azimuth = nullptr;
    const CLI::Option* m_elevation = nullptr;
    const CLI::Option* m_near = nullptr;
};

/// The view, if its near cut leaves something of the data. Else it fails (wrong usage) and says what --near has to be.
[[nodiscard]] Result<Viewpoint> leavesSomething(const Volume& volume, const Viewpoint& view);

/// The method's options: --reading, --initial, --tube-grid, --without-tube, and one for each row of methodParameters().
/// The reading sets everything; an option overrides it where it stands on the command line.
struct MethodOptions {
    std::string reading = "default";
    std::string initial = "parabolic";
    std::string tubeGrid;
    std::vector<std::int64_t> withoutTubes;  ///< in any order, also twice
    std::optional<double> opacityScale;
    /// Adds the options to a command. They must stay where they are from here to get().
    void addTo(CLI::App& command);
    /// The default reading for a command without these options. Fails (wrong usage) where a value is out of range, or
    /// where an option belongs to a detection or a form that is not chosen.
    [[nodiscard]] Result<AdaptiveOtfConfig> get() const;

private:
    GivenParameters m_given;
    const CLI::Option* m_initialOption = nullptr;
};

/// "NxM" as columns and rows, within the ranges of the table; fails (wrong usage) where it is something else.
[[nodiscard]] Result<TubeGrid> tubeGridFrom(const std::string& text, TubeGrid grid);

/// The grid in which tube cores of these indices are never placed; fails (wrong usage) where it has no such tube core.
[[nodiscard]] Result<TubeGrid> gridWithout(const std::vector<std::int64_t>& tubes, TubeGrid grid);

/// Checks the outputs of a command before it begins: fails (wrong usage) where two of the `outputs` name the same file,
/// and as placeOfOutput() does. The files of manual curves among `curveNames` (names as curveFromName() takes them) are
/// inputs from here on, which no output may be. The files of the volume are checked where it is read
/// (VolumeOptions::readAll()). Empty outputs are left out.
[[nodiscard]] Result<void> checkOutputs(const std::vector<std::string>& outputs,
                                        const std::vector<std::string>& curveNames = {});

/// The FILE of the curve name manual:FILE; empty for every other name.
[[nodiscard]] std::string curveFileOf(const std::string& name);

/// The curve called linear, parabolic, quartic or manual:FILE. Its opacities are multiplied by `opacityScale`; where
/// that is not given, a manual curve stays as it is and the others have the scale that docs/cli.md names.
[[nodiscard]] Result<OpacityCurve> curveFromName(const std::string& name, std::optional<double> opacityScale);
/// The curve of --otf: as curveFromName(), and no curve for "adaptive", which is computed for the rendered view.
[[nodiscard]] Result<std::optional<OpacityCurve>> namedCurve(const std::string& name,
                                                             std::optional<double> opacityScale);

}  // namespace echolucent::cli

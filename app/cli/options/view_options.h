// The options of commands that look at a volume: beam, view, near cut.
#pragma once

#include <optional>
#include <string>

#include "processing/document/opening_finds.h"
#include "processing/result.h"
#include "processing/viewpoint/viewpoint.h"
#include "processing/volume/volume.h"

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace echolucent::cli {

/// The beam axis of a command, with its source.
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
    /// Adds the options to a command. This object must not move until get() is called.
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
    /// The axis of --beam-axis, else the guess for a volume that was read from a file; +z if that is not sure.
    [[nodiscard]] ChosenBeam beamOf(const Volume& volume) const;
    /// The view of a volume with that beam, with a suggested near cut if that was asked for. A sure guess and
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

}  // namespace echolucent::cli

// The options of commands that look at a volume: beam, side, view, near cut.
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
    /// "option", "assumed" or the name of a BeamEvidence. Of a document that was read: the name of a BeamSource.
    std::string source = "assumed";
    std::optional<double> confidence;  ///< [0,1] of a guess; no value if nothing was guessed
    std::string sentence;              ///< what a guess says of itself; empty if nothing was guessed
};

/// What is looked at.
enum class ViewOf {
    file,           ///< a volume that was read; its front is chosen by the option alone
    openedStudy,    ///< a volume that was read; without the option, its front is the one found on opening
    simulatedScan,  ///< a scan that the command simulates: beam and front are known, nothing is guessed
};

/// --beam-axis, --view-azimuth, --view-elevation, --near; of a study that is opened also --side.
struct ViewOptions {
    Viewpoint view;
    std::string beamAxis;  ///< text of --beam-axis; empty if it is not given
    std::string near;      ///< text of --near; empty if it is not given
    std::string side;      ///< text of --side; empty if it is not given
    /// Adds the options to a command. This object must not move until get() is called.
    void addTo(CLI::App& command, ViewOf of = ViewOf::file);
    [[nodiscard]] bool nearCutSuggested() const { return near == "auto"; }
    /// The view. It has a cut only if --near says how deep. Fails (wrong usage) if an option is out of range, or if
    /// --side stands beside a turn of the view.
    [[nodiscard]] Result<Viewpoint> get() const;
    /// get() for a simulated scan. Fails (wrong usage) also if --near is auto.
    [[nodiscard]] Result<Viewpoint> getOfSimulatedScan() const;
    /// What the options say of a study that is opened. A --beam-axis that names no axis counts as not given. The other
    /// options are taken unchecked: get() checks them.
    [[nodiscard]] SaidOnOpening said() const;
    /// The axis of --beam-axis; +z, the axis of simulated scans, if it is not given or names no axis.
    [[nodiscard]] ChosenBeam beam() const;
    /// The axis of --beam-axis, else the guess for a volume that was read from a file; +z if that is not sure.
    [[nodiscard]] ChosenBeam beamOf(const Volume& volume) const;
    /// The view of a volume along `beam`. If the file says where the probe was, and neither --beam-axis nor a turn of
    /// the view is given, it is the view from the probe. If --near is auto, its near cut is the suggested one. Says a
    /// sure guess of the beam and a suggested cut on stderr. Fails as get() and leavesSomething() do.
    [[nodiscard]] Result<Viewpoint> get(const Volume& volume, const ChosenBeam& beam) const;
    /// The view of a volume along the beam of beamOf().
    [[nodiscard]] Result<Viewpoint> get(const Volume& volume) const;

private:
    /// Whether --view-azimuth or --view-elevation is given, even with 0 degrees.
    [[nodiscard]] bool isTurned() const;
    const CLI::Option* m_azimuth = nullptr;
    const CLI::Option* m_elevation = nullptr;
    const CLI::Option* m_near = nullptr;
};

/// The view, if its near cut leaves something of the data. Else it fails (wrong usage) and says what --near has to be.
[[nodiscard]] Result<Viewpoint> leavesSomething(const Volume& volume, const Viewpoint& view);

}  // namespace echolucent::cli

// A study, and the document that shows it. Either a document names the study, or a file is opened and options edit its
// document.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "app/cli/options/view_options.h"
#include "app/cli/options/volume_options.h"
#include "io/study/study.h"
#include "processing/document/document.h"
#include "processing/document/opening_finds.h"

namespace echolucent::cli {

/// --document and --view.
struct DocumentOptions {
    std::string path;         ///< empty: no document was given
    std::optional<int> view;  ///< a pane's number, or the id of a view of version 1; none: the first one
    /// Adds the options to a command that has VOLUME, which may then be left out. `makes` says what the command makes
    /// of a pane ("renders a pane of it").
    void addTo(CLI::App& command, const std::string& makes);
    /// Fails (wrong usage) if neither VOLUME nor a document is given. Beside a document it fails if an option is given
    /// that is not one of `beside`, because its value stands in the document, or one that says how VOLUME is read
    /// without VOLUME.
    [[nodiscard]] Result<void> check(const CLI::App& command, const std::vector<std::string_view>& beside) const;
};

/// A document and the study that it shows.
struct DocumentStudy {
    Document document;
    Study study;
    std::size_t pane = firstPane;         ///< that was asked for
    std::string file{};                   ///< of the document; empty if openStudy() made it
    std::optional<OpeningFinds> finds{};  ///< of openStudy()
    double findingMilliseconds = 0.0;     ///< wall time of finding them
};

/// Reads a document and its study, which it names then as it was found. If `volume` has a path, that is the study. A
/// relative path is looked for from the document's folder, then from the working folder; then its bytes are looked for
/// in the document's folder. The standard error says if it was found so, or if its bytes have changed. Fails if
/// document or study cannot be read, if one of the `outputs` is one of them, or if pane or phase is not there.
[[nodiscard]] Result<DocumentStudy> readDocumentStudy(const std::string& document, const VolumeOptions& volume,
                                                      const std::vector<std::string>& outputs,
                                                      std::optional<int> number);

/// Opens the study of `volume` with the document that the window begins with fresh settings, in a picture of
/// width / height `aspect`. The look is edited, and so is what the options of the view say: the beam, the side from
/// which the scan is looked into and seen, and the front. The phase of `volume` is shown, and its OTF computed. Fails
/// as VolumeOptions::readAll() does, and if a front leaves nothing (leavesSomething()).
[[nodiscard]] Result<DocumentStudy> openStudy(const VolumeOptions& volume, const ViewOptions& view, const Look& look,
                                              const std::vector<std::string>& outputs, double aspect);

/// Where the beam is from: of openStudy() what was found or said, of a document what it says itself.
[[nodiscard]] ChosenBeam beamOf(const DocumentStudy& opened);

/// Whether a pane is rendered with the adaptive OTF, be it as a curve or as a designer.
[[nodiscard]] bool isAdaptive(const Document& document, std::size_t pane);
/// What a pane is rendered with: the name of its designer or of its curve.
[[nodiscard]] std::string otfNameOf(const Document& document, std::size_t pane);

/// The document whose adaptive OTF is computed with a config.
[[nodiscard]] Document withMethod(Document document, const AdaptiveOtfConfig& config);
/// The document that renders its first pane with a curve, which is one of the kinds that documents hold.
[[nodiscard]] Document withCurve(Document document, const OpacityCurve& curve);

}  // namespace echolucent::cli

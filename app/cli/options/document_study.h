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
    std::optional<int> view;  ///< a pane's number, or the id of a view of version 1; no value: the first pane or view
    /// Adds the options to a command that has VOLUME, which may then be left out. `makes` says what the command makes
    /// of a pane ("renders a pane of it").
    void addTo(CLI::App& command, const std::string& makes);
    /// Fails (wrong usage) if neither VOLUME nor a document is given. Beside a document may stand VOLUME, --view and
    /// the options in `beside`, and beside VOLUME also those that say how it is read. Any other option fails (wrong
    /// usage): its value stands in the document. Without a document every option passes.
    [[nodiscard]] Result<void> check(const CLI::App& command, const std::vector<std::string_view>& beside) const;
};

/// A document and the study that it shows.
struct DocumentStudy {
    Document document;
    Study study;
    std::size_t pane = firstPane;         ///< place of the pane that the command is about
    std::string file{};                   ///< path of the document; empty if openStudy() made it
    std::optional<OpeningFinds> finds{};  ///< what openStudy() found; no value if the document was read
    double findingMilliseconds = 0.0;     ///< wall time of the search for `finds`
};

/// The remedy if a volume was given as a document.
constexpr const char* giveVolumeAlone = "Name a session that the window saved, or give the volume without it.";

/// Reads a document and its study. `number` is that of --view. If `volume` has a path, that is the study. Else the
/// document names it: a relative path is looked for from the document's folder, then from the working folder; then a
/// file with the study's bytes is looked for in the document's folder. The document that is returned names the study
/// by the place it was read from. If the document named another place, or if the study's bytes have changed, the
/// standard error says so. Fails (wrong usage, with `remedy`) if there is clearly no document at the path: a folder, or
/// a file that neither calls itself one nor is named so. Fails if document or study cannot be read, if the document
/// names no study, if one of the `outputs` is one of the files read, or if pane or phase is not there.
[[nodiscard]] Result<DocumentStudy> readDocumentStudy(const std::string& document, const VolumeOptions& volume,
                                                      const std::vector<std::string>& outputs,
                                                      std::optional<int> number,
                                                      const std::string& remedy = giveVolumeAlone);

/// Opens the study of `volume`. Its document is the one with which the window begins if its settings are fresh, for a
/// picture of width / height `aspect`. `look` replaces the look. The options of `view` replace what opening found: the
/// beam, the side from which the scan is looked into and seen, and the front. The document shows the phase of `volume`
/// and has its OTF computed of that phase. Fails as ViewOptions::get() and VolumeOptions::readAll() do, if the scan has
/// no side of that name, and if the front leaves nothing (leavesSomething()).
[[nodiscard]] Result<DocumentStudy> openStudy(const VolumeOptions& volume, const ViewOptions& view, const Look& look,
                                              const std::vector<std::string>& outputs, double aspect);

/// The beam of the document and its source. If openStudy() made the document: "option" if --beam-axis was given, else
/// what was guessed. If the document was read: the source that it states.
[[nodiscard]] ChosenBeam beamOf(const DocumentStudy& opened);

/// What a pane is rendered with: the name of its designer or of its curve.
[[nodiscard]] std::string otfNameOf(const Document& document, std::size_t pane);

/// The document with `config` as that of its adaptive OTF. The document's curves hold the initial function.
[[nodiscard]] Document withMethod(Document document, const AdaptiveOtfConfig& config);
/// The document that renders its first pane with a curve, which it holds in its CurveSet. The curve must be no
/// SampledCurve.
[[nodiscard]] Document withCurve(Document document, const OpacityCurve& curve);

}  // namespace echolucent::cli

// The picture of a view of a document on the command line.
#pragma once

#include <array>
#include <optional>
#include <string>

#include "app/cli/command.h"
#include "io/study/study.h"
#include "processing/document/view_picture.h"

namespace echolucent::cli {

/// --document and --view.
struct DocumentOptions {
    std::string path;         ///< empty where no document was given
    std::optional<int> view;  ///< a pane's number, or the id of a view of version 1; none: the first one
    void addTo(CLI::App& command);
    /// Fails (wrong usage) where an option was given whose value stands in the document.
    [[nodiscard]] Result<void> checkAlone(const CLI::App& command) const;
};

/// A document and the study that it shows.
struct DocumentStudy {
    Document document;
    Study study;
    std::size_t pane = firstPane;  ///< that was asked for
};

/// Reads a document, and the study that it names, or `volume` where that has a path. A relative path of the study is
/// one from the document's folder, or else from the working folder; where it is in neither, its bytes are looked for in
/// the document's folder. That it was found so, or that its bytes have changed since the document was saved, is said on
/// stderr. Fails where document or study cannot be read, where `output` is one of the files that are read, and where
/// the document has no pane of the number (readDocumentPane()).
[[nodiscard]] Result<DocumentStudy> readDocumentStudy(const std::string& document, const VolumeOptions& volume,
                                                      const std::string& output, std::optional<int> number);

/// The converged picture of the view, of the study that the document names, or of `volume` where that has a path
/// (readDocumentStudy()). Fails as that does, and if the study has no such phase.
[[nodiscard]] Result<ViewPicture> renderDocument(const DocumentOptions& options, const VolumeOptions& volume,
                                                 const std::array<int, 2>& size, const std::string& output);

}  // namespace echolucent::cli

// What must hold of the real window while it rests.
#pragma once

#include <QString>
#include <string>

#include "app/window/main_window.h"

namespace echolucent {

/// Where two texts differ first.
[[nodiscard]] QString difference(const std::string& one, const std::string& other);
/// A document of the window as bytes, without what is no step: the shown phase and frame, and the checksum, which is
/// known some time after the opening.
[[nodiscard]] std::string bytesOf(MainWindow& window, Document document);
/// The work that is under way, in words.
[[nodiscard]] QString workUnderWay(MainWindow& window);
/// Whether the document is the same once it was written and read. The problem, or an empty text, as below.
[[nodiscard]] QString problemOfReading(const Document& document);
/// Whether the pictures are those of the document, converged.
[[nodiscard]] QString problemOfPictures(MainWindow& window);
/// Whether the panes of a comparison show the OTFs that the document asks for, computed here once more, under their
/// names and in the colours of their curves.
[[nodiscard]] QString problemOfPanes(MainWindow& window);
/// Whether title, menus and panels say what is shown, and every panel has its place.
[[nodiscard]] QString problemOfWords(MainWindow& window);

}  // namespace echolucent

// Changes of any part of a document by chance, as hands, panels and files could make them.
#pragma once

#include <QString>

#include "processing/document/document.h"
#include "processing/volume/volume.h"
#include "tests/app/stress/random_choice.h"

namespace echolucent {

/// What of the open study bounds a change.
struct StudyBounds {
    DataBox box{};
    int phases = 1;
};

struct ChangedDocument {
    Document document;
    QString what;  ///< name of the step: "stress: front"
};

/// The document with another value of one part. problemOf(document) stays empty if it was.
[[nodiscard]] ChangedDocument changedByChance(const Document& document, const StudyBounds& bounds,
                                              RandomChoice& choice);
/// The same, of what panes are rendered with and how they are compared.
[[nodiscard]] ChangedDocument withChangedPanes(const Document& document, const StudyBounds& bounds,
                                               RandomChoice& choice);

}  // namespace echolucent

// Why the picture on the screen looks as it does, in words.
#pragma once

#include <QString>
#include <QStringList>
#include <cstddef>

#include "app/otf/pane_otfs.h"
#include "app/picture/picture_caption.h"
#include "io/study/study.h"
#include "processing/adaptive/adaptive_otf.h"
#include "processing/document/document.h"

namespace echolucent {

struct PictureFacts {
    const Study& study;
    const Volume& volume;
    const AdaptiveOtf* otf;  ///< of the pane's adaptive curve; null until it is computed
    const Document& document;
    ShownSpeckle speckle = ShownSpeckle::asRead;
    /// The design of the pane's designer; null without a designer, and until it is computed.
    const ComputedOtf* design = nullptr;
    bool designIsNewest = true;  ///< false while it is computed again, or if that was cancelled
    std::size_t pane = firstPane;
    QString name{};  ///< of the pane among others; empty if the picture stands alone
};

/// A few plain sentences: what is shown, from where, and which OTF decides what is seen. Then how it was found
/// (interface function, form and reading of the method), what happens to it in a motion, and what is assumed.
[[nodiscard]] QString explainPicture(const PictureFacts& facts);
/// Of these the sentences on the pane alone: which OTF decides what is seen, its equations, and how it was found.
[[nodiscard]] QStringList explainOtf(const PictureFacts& facts);
/// And those that all panes share: from where the scan is seen, its front, the light, and what is assumed.
[[nodiscard]] QStringList explainView(const PictureFacts& facts);

}  // namespace echolucent

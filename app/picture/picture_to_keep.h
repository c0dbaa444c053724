// The 3D view's picture for saving: converged, with the measurements drawn over it.
#pragma once

#include <QImage>
#include <vector>

#include "app/study/open_study.h"
#include "processing/document/document.h"
#include "processing/scene/shown_measurement.h"

namespace echolucent {

class VolumeViewWidget;

/// The measurements that belong to the phase of the view's own volume. While the OTF of another phase is computed, this
/// is not yet the document's phase. While the OTF of another study is computed, the view has no measurements. They are
/// those of shownMeasurementsIn3d().
[[nodiscard]] std::vector<ShownMeasurement> measurementsIn(const VolumeViewWidget& picture, const OpenStudy& openStudy,
                                                           const Document& document);

/// The converged image of the view with the measurements of measurementsIn() over it, as panes draw them. Null if the
/// view was never drawn.
[[nodiscard]] QImage pictureToKeep(VolumeViewWidget& picture, const OpenStudy& openStudy, const Document& document);

}  // namespace echolucent

// The 3D view's picture as it is handed over: converged, with the measurements drawn over it.
#pragma once

#include <QImage>
#include <vector>

#include "app/study/open_study.h"
#include "processing/scene/shown_measurement.h"

namespace echolucent {

class VolumeViewWidget;

/// Those of the measurements that belong to what a view shows: to the phase of its own volume. While the OTF of another
/// phase is computed, that is not yet the phase of the document; while another study's is, none belong to it.
[[nodiscard]] std::vector<ShownMeasurement> measurementsIn(const VolumeViewWidget& picture, const OpenStudy& openStudy,
                                                           const std::vector<Measurement>& measurements);

/// VolumeViewWidget::convergedImage() with measurementsIn() the view, as panes draw them. The image is null where the
/// view was never drawn.
[[nodiscard]] QImage pictureToKeep(VolumeViewWidget& picture, const OpenStudy& openStudy,
                                   const std::vector<Measurement>& measurements);

}  // namespace echolucent

// A comparison as one HTML page that opens without a network.
#pragma once

#include <QImage>
#include <QString>
#include <QStringList>
#include <optional>
#include <string>
#include <vector>

#include "processing/classification.h"
#include "widgets/compare/compare_rows.h"

namespace echolucent {

struct ComparePage {
    QString study;  ///< the study's name as StudyNames shows it
    QString made, version;
    QStringList seen{};     ///< sentences on what all panes share: view, front, light, voxels
    bool coloured = false;  ///< whether pictures are coloured by their shown depths
    struct Pane {
        std::size_t place = 0;  ///< the pane's place in the comparison, from 0
        CompareRow row;
        QImage image;  ///< left out of the page if null
        Classification classification = ManualCurve{};
        std::optional<std::size_t> colour{};  ///< of its curve in the plot: PlotSeries::colour
        QString parameters{};                 ///< of its OTF, in one line; empty if it has none
        QStringList explanation{};            ///< sentences on its OTF
    };
    std::vector<Pane> panes;
};

[[nodiscard]] std::string comparePageText(const ComparePage& page);

}  // namespace echolucent

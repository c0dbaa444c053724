// Which tube core a person looks at, and whether tube cores are shown in the pictures.
#pragma once

#include <QObject>
#include <optional>

#include "app/otf/pane_otfs.h"
#include "app/study/open_study.h"

namespace echolucent {

/// State of the window: no part of the document, and no step. At first no tube core is chosen and none is shown. The
/// choice ends if another study is opened, or if the grid of the scene's adaptive OTF no longer holds its number.
class TubeCoreChoice : public QObject {
    Q_OBJECT

public:
    /// What the parameters refer to must outlive this object.
    TubeCoreChoice(PaneOtfs& otfs, OpenStudy& openStudy, QObject* parent = nullptr);

    /// row * columns + column of the grid, as in TubeGrid::withoutTubes.
    [[nodiscard]] std::optional<int> number() const { return m_number; }
    /// A number that the grid does not hold chooses none.
    void choose(std::optional<int> number);

    [[nodiscard]] bool shown() const { return m_shown; }
    void setShown(bool shown);

signals:
    /// number() is another.
    void chosen();
    void shownChanged(bool shown);

private:
    [[nodiscard]] bool holds(int number) const;

    PaneOtfs& m_otfs;
    std::optional<int> m_number;
    bool m_shown = false;
};

}  // namespace echolucent

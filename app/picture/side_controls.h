// Takes sides: from the strip, the menu and the keys.
#pragma once

#include <QAction>
#include <QObject>
#include <QString>
#include <array>
#include <cstddef>
#include <optional>

#include "app/picture/side_pictures.h"
#include "app/settings/settings.h"
#include "app/study/study_sides.h"
#include "widgets/controls/side_strip.h"
#include "widgets/document/document_model.h"

namespace echolucent {

class VolumeViewWidget;

/// The tip of a side: its name, the key that takes it, and from where one looks. The first side's tip also says why it
/// is first. `place` counts from 0.
[[nodiscard]] QString tipOfSide(const SidesFinding& finding, std::size_t place, const QString& key);

/// Taking a side is one step of the document. When the study is left, the side that a person took is remembered for its
/// kind of scan (kindOfScan()), but not if it is the one that shows most: then a choice that was remembered is
/// forgotten. No side changes by itself.
class SideControls : public QObject {
    Q_OBJECT

public:
    struct Parts {
        DocumentModel& model;
        const OpenStudy& openStudy;
        const StudySides& sides;
        const VolumeViewWidget& picture;
        SideStrip& strip;
        Settings& settings;
        Works& works;
    };
    /// What the parts refer to must outlive this object.
    explicit SideControls(const Parts& parts, QObject* parent = nullptr);

    /// The actions that take sides 1 to 6: room.lookInFrom1 to room.lookInFrom6.
    [[nodiscard]] const std::array<QAction*, SideStrip::count>& actions() const { return m_actions; }
    /// The direction of the side that is taken, or whose front cuts. Without one that of `opened`, the document that
    /// opening gave, if it has the document's beam; else along the beam.
    [[nodiscard]] ViewDirection directionOfSide(const Document& opened) const;
    /// The front that this side has without asking; that of `opened`, if its direction was taken; else none.
    [[nodiscard]] Front frontOfSide(const Document& opened) const;
    /// Remembers the side that was taken of the open study.
    void remember();

signals:
    /// A side is about to be taken.
    void taking();

private:
    void take(std::size_t place);
    [[nodiscard]] std::optional<std::size_t> taken() const;
    [[nodiscard]] std::optional<std::size_t> takenOrCut() const;
    void nameActions();
    void showTaken();

    Parts m_parts;
    std::array<QAction*, SideStrip::count> m_actions{};
    bool m_took = false;  ///< a person took a side of the open study
    SidePictures m_pictures;
};

}  // namespace echolucent

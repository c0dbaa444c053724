// Takes sides: from the strip, the menu and the keys.
#pragma once

#include <QAction>
#include <QObject>
#include <array>
#include <optional>

#include "app/picture/side_pictures.h"
#include "app/settings/settings.h"
#include "app/study/study_sides.h"
#include "widgets/controls/side_strip.h"
#include "widgets/document/document_model.h"

namespace echolucent {

class VolumeViewWidget;

/// Taking a side is one step of the document. The side is remembered for the study's kind of scan (kindOfScan()), but
/// not if it is the one that shows most: then a choice that was remembered is forgotten. No side changes by itself.
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
    /// The place of the side that the tube cores look along, if they look along one.
    [[nodiscard]] std::optional<std::size_t> taken() const;
    /// The direction of the side that is taken; without one, that of `opened`, the document that opening gave.
    [[nodiscard]] ViewDirection directionOfSide(const Document& opened) const;
    /// The front that the side has without asking; without a side, that of `opened`.
    [[nodiscard]] Front frontOfSide(const Document& opened) const;

signals:
    /// A side is about to be taken.
    void taking();

private:
    void take(std::size_t place);
    void remember(std::size_t place);
    void nameActions();
    void showTaken();

    Parts m_parts;
    std::array<QAction*, SideStrip::count> m_actions{};
    SidePictures m_pictures;
};

}  // namespace echolucent

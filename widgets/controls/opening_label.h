// Name and progress of a study that is being opened, over the picture that it replaces.
#pragma once

#include <QString>

#include "widgets/controls/over_picture.h"

class QLabel;
class QProgressBar;

namespace echolucent {

/// Lies in the middle of a picture. It only tells: the mouse and the keys go past it. Objects: opening (this),
/// opening.name, opening.activity, opening.progress. It is hidden at first.
class OpeningLabel : public OverPicture {
    Q_OBJECT

public:
    explicit OpeningLabel(QWidget* parent = nullptr);

    /// Lies over this picture, which is in the same window and outlives the label.
    void lieOver(QWidget& picture) { setPicture(picture); }
    void setName(const QString& name);
    /// What is going on ("loading"). Its share is unknown until setShare().
    void setActivity(const QString& words);
    /// The share that is done, in [0,1].
    void setShare(double share);

protected:
    [[nodiscard]] QRect placeOver(const QRect& picture) const override;
    void paintEvent(QPaintEvent* event) override;

private:
    QString m_whole;  ///< the name, which the label may shorten
    QLabel* m_name;
    QLabel* m_activity;
    QProgressBar* m_progress;
};

}  // namespace echolucent

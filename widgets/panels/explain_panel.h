// What the picture shows, why, and which gestures and keys there are: beside the picture, which it follows.
#pragma once

#include <QWidget>
#include <functional>

#include "widgets/paced_words.h"

class QLabel;

namespace echolucent {

/// Objects: explain (this), explain.picture, explain.keys.
class ExplainPanel : public QWidget {
    Q_OBJECT

public:
    explicit ExplainPanel(QWidget* parent = nullptr);

    /// Asks for the sentences about the picture, paragraphs apart by an empty line. It is asked while the panel is
    /// seen only.
    void setSource(std::function<QString()> explanation);
    /// Something that the sentences tell of has changed.
    void follow();

protected:
    void showEvent(QShowEvent* event) override;

private:
    void tell();

    std::function<QString()> m_explanation;
    QLabel* m_picture;
    PacedWords m_words{[this] { tell(); }};
};

}  // namespace echolucent

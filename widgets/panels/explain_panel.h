// Says beside the picture what it shows and why, and which gestures and keys there are.
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

    /// Sets who gives the sentences about the picture; empty lines separate paragraphs. The panel calls `explanation`
    /// only while it is visible, and at most once more just after.
    void setSource(std::function<QString()> explanation);
    /// Call this if something in the sentences has changed.
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

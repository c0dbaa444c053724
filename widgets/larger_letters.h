// Letters of a part of the window that are larger than those of the application, for people who sit far away.
#pragma once

#include <QFont>
#include <QObject>
#include <QPointer>
#include <QWidget>
#include <vector>

namespace echolucent {

/// How many times as large the letters of a widget are as those of the application.
[[nodiscard]] double lettersOf(const QWidget& widget);
/// A length or a size that suits the letters of the application, as it suits those of a widget; pixels.
[[nodiscard]] int inLettersOf(const QWidget& widget, double length);
[[nodiscard]] QSize inLettersOf(const QWidget& widget, const QSize& size);

/// Makes the letters of a widget larger, and those of all that stands in it or comes into it later. Each of them is
/// told so, because under a style sheet no widget takes over the font of the one around it. What is painted takes its
/// sizes from lettersOf().
class LargerLetters : public QObject {
    Q_OBJECT

public:
    using QObject::QObject;

    /// The letters in `place` become so many times as large as those of the application. All fonts of another place, or
    /// of this one if `times` is 1, are given back. Null: no place.
    void set(QWidget* place, double times);
    /// 1 if there is no place.
    [[nodiscard]] double times() const { return m_times; }

    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    struct Kept {
        QPointer<QWidget> widget;
        QFont font;  ///< before
    };
    void enlarge(QWidget& widget);
    void giveBack();

    QPointer<QWidget> m_place;
    double m_times = 1.0;
    std::vector<Kept> m_kept;
};

}  // namespace echolucent

// A combo box whose words are longer than it is wide.
#pragma once

#include <QComboBox>

namespace echolucent {

/// As narrow as its column. The closed box shows as many whole words of the entry as fit, then "…"; the list is as wide
/// as its entries. currentText() is the whole entry. The wheel changes it only while it has the focus.
class NarrowCombo : public QComboBox {
    Q_OBJECT

public:
    explicit NarrowCombo(QWidget* parent = nullptr);

    /// What the closed box shows.
    [[nodiscard]] QString shownText() const;
    void showPopup() override;

protected:
    void initStyleOption(QStyleOptionComboBox* option) const override;
};

}  // namespace echolucent
